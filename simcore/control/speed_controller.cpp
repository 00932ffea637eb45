#include "simcore/control/controller.h"

namespace simcore::control {
namespace {

class SpeedController final : public Controller {
  public:
    SpeedController(const mechanism::Mechanism& mechanism, const ControllerSettings& settings)
        : wheels_(mechanism.wheels),
          settings_(settings) {}

    void reset() override {}

    void update(const Sensors& /*sensors*/, const DriveCommand& command,
                std::span<WheelCommand> out) override {
        const double turn = settings_.kind == project::ControllerKind::Manual ? command.turn : 0.0;
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            const mechanism::Wheel& wheel = wheels_[i];
            out[i].torqueCap = wheel.torqueLimit;
            if (command.brake) {
                out[i].mode = WheelMode::Lock;
                continue;
            }
            // Skid steering: a wheel at y moves at v - turn * y.
            out[i].mode = WheelMode::Speed;
            out[i].speed = (command.speed - turn * wheel.center.y()) / wheel.radius;
            const auto gain = [&](double set, double share) {
                return set > 0.0 ? set : share * wheel.torqueLimit;
            };
            out[i].proportional = gain(settings_.proportional, kLoopProportional);
            out[i].integral = gain(settings_.integral, kLoopIntegral);
        }
    }

  private:
    const std::vector<mechanism::Wheel> wheels_;
    ControllerSettings settings_;
};

}  // namespace

std::unique_ptr<Controller> makeSpeedController(const mechanism::Mechanism& mechanism,
                                                const ControllerSettings& settings) {
    return std::make_unique<SpeedController>(mechanism, settings);
}

std::unique_ptr<Controller> makeController(const mechanism::Mechanism& mechanism,
                                           const ControllerSettings& settings) {
    return settings.kind == project::ControllerKind::EqualTorque
               ? makeEqualTorqueController(mechanism, settings)
               : makeSpeedController(mechanism, settings);
}

}  // namespace simcore::control
