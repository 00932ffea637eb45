#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "simcore/mechanism/mechanism.h"

/// Steering geometry, seen from above at the drawn pose: which way and how fast every wheel is to
/// roll so that the rover moves as asked. docs/controllers.md has the equations.
namespace simcore::control {

/// Motion of the rover in its own axes: velocity of its origin, and yaw rate.
struct Twist {
    double forward = 0.0;  ///< [m/s]
    double left = 0.0;     ///< [m/s]
    double yaw = 0.0;      ///< [rad/s], + left
};

/// A wheel from above. A steering angle is 0 as drawn, + to the left.
struct WheelPlan {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();    ///< [m]
    Eigen::Vector2d heading = Eigen::Vector2d::UnitX();  ///< unit, where it rolls at angle 0
    double radius = 0.0;
    int steering = -1;  ///< joint index; -1 = none
    /// Where the steering axis meets the ground [m].
    Eigen::Vector2d pivot = Eigen::Vector2d::Zero();
    /// What is to roll without slipping sideways: the mean centre of the wheels of its joint [m].
    Eigen::Vector2d rolling = Eigen::Vector2d::Zero();
    double low = 0.0;                 ///< range of the steering angle, by the joint's stops [rad]
    double high = 0.0;                ///< [rad]
    double jointSign = 1.0;           ///< turn of the joint over the steering angle, +-1
    double steeringSpeedLimit = 0.0;  ///< [rad/s]
};

/// Of every wheel, mechanism order. A joint without stops steers up to half a turn to either side.
std::vector<WheelPlan> wheelPlans(const mechanism::Mechanism& mechanism);

/// The twist with which the wheels that are not steered roll best: no sideways velocity at their
/// mean x, so that the centre of rotation lies on their common axle line if they have one.
Twist rollingTwist(std::span<const WheelPlan> wheels, double speed, double turn);

struct SteeringAngle {
    double angle = 0.0;  ///< [rad], within the stops
    bool exact = true;   ///< false: the wheel slips sideways at its stop
};

/// The angle at which a steered wheel rolls without slipping sideways. Of the two that do, half a
/// turn apart (it then rolls backwards), the one closer to `near`; one that may stand keeps `near`.
SteeringAngle steeringAngle(const WheelPlan& wheel, const Twist& twist, double near);

/// Speed of the wheel's rim along its own heading [m/s] at this steering angle, which changes at
/// this rate: what it does along its heading it rolls, what it does across it slips.
double rollingSpeed(const WheelPlan& wheel, const Twist& twist, double angle,
                    double angleRate = 0.0);

/// The turn, or the largest part of it, for which no wheel slips sideways at a stop [rad/s].
double reachableTurn(std::span<const WheelPlan> wheels, double speed, double turn);

/// Rate at which a steering servo turns its joint from `angle` to `target` [rad/s]: the error is
/// gone after a few kServoTime.
double servoRate(double target, double angle, double speedLimit);

/// [s], assumed: quick against steering at 1 rad/s, and slow against any step of an engine.
inline constexpr double kServoTime = 0.1;

}  // namespace simcore::control
