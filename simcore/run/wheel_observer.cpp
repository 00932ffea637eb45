#include "simcore/run/wheel_observer.h"

#include <algorithm>
#include <cmath>

#include "simcore/mobility/stance.h"

namespace simcore::run {
namespace {

// Standstill guard of the slip ratio [m/s].
constexpr double kSlowest = 0.01;

}  // namespace

double leastLoad(const mechanism::Mechanism& mechanism) {
    constexpr double kLoadedShare = 0.02;
    const auto wheels = static_cast<double>(std::max<std::size_t>(1, mechanism.wheels.size()));
    return kLoadedShare * mechanism.mass() * dynamics::kGravity / wheels;
}

double frictionPower(const contact::Contact& contact, const Vec3& force, const Vec3& velocity) {
    const Vec3 tangential = force - force.dot(contact.normal) * contact.normal;
    return -tangential.dot(velocity);
}

WheelObserver::WheelObserver(const mechanism::Mechanism& mechanism, double step)
    : mechanism_(mechanism),
      step_(step),
      leastLoad_(leastLoad(mechanism)) {
    reset();
}

void WheelObserver::reset() {
    windowTime_ = 0.0;
    windows_.assign(mechanism_.wheels.size(), {});
    frames_.assign(mechanism_.wheels.size(), {});
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        frames_[i].effectiveRadius = mechanism_.wheels[i].radius;
    }
}

void WheelObserver::observeContact(std::size_t wheel, const Pose& pose,
                                   std::span<const contact::Contact> contacts,
                                   std::span<const Vec3> forces, WheelState& state) {
    const mechanism::Wheel& w = mechanism_.wheels[wheel];
    const Vec3 axis = pose.rotation * w.axis;
    const Vec3 center = pose * w.center;
    Vec3 normalSum = Vec3::Zero();
    Vec3 pointSum = Vec3::Zero();
    Vec3 force = Vec3::Zero();
    double load = 0.0;
    double radiusSum = 0.0;
    double rollingLoad = 0.0;
    double depth = 0.0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (contacts[i].wheel != static_cast<int>(wheel)) {
            continue;
        }
        const double n = std::max(0.0, forces[i].dot(contacts[i].normal));
        const Vec3 arm = contacts[i].point - center;
        normalSum += n * contacts[i].normal;
        pointSum += n * contacts[i].point;
        // What presses on a wheel's side has no say in how it rolls.
        const double rolling = n * axis.cross(contacts[i].normal).norm();
        radiusSum += rolling * (arm - arm.dot(axis) * axis).norm();
        rollingLoad += rolling;
        force += forces[i];
        load += n;
        depth = std::max(depth, contacts[i].depth);
    }
    RollingFrame& frame = frames_[wheel];
    state.touching = load > 0.0 && normalSum.norm() > 1e-9 * load;
    const bool rolls = state.touching && axis.cross(normalSum).norm() > 1e-3 * load;
    state.force = force;
    state.penetration = depth;
    if (state.touching) {
        state.contactPoint = pointSum / load;
    }
    if (rolls) {
        frame.normal = normalSum.normalized();
        frame.effectiveRadius = radiusSum / rollingLoad;
        frame.angle = mobility::contactAngle(frame.normal, axis);
    }
    state.contactAngle = frame.angle;
    const Vec3 tangent = axis.cross(frame.normal).normalized();
    state.normalForce = load;
    state.tractionForce = force.dot(tangent);
    state.lateralForce = force.dot(axis);
}

void WheelObserver::observeMotion(std::size_t wheel, const Pose& before, const Pose& after,
                                  const dynamics::BodyVelocity& velocity, bool countSlip,
                                  WheelState& state) {
    const mechanism::Wheel& w = mechanism_.wheels[wheel];
    const RollingFrame& frame = frames_[wheel];
    const Vec3 axis = before.rotation * w.axis;
    const Vec3 tangent = axis.cross(frame.normal).normalized();
    const Vec3 moved = after * w.center - before * w.center;
    // Absolute turn of the wheel, so that a pitching carrier is not read as slip.
    const Eigen::Quaterniond turned = after.rotation * before.rotation.conjugate();
    const double turn = turnAbout(turned, axis);
    const double slip = moved.dot(tangent) - turn * frame.effectiveRadius;  // paper eq. 5
    state.rate = axis.dot(velocity.angular);
    state.centerSpeed = moved.dot(tangent) / step_;
    const double rim = state.rate * frame.effectiveRadius;
    state.slipRatio = (rim - state.centerSpeed) /
                      std::max({std::abs(rim), std::abs(state.centerSpeed), kSlowest});
    if (countSlip) {
        windows_[wheel].slip += slip;
        windows_[wheel].loaded += state.normalForce > leastLoad_ ? slip : 0.0;
        windows_[wheel].lateral += moved.dot(axis);
    }
}

void WheelObserver::observe(const dynamics::Engine& engine, const std::vector<Pose>& before,
                            std::span<const contact::Contact> contacts, bool countSlip,
                            std::vector<WheelState>& states) {
    for (std::size_t i = 0; i < states.size(); ++i) {
        const auto body = static_cast<std::size_t>(mechanism_.wheels[i].body);
        observeContact(i, before[body], contacts, engine.contactForces(), states[i]);
        observeMotion(i, before[body], engine.poses()[body], engine.velocities()[body], countSlip,
                      states[i]);
    }
    if (countSlip) {
        windowTime_ += step_;
        if (windowTime_ > kSlipWindow - 0.5 * step_) {
            closeWindow(states);
        }
    }
}

void WheelObserver::closeWindow(std::vector<WheelState>& states) {
    for (std::size_t i = 0; i < states.size(); ++i) {
        states[i].slipAbs += std::abs(windows_[i].slip);
        states[i].slipLoaded += std::abs(windows_[i].loaded);
        states[i].slipSigned += windows_[i].slip;
        states[i].slipLateral += std::abs(windows_[i].lateral);
        windows_[i] = {};
    }
    windowTime_ = 0.0;
}

FrictionMeter::FrictionMeter(const mechanism::Mechanism& mechanism, const terrain::Terrain& terrain)
    : leastLoad_(leastLoad(mechanism)),
      obstacles_(terrain.obstacleRange()) {
    constexpr std::size_t kContactRoom = 256;
    used_.reserve(kContactRoom);
}

void FrictionMeter::reset() {
    started_ = false;
    certain_ = {};
    pending_ = {};
}

bool FrictionMeter::onObstacle(std::span<const contact::Contact> contacts) const {
    if (obstacles_.first > obstacles_.second) {
        return true;  // flat ground: the whole run counts
    }
    return std::any_of(contacts.begin(), contacts.end(), [&](const contact::Contact& c) {
        return c.point.x() >= obstacles_.first && c.point.x() <= obstacles_.second;
    });
}

void FrictionMeter::observe(std::span<const contact::Contact> contacts,
                            std::span<const Vec3> forces, std::span<const double> frictions) {
    const bool obstacle = onObstacle(contacts);
    if (!started_ && !obstacle) {
        return;
    }
    started_ = true;
    // A patch is all contacts of one wheel (or body) on one face: the slices' contacts with like
    // normals.
    constexpr double kSameFace = 0.95;  // cosine
    constexpr double kSlack = 0.2;      // [N]
    used_.assign(contacts.size(), false);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (used_[i]) {
            continue;
        }
        double load = 0.0;
        double limit = 0.0;
        Vec3 tangential = Vec3::Zero();
        for (std::size_t k = i; k < contacts.size(); ++k) {
            const Vec3& normal = contacts[k].normal;
            if (used_[k] || !onSamePart(contacts[k], contacts[i]) ||
                normal.dot(contacts[i].normal) < kSameFace) {
                continue;
            }
            used_[k] = true;
            const double n = forces[k].dot(normal);
            load += n;
            limit += frictions[k] * n;
            tangential += forces[k] - n * normal;
        }
        if (load > leastLoad_) {
            ++pending_.patches;
            if (limit > 0.0) {
                pending_.worst =
                    std::max(pending_.worst, (tangential.norm() - kSlack) / limit - 1.0);
            }
            pending_.outside += tangential.norm() > 1.1 * limit + kSlack ? 1 : 0;
        }
    }
    if (obstacle) {
        certain_.patches += pending_.patches;
        certain_.outside += pending_.outside;
        certain_.worst = std::max(certain_.worst, pending_.worst);
        pending_ = {};
    }
}

double FrictionMeter::violationPercent() const {
    return certain_.patches > 0 ? 100.0 * static_cast<double>(certain_.outside) /
                                      static_cast<double>(certain_.patches)
                                : 0.0;
}

double FrictionMeter::worstPercent() const {
    return 100.0 * certain_.worst;
}

}  // namespace simcore::run
