#include <algorithm>
#include <cmath>

#include "simcore/control/controller.h"
#include "simcore/control/heading_hold.h"
#include "simcore/control/steering.h"

namespace simcore::control {
namespace {

// A rover nobody drives is parked after this time [s] (assumed).
constexpr double kParkAfter = 0.5;
// Wheels drive at full speed with steering errors up to the first angle, and wait beyond the
// second [rad] (assumed).
constexpr double kAligned = 0.2;
constexpr double kAstray = 0.7;

class SpeedController final : public Controller {
  public:
    SpeedController(const mechanism::Mechanism& mechanism, const ControllerSettings& settings)
        : wheels_(mechanism.wheels),
          settings_(settings),
          plans_(wheelPlans(mechanism)),
          heading_(settings.period, mechanism.wheelbase(), turnedBy()),
          motions_(wheels_.size()) {
        const std::vector<int> encoders = mechanism.encoderJoints();
        for (const WheelPlan& plan : plans_) {
            const auto found = std::find(encoders.begin(), encoders.end(), plan.steering);
            encoderOf_.push_back(found - encoders.begin());
        }
    }

    void reset() override {
        heading_.reset();
        motions_.assign(wheels_.size(), {});
        idle_ = kParkAfter;
    }

    void update(const Sensors& sensors, const DriveCommand& command,
                std::span<WheelCommand> out) override {
        const double turn = settings_.headingHold
                                ? heading_.turn(sensors.imu, command.speed, command.turn)
                                : command.turn;
        const bool asked = command.speed != 0.0 || command.turn != 0.0;
        idle_ = asked ? 0.0 : idle_ + settings_.period;
        const bool parked = settings_.kind == project::ControllerKind::Manual && idle_ > kParkAfter;
        if (!command.brake) {
            plan(sensors, command.speed, turn);
        }
        Intent& intent = newIntent(wheels_.size());
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            out[i].torqueCap = wheels_[i].torqueLimit;
            out[i].steering = plans_[i].jointSign * motions_[i].angle;
            if (command.brake || parked) {
                out[i].mode = WheelMode::Lock;
                continue;
            }
            out[i].mode = WheelMode::Speed;
            out[i].speed = motions_[i].speed / wheels_[i].radius;
            intent.wheels[i].rate = out[i].speed;
            const auto gain = [&](double set, double share) {
                return set > 0.0 ? set : share * wheels_[i].torqueLimit;
            };
            out[i].proportional = gain(settings_.proportional, kLoopProportional);
            out[i].integral = gain(settings_.integral, kLoopIntegral);
        }
    }

  private:
    struct Motion {
        double angle = 0.0;  ///< steering [rad]
        double speed = 0.0;  ///< of the rim [m/s]
    };

    bool steers(const WheelPlan& plan) const {
        return plan.steering >= 0 && settings_.steering != project::SteeringMode::Skid;
    }

    TurnedBy turnedBy() const {
        const bool steering = std::any_of(plans_.begin(), plans_.end(),
                                          [this](const WheelPlan& plan) { return steers(plan); });
        return steering ? TurnedBy::Steering : TurnedBy::WheelSpeeds;
    }

    /// Steering angle now [rad].
    double steered(const Sensors& sensors, std::size_t wheel) const {
        return plans_[wheel].jointSign *
               sensors.joints[static_cast<std::size_t>(encoderOf_[wheel])];
    }

    void plan(const Sensors& sensors, double speed, double turn) {
        if (settings_.steering == project::SteeringMode::Ackermann) {
            turn = reachableTurn(plans_, speed, turn);
        }
        const Twist twist = rollingTwist(plans_, speed, turn);
        double drive = 1.0;
        for (std::size_t i = 0; i < plans_.size(); ++i) {
            if (!steers(plans_[i])) {
                continue;
            }
            motions_[i].angle = steeringAngle(plans_[i], twist, motions_[i].angle).angle;
            const double error = std::abs(motions_[i].angle - steered(sensors, i));
            drive = std::min(drive, (kAstray - error) / (kAstray - kAligned));
        }
        drive = std::max(drive, 0.0);
        const Twist driven{drive * twist.forward, drive * twist.left, drive * twist.yaw};
        double fastest = 1.0;
        for (std::size_t i = 0; i < plans_.size(); ++i) {
            // At the angle of now: a wheel rolls where it points, and as its steering turns it.
            const bool isSteered = plans_[i].steering >= 0;
            const double angle = isSteered ? steered(sensors, i) : 0.0;
            const double rate =
                isSteered ? servoRate(motions_[i].angle, angle, plans_[i].steeringSpeedLimit) : 0.0;
            motions_[i].speed = rollingSpeed(plans_[i], driven, angle, rate);
            fastest = std::max(
                fastest, std::abs(motions_[i].speed) / (wheels_[i].radius * wheels_[i].speedLimit));
        }
        // Slower, but along the same curve.
        for (Motion& motion : motions_) {
            motion.speed /= fastest;
        }
    }

    const std::vector<mechanism::Wheel> wheels_;
    const ControllerSettings settings_;
    const std::vector<WheelPlan> plans_;
    std::vector<std::ptrdiff_t> encoderOf_;
    HeadingHold heading_;
    std::vector<Motion> motions_;
    double idle_ = kParkAfter;  ///< time without a command [s]
};

}  // namespace

std::unique_ptr<Controller> makeSpeedController(const mechanism::Mechanism& mechanism,
                                                const ControllerSettings& settings) {
    return std::make_unique<SpeedController>(mechanism, settings);
}

std::unique_ptr<Controller> makeController(const mechanism::Mechanism& mechanism,
                                           const ControllerSettings& settings) {
    switch (settings.kind) {
        case project::ControllerKind::EqualTorque:
            return makeEqualTorqueController(mechanism, settings);
        case project::ControllerKind::Synchronised:
        case project::ControllerKind::CommonIntegral:
        case project::ControllerKind::Torque:
        case project::ControllerKind::Hybrid:
            return makeRollingController(mechanism, settings);
        case project::ControllerKind::Speed:
        case project::ControllerKind::Manual:
            break;
    }
    return makeSpeedController(mechanism, settings);
}

}  // namespace simcore::control
