#include "simcore/control/steering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace simcore::control {
namespace {

using Eigen::Rotation2Dd;
using Eigen::Vector2d;
using std::numbers::pi;

/// A pivot slower than this may as well stand [m/s].
constexpr double kStill = 1e-6;

double wrapped(double angle) {
    return std::remainder(angle, 2.0 * pi);
}

/// Turned by a quarter to the left: a yaw rate of 1 moves the end of `arm` by this.
Vector2d quarter(const Vector2d& arm) {
    return {-arm.y(), arm.x()};
}

Vector2d velocityAt(const Twist& twist, const Vector2d& point) {
    return Vector2d(twist.forward, twist.left) + twist.yaw * quarter(point);
}

/// Whether the steering joint's second body is on the wheel's side of it.
bool secondCarriesWheel(const mechanism::Mechanism& mechanism, const mechanism::Wheel& wheel) {
    std::vector<bool> reached(mechanism.bodies.size(), false);
    reached[static_cast<std::size_t>(wheel.carrier)] = true;
    for (bool grown = true; grown;) {
        grown = false;
        for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
            const auto first = static_cast<std::size_t>(mechanism.joints[i].first);
            const auto second = static_cast<std::size_t>(mechanism.joints[i].second);
            if (static_cast<int>(i) != wheel.steering && reached[first] != reached[second]) {
                reached[first] = reached[second] = grown = true;
            }
        }
    }
    const auto& joint = mechanism.joints[static_cast<std::size_t>(wheel.steering)];
    return reached[static_cast<std::size_t>(joint.second)];
}

void addSteering(const mechanism::Mechanism& mechanism, const mechanism::Wheel& wheel,
                 WheelPlan& plan) {
    const auto& joint = mechanism.joints[static_cast<std::size_t>(wheel.steering)];
    const double down = (wheel.center.z() - wheel.radius - joint.point.z()) / joint.axis.z();
    plan.steering = wheel.steering;
    plan.pivot = (joint.point + down * joint.axis).head<2>();
    plan.jointSign = (joint.axis.z() > 0.0) == secondCarriesWheel(mechanism, wheel) ? 1.0 : -1.0;
    plan.low = joint.stops ? joint.stops->first : -pi;
    plan.high = joint.stops ? joint.stops->second : pi;
    if (plan.jointSign < 0.0) {
        std::swap(plan.low, plan.high);
        plan.low = -plan.low;
        plan.high = -plan.high;
    }
    plan.steeringSpeedLimit = wheel.steeringSpeedLimit;
    int sharing = 0;
    plan.rolling.setZero();
    for (const mechanism::Wheel& other : mechanism.wheels) {
        if (other.steering == wheel.steering) {
            plan.rolling += other.center.head<2>();
            ++sharing;
        }
    }
    plan.rolling /= sharing;
}

}  // namespace

std::vector<WheelPlan> wheelPlans(const mechanism::Mechanism& mechanism) {
    std::vector<WheelPlan> plans;
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        WheelPlan plan;
        plan.center = plan.rolling = wheel.center.head<2>();
        plan.heading = -quarter(wheel.axis.head<2>().normalized());
        plan.radius = wheel.radius;
        if (wheel.steering >= 0) {
            addSteering(mechanism, wheel, plan);
        }
        plans.push_back(plan);
    }
    return plans;
}

Twist rollingTwist(std::span<const WheelPlan> wheels, double speed, double turn) {
    double x = 0.0;
    int straight = 0;
    for (const WheelPlan& wheel : wheels) {
        if (wheel.steering < 0) {
            x += wheel.center.x();
            ++straight;
        }
    }
    return {speed, straight > 0 ? -turn * x / straight : 0.0, turn};
}

SteeringAngle steeringAngle(const WheelPlan& wheel, const Twist& twist, double near) {
    const Vector2d velocity = velocityAt(twist, wheel.pivot);
    if (velocity.norm() < kStill) {
        return {std::clamp(near, wheel.low, wheel.high), true};
    }
    // With heading d and its left normal n, the wheel at pivot + arm moves across its heading by
    //   v_pivot . n + yaw (d . arm) = |v| sin(course - heading) + yaw trail = 0.
    const double course = std::atan2(velocity.y(), velocity.x());
    const double drawn = std::atan2(wheel.heading.y(), wheel.heading.x());
    const double trail = wheel.heading.dot(wheel.rolling - wheel.pivot);
    const double sine = -twist.yaw * trail / velocity.norm();
    const double lead = std::asin(std::clamp(sine, -1.0, 1.0));
    SteeringAngle best{0.0, false};
    double least = 1e9;
    for (const double angle :
         {wrapped(course - lead - drawn), wrapped(course + lead - drawn + pi)}) {
        const double reachable = std::clamp(angle, wheel.low, wheel.high);
        const bool exact = std::abs(reachable - angle) < 1e-9 && std::abs(sine) <= 1.0;
        // What is out of reach counts for more than any way to turn.
        const double cost = std::abs(reachable - near) + 1e3 * std::abs(reachable - angle);
        if (cost < least) {
            least = cost;
            best = {reachable, exact};
        }
    }
    return best;
}

double rollingSpeed(const WheelPlan& wheel, const Twist& twist, double angle, double angleRate) {
    const Rotation2Dd turned(angle);
    const Vector2d heading = turned * wheel.heading;
    if (wheel.steering < 0) {
        return velocityAt(twist, wheel.center).dot(heading);
    }
    const Vector2d arm = turned * (wheel.center - wheel.pivot);
    return (velocityAt(twist, wheel.pivot + arm) + angleRate * quarter(arm)).dot(heading);
}

double reachableTurn(std::span<const WheelPlan> wheels, double speed, double turn) {
    const auto reachable = [&](double part) {
        const Twist twist = rollingTwist(wheels, speed, part * turn);
        return std::all_of(wheels.begin(), wheels.end(), [&](const WheelPlan& wheel) {
            return wheel.steering < 0 || steeringAngle(wheel, twist, 0.0).exact;
        });
    };
    if (reachable(1.0)) {
        return turn;
    }
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (low + high);
        (reachable(middle) ? low : high) = middle;
    }
    return low * turn;
}

double servoRate(double target, double angle, double speedLimit) {
    return std::clamp((target - angle) / kServoTime, -speedLimit, speedLimit);
}

}  // namespace simcore::control
