#include "widgets/session/statics_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace widgets {

using simcore::statics::Contact;
using simcore::statics::TraverseSample;

namespace {

/// Edits that come faster are studied together.
constexpr int kStudyDelay_ms = 60;
/// After this the way so far is shown even where it ends before the place that is looked at.
constexpr int kPatience_ms = 2000;
/// Forces that ask for more are far longer than the picture [-].
constexpr double kMostFrictionDrawn = 10.0;

}  // namespace

StaticsSession::StaticsSession(QObject* parent) : QObject(parent) {
    delay_.setSingleShot(true);
    delay_.setInterval(kStudyDelay_ms);
    connect(&delay_, &QTimer::timeout, this, &StaticsSession::begin);
    worker_ =
        std::make_unique<StaticsWorker>([this](std::shared_ptr<const StaticsFindings> findings) {
            QMetaObject::invokeMethod(
                this, [this, findings = std::move(findings)] { take(findings); },
                Qt::QueuedConnection);
        });
}

StaticsSession::~StaticsSession() = default;

void StaticsSession::setActive(bool active) {
    if (active_ == active) {
        return;
    }
    active_ = active;
    if (!active_) {
        delay_.stop();
        worker_->cancel();
        ++number_;
        pending_ = pending_ || working_;
        working_ = false;
    } else if (pending_) {
        begin();
    }
    emit shownChanged();
}

void StaticsSession::setSubject(const simcore::project::Project& project,
                                const simcore::run::RunRequest& request) {
    if (request == subject_.request && project == subject_.project) {
        return;
    }
    if (request.scenario != subject_.request.scenario) {
        forgetPlace();
    }
    subject_.project = project;
    subject_.request = request;
    pending_ = true;
    if (active_ && !delay_.isActive()) {
        delay_.start();
    }
}

void StaticsSession::forgetPlace() {
    chosen_.reset();
    way_.reset();
    first_.reset();
    place_ = 0;
}

void StaticsSession::begin() {
    pending_ = false;
    working_ = true;
    subject_.number = ++number_;
    subject_.near.reset();
    if (way_ != nullptr) {
        subject_.near = way_->traverse.samples[static_cast<std::size_t>(place_)];
    }
    since_.start();
    worker_->start(subject_);
    emit findingsChanged();
}

void StaticsSession::take(const std::shared_ptr<const StaticsFindings>& findings) {
    if (findings->number != number_) {
        return;
    }
    using Stage = StaticsFindings::Stage;
    if (findings->stage == Stage::Part && !isWorthShowing(*findings)) {
        return;
    }
    failure_.reset();
    if (findings->traverse.samples.empty()) {
        failure_ = findings;
        way_.reset();
        first_.reset();
    } else if (findings->stage == Stage::Look) {
        first_ = findings;
    } else {
        way_ = findings;
        first_.reset();
        choosePlace();
    }
    working_ = findings->stage != Stage::Whole && failure_ == nullptr;
    emit findingsChanged();
    emit shownChanged();
}

bool StaticsSession::isWorthShowing(const StaticsFindings& part) const {
    return way_ == nullptr || way_->number == part.number ||
           part.traverse.samples.back().way >= shown()->way || since_.hasExpired(kPatience_ms);
}

void StaticsSession::choosePlace() {
    if (way_ != nullptr) {
        place_ = chosen_ ? nearestSample(*chosen_) : static_cast<int>(way_->traverse.hardest());
    }
}

const StaticsFindings* StaticsSession::current() const {
    return first_ != nullptr ? first_.get() : way_.get();
}

const TraverseSample* StaticsSession::shown() const {
    if (first_ != nullptr) {
        return &first_->traverse.samples.front();
    }
    return way_ != nullptr ? &way_->traverse.samples[static_cast<std::size_t>(place_)] : nullptr;
}

simcore::run::Snapshot StaticsSession::snapshot() const {
    const TraverseSample& sample = *shown();
    const StaticsFindings& findings = *current();
    simcore::run::Snapshot snapshot;
    snapshot.bodies = sample.pose.bodies;
    snapshot.distance = sample.distance;
    snapshot.centerOfMass = findings.run->mechanism.centerOfMass(sample.pose.bodies);
    snapshot.wheels.resize(sample.study.wheels.size());
    for (const Contact& contact : rollingAlong(sample.pose, findings.rollsBack())) {
        const auto at = static_cast<std::size_t>(contact.wheel);
        const simcore::statics::WheelStudy& study = sample.study.wheels[at];
        simcore::run::WheelState& wheel = snapshot.wheels[at];
        wheel.touching = true;
        wheel.contactPoint = contact.point;
        wheel.contactAngle = study.contactAngle;
        wheel.normalForce = study.normal;
        wheel.tractionForce = study.traction;
        wheel.lateralForce = study.lateral;
        if (sample.study.frictionRequired > kMostFrictionDrawn) {
            continue;
        }
        wheel.force = study.normal * contact.normal + study.traction * contact.forward +
                      study.lateral * contact.normal.cross(contact.forward);
        wheel.torqueApplied = study.torque;
    }
    return snapshot;
}

void StaticsSession::setPlace(int sample) {
    if (way_ == nullptr) {
        return;
    }
    place_ = std::clamp(sample, 0, static_cast<int>(way_->traverse.samples.size()) - 1);
    chosen_ = way_->traverse.samples[static_cast<std::size_t>(place_)].way;
    lookAtPlace();
}

void StaticsSession::setWay(double way) {
    if (way_ != nullptr) {
        setPlace(nearestSample(way));
    }
}

void StaticsSession::goToHardest() {
    chosen_.reset();
    choosePlace();
    lookAtPlace();
}

void StaticsSession::lookAtPlace() {
    if (first_ != nullptr && !delay_.isActive()) {
        // The way is of an earlier design: the place chosen is looked at before it is made anew.
        delay_.start();
    }
    emit shownChanged();
}

int StaticsSession::nearestSample(double way) const {
    const auto& samples = way_->traverse.samples;
    const auto nearest = std::min_element(samples.begin(), samples.end(),
                                          [&](const TraverseSample& a, const TraverseSample& b) {
                                              return std::abs(a.way - way) < std::abs(b.way - way);
                                          });
    return static_cast<int>(nearest - samples.begin());
}

}  // namespace widgets
