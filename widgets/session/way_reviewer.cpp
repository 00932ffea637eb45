#include "widgets/session/way_reviewer.h"

#include <exception>

namespace widgets {

using simcore::review::Finding;

namespace {

/// Somebody who types or drags is left alone.
constexpr int kDelay_ms = 800;

}  // namespace

WayReviewer::WayReviewer(QObject* parent) : QObject(parent) {
    delay_.setSingleShot(true);
    delay_.setInterval(kDelay_ms);
    connect(&delay_, &QTimer::timeout, this, &WayReviewer::begin);
}

WayReviewer::~WayReviewer() {
    stop();
}

void WayReviewer::setActive(bool active) {
    if (active_ == active) {
        return;
    }
    active_ = active;
    if (!active_) {
        stop();
    } else if (!known_) {
        delay_.start();
    }
}

void WayReviewer::setSubject(const simcore::project::Project& project,
                             const simcore::project::ProjectFiles& files) {
    stop();
    project_ = project;
    files_ = files;
    known_ = false;
    if (!findings_.empty()) {
        findings_.clear();
        emit findingsChanged();
    }
    if (active_) {
        delay_.start();
    }
}

void WayReviewer::begin() {
    stop();
    working_ = true;
    givenUp_ = std::make_shared<std::atomic<bool>>(false);
    thread_ = std::thread(
        [this, number = number_, project = project_, files = files_, givenUp = givenUp_] {
            std::vector<Finding> findings;
            for (const auto& scenario : project.scenarios) {
                try {
                    auto more = simcore::review::reviewWay(project, scenario.name, files,
                                                           [&] { return !*givenUp; });
                    findings.insert(findings.end(), more.begin(), more.end());
                } catch (const std::exception&) {
                    // What cannot be studied is told by the run that cannot start.
                }
                if (*givenUp) {
                    return;
                }
            }
            // The thread is joined before this goes.
            QMetaObject::invokeMethod(
                this, [this, number, findings = std::move(findings)] { take(number, findings); });
        });
}

void WayReviewer::stop() {
    delay_.stop();
    ++number_;
    working_ = false;
    if (thread_.joinable()) {
        *givenUp_ = true;  // heard at the next sample of the way, some ms
        thread_.join();
    }
}

void WayReviewer::take(int number, std::vector<Finding> findings) {
    if (number != number_) {
        return;
    }
    working_ = false;
    known_ = true;
    const bool any = !findings_.empty() || !findings.empty();
    findings_ = std::move(findings);
    if (any) {
        emit findingsChanged();
    }
}

}  // namespace widgets
