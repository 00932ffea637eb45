#include "simcore/control/controller.h"

namespace simcore::control {
namespace {

// A brake's loop: as stiff as the drive's inertia allows (the drive divides the gains), and back at
// its place within some 5 ms.
constexpr double kBrakeProportional = 1e3;
constexpr double kBrakeIntegral = kBrakeProportional / 0.005;

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
            // Skid steering: a wheel at y moves at v - turn * y.
            const double speed = command.brake ? 0.0 : command.speed - turn * wheel.center.y();
            out[i].mode = WheelMode::Speed;
            out[i].speed = speed / wheel.radius;
            const auto gain = [&](double set, double share, double brakeShare) {
                return command.brake ? brakeShare * wheel.torqueLimit
                       : set > 0.0   ? set
                                     : share * wheel.torqueLimit;
            };
            out[i].proportional =
                gain(settings_.proportional, kLoopProportional, kBrakeProportional);
            out[i].integral = gain(settings_.integral, kLoopIntegral, kBrakeIntegral);
            out[i].torqueCap = wheel.torqueLimit;
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
