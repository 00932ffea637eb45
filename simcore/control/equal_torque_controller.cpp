#include <algorithm>
#include <cmath>

#include "simcore/control/body_speed_loop.h"
#include "simcore/control/controller.h"

namespace simcore::control {
namespace {

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
          loop_(mechanism, settings),
          brake_(makeSpeedController(mechanism, {})) {}

    void reset() override { loop_.reset(); }

    void update(const Sensors& sensors, const DriveCommand& command,
                std::span<WheelCommand> out) override {
        Intent& intent = newIntent(wheels_.size());
        if (command.brake) {
            reset();
            brake_->update(sensors, command, out);
            return;
        }
        double meanLoad = 0.0;
        for (const WheelSensors& wheel : sensors.wheels) {
            meanLoad += wheel.normalForce / static_cast<double>(sensors.wheels.size());
        }
        const double common = loop_.torque(sensors.bodySpeed, command.speed);
        intent.commonTorque = common;
        if (settings_.assumedFriction > 0.0) {
            intent.frictionCap = settings_.assumedFriction;
        }
        command_ = command;
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            out[i] = share(wheels_[i], sensors.wheels[i], common, meanLoad);
        }
    }

  private:
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
    const ControllerSettings settings_;
    BodySpeedLoop loop_;
    std::unique_ptr<Controller> brake_;
    DriveCommand command_;
};

}  // namespace

std::unique_ptr<Controller> makeEqualTorqueController(const mechanism::Mechanism& mechanism,
                                                      const ControllerSettings& settings) {
    return std::make_unique<EqualTorqueController>(mechanism, settings);
}

}  // namespace simcore::control
