#include <algorithm>
#include <cmath>

#include "simcore/control/controller.h"

namespace simcore::control {
namespace {

// Poles of the speed loop on a point mass [rad/s] (assumed: quick against a 0.1 m/s rover, slow
// against a 10 ms period).
constexpr double kLoopFrequency = 6.0;
// A wheel with less than this share of the mean load counts as lifted (assumed).
constexpr double kLifted = 0.03;
// A torque-driven wheel may run at most this much faster than the command (assumed), and at least
// at this rate [rad/s], so that a rover can be held against a slope.
constexpr double kRateCap = 1.5;
constexpr double kSmallestRateCap = 0.3;
// Gentle speed loop of a lifted wheel, in torque limits per rad/s (assumed).
constexpr double kLiftedGain = 0.1;

class EqualTorqueController final : public Controller {
  public:
    EqualTorqueController(const mechanism::Mechanism& mechanism, const ControllerSettings& settings)
        : wheels_(mechanism.wheels),
          settings_(settings),
          brake_(makeSpeedController(mechanism, {})) {
        // n Mc / R accelerates m: poles at -w0 need Kp = 2 w0 R m / n and Ki = w0^2 R m / n.
        const auto n = static_cast<double>(std::max<std::size_t>(1, wheels_.size()));
        const double radius = wheels_.empty() ? 0.1 : wheels_.front().radius;
        const double unit = radius * mechanism.mass() / n;
        if (settings_.proportional <= 0.0) {
            settings_.proportional = 2.0 * kLoopFrequency * unit;
        }
        if (settings_.integral <= 0.0) {
            settings_.integral = kLoopFrequency * kLoopFrequency * unit;
        }
    }

    void reset() override {
        integral_ = 0.0;
        lastSpeed_ = 0.0;
        started_ = false;
    }

    void update(const Sensors& sensors, const DriveCommand& command,
                std::span<WheelCommand> out) override {
        if (command.brake) {
            reset();
            brake_->update(sensors, command, out);
            return;
        }
        double meanLoad = 0.0;
        for (const WheelSensors& wheel : sensors.wheels) {
            meanLoad += wheel.normalForce / static_cast<double>(sensors.wheels.size());
        }
        const double common = commonTorque(sensors.bodySpeed, command.speed);
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            command_ = command;
            out[i] = share(wheels_[i], sensors.wheels[i], common, meanLoad);
        }
    }

  private:
    /// Mc of paper eq. 4.
    double commonTorque(double speed, double wanted) {
        const double error = wanted - speed;
        const double derivative = started_ ? -(speed - lastSpeed_) / settings_.period : 0.0;
        lastSpeed_ = speed;
        started_ = true;
        double limit = 0.0;
        for (const mechanism::Wheel& wheel : wheels_) {
            limit = std::max(limit, wheel.torqueLimit);
        }
        // Anti-windup: the integral alone never asks for more than the motors have.
        integral_ =
            std::clamp(integral_ + settings_.integral * error * settings_.period, -limit, limit);
        return settings_.proportional * error + integral_ + settings_.derivative * derivative;
    }

    WheelCommand share(const mechanism::Wheel& wheel, const WheelSensors& sensors, double common,
                       double meanLoad) const {
        WheelCommand out;
        const double wantedRate = command_.speed / wheel.radius;
        out.torqueCap = wheel.torqueLimit;
        if (meanLoad <= 0.0 || sensors.normalForce < kLifted * meanLoad) {
            out.speed = wantedRate;
            out.proportional = kLiftedGain * wheel.torqueLimit;
            return out;
        }
        out.mode = WheelMode::Torque;
        out.torque = sensors.normalForce / meanLoad * common;
        out.speed = std::max(kRateCap * std::abs(wantedRate), kSmallestRateCap);
        out.proportional = kLoopProportional * wheel.torqueLimit;
        out.integral = kLoopIntegral * wheel.torqueLimit;
        if (settings_.assumedFriction > 0.0) {
            out.torqueCap = std::min(
                out.torqueCap, settings_.assumedFriction * sensors.normalForce * wheel.radius);
        }
        return out;
    }

    const std::vector<mechanism::Wheel> wheels_;
    ControllerSettings settings_;
    std::unique_ptr<Controller> brake_;
    DriveCommand command_;
    double integral_ = 0.0;
    double lastSpeed_ = 0.0;
    bool started_ = false;
};

}  // namespace

std::unique_ptr<Controller> makeEqualTorqueController(const mechanism::Mechanism& mechanism,
                                                      const ControllerSettings& settings) {
    return std::make_unique<EqualTorqueController>(mechanism, settings);
}

}  // namespace simcore::control
