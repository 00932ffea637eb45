#include "widgets/session/advisor_session.h"

#include <exception>
#include <utility>

#include "simcore/base/text.h"

namespace widgets {

using simcore::mobility::Advice;
using simcore::project::Project;

namespace {

/// Without the relaxed model that the project has.
simcore::project::Rover asBuilt(const Project& project) {
    auto bare = simcore::mobility::withRelaxation(project, {});
    return bare ? std::move(bare->rover) : project.rover;
}

simcore::Result<Advice> searchIn(const Project& project, double seconds,
                                 const std::stop_token& stop) {
    try {
        simcore::mobility::AdvisorOptions options;
        options.seconds = seconds;
        return advise(project, options, stop);
    } catch (const std::exception& error) {
        return simcore::Problems{{simcore::Severity::Critical, simcore::Text::of("the Advisor"),
                                  error.what(),
                                  simcore::Text::of("Check the rover's joints and wheels.")}};
    }
}

}  // namespace

AdvisorSession::AdvisorSession(QObject* parent) : QObject(parent) {}

AdvisorSession::~AdvisorSession() = default;

void AdvisorSession::setProject(const Project& project) {
    project_ = project;
    simcore::project::Rover rover = asBuilt(project);
    if (rover == rover_) {
        emit changed();  // the proposal that is applied may be another
        return;
    }
    rover_ = std::move(rover);
    if (working_) {
        thread_.request_stop();
        ++number_;
        working_ = false;
        interrupted_ = true;
    }
    emit changed();
}

void AdvisorSession::forget() {
    thread_.request_stop();
    ++number_;
    working_ = interrupted_ = false;
    advice_.reset();
    problems_.clear();
    emit changed();
}

void AdvisorSession::start(double seconds) {
    limit_ = seconds;
    searched_ = rover_;
    working_ = true;
    interrupted_ = false;
    advice_.reset();
    problems_.clear();
    since_.start();
    // An earlier search that was told to stop ends within a tenth of a second; this waits for it.
    thread_ = std::jthread(
        [this, number = ++number_, project = project_, seconds](const std::stop_token& stop) {
            auto found =
                std::make_shared<const simcore::Result<Advice>>(searchIn(project, seconds, stop));
            QMetaObject::invokeMethod(
                this, [this, number, found = std::move(found)] { take(number, found); },
                Qt::QueuedConnection);
        });
    emit changed();
}

void AdvisorSession::cancel() {
    thread_.request_stop();
}

void AdvisorSession::take(int number, const Found& found) {
    if (number != number_) {
        return;
    }
    working_ = false;
    if (*found) {
        advice_ = **found;
    } else {
        problems_ = found->problems();
    }
    emit changed();
}

double AdvisorSession::elapsed() const {
    return working_ ? 1e-3 * static_cast<double>(since_.elapsed()) : 0.0;
}

bool AdvisorSession::isStale() const {
    return (advice_ || !problems_.empty()) && !(searched_ == rover_);
}

simcore::Result<Project> AdvisorSession::withProposal(int proposal) const {
    return withRelaxation(project_, advice_->proposals.at(static_cast<std::size_t>(proposal)));
}

int AdvisorSession::appliedProposal() const {
    if (!advice_ || isStale()) {
        return -1;
    }
    for (int i = 0; i < static_cast<int>(advice_->proposals.size()); ++i) {
        const auto applied = withProposal(i);
        if (applied && *applied == project_) {
            return i;
        }
    }
    return -1;
}

}  // namespace widgets
