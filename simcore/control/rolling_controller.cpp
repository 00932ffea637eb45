#include <algorithm>
#include <cmath>

#include "simcore/control/body_speed_loop.h"
#include "simcore/control/controller.h"
#include "simcore/control/heading_hold.h"
#include "simcore/control/rover_estimate.h"
#include "simcore/control/stuck_wheels.h"
#include "simcore/control/wheel_drive.h"
#include "simcore/dynamics/engine.h"
#include "simcore/statics/traction.h"

namespace simcore::control {
namespace {

using project::ControllerKind;

// Wheels are asked for at most this many times v/R: at a vertical wall nothing that rolls without
// slip goes forwards (assumed).
constexpr double kFastest = 2.0;
// Time constant of the rates asked for [s] (assumed).
constexpr double kSmoothing = 0.03;
// P loops towards rolling, in torque limits per rad/s (assumed: mild against a PI loop's 0.5).
constexpr double kMildGain = 0.25;
// Of the hybrid's speed term; 0.05, 0.07, 0.1 and 0.25 were tried on profiles 1 to 12.
constexpr double kHybridGain = 0.07;
// The integral that all wheels have in common, in torque limits per rad (assumed).
constexpr double kCommonIntegral = 2.5;
// Gentle loop of a wheel that hangs, in torque limits per rad/s (assumed).
constexpr double kLiftedGain = 0.1;
// A torque-driven wheel may run at most this much faster than v/R (assumed), and at least at this
// rate [rad/s], so that a rover can be held against a slope.
constexpr double kRateCap = 1.5;
constexpr double kSmallestRateCap = 0.3;
// The friction that is learned from slip: where it begins and what it comes back to, with which
// rate [1/s]; by how much [rad/s] and for how long [s] a wheel runs ahead when it slips, rather
// than comes to an edge; and what it is then set to, over what the wheel gave (all assumed, no
// ground is known).
constexpr double kFirstFriction = 0.6;
constexpr double kFrictionRecovery = 0.1;
constexpr double kSlips = 0.3;
constexpr double kSlipTime = 0.05;
constexpr double kBelowSlip = 0.8;
// What counts as rolling of a wheel that climbs, in times v/R (assumed): at a wall it is no number.
constexpr double kSteepest = 10.0;

class RollingController final : public Controller {
  public:
    RollingController(const mechanism::Mechanism& mechanism, const ControllerSettings& settings)
        : wheels_(mechanism.wheels),
          settings_(settings),
          estimate_(mechanism, settings.period),
          loop_(mechanism, settings),
          heading_(settings.period, mechanism.wheelbase(), TurnedBy::WheelSpeeds),
          stuck_(wheels_.size(), settings.period),
          brake_(makeSpeedController(mechanism, {})),
          rates_(static_cast<Eigen::Index>(wheels_.size())) {
        for (const mechanism::Wheel& wheel : wheels_) {
            mildGains_.push_back(
                loopGain(kHybridGain * wheel.torqueLimit, axleInertia(mechanism, wheel)));
        }
        reset();
    }

    void reset() override {
        estimate_.reset();
        loop_.reset();
        heading_.reset();
        rates_.setZero();
        optimum_.assign(wheels_.size(), 0.0);
        given_.assign(wheels_.size(), 0.0);
        slipping_.assign(wheels_.size(), 0.0);
        looks_.assign(wheels_.size(), {});
        stuck_.reset();
        integral_ = 0.0;
        friction_ = kFirstFriction;
        pace_ = 1.0;
        held_ = false;
    }

    void update(const Sensors& sensors, const DriveCommand& command,
                std::span<WheelCommand> out) override {
        intent_ = &newIntent(wheels_.size());
        if (command.brake) {
            reset();
            brake_->update(sensors, command, out);
            return;
        }
        estimate_.update(sensors);
        planRates(sensors, command);
        switch (settings_.kind) {
            case ControllerKind::Synchronised:
                synchronise(out);
                break;
            case ControllerKind::CommonIntegral:
                shareIntegral(sensors, out);
                break;
            case ControllerKind::Torque:
                watchStall(sensors, command);
                planTorques();
                driveByTorque(sensors, command, out);
                break;
            default:
                watchStall(sensors, command);
                planTorques();
                driveHybrid(sensors, command, out);
                break;
        }
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            if (!estimate_.bears(i)) {
                out[i] = {};
                out[i].torqueCap = wheels_[i].torqueLimit;
                out[i].speed = command.speed / wheels_[i].radius;
                out[i].proportional = kLiftedGain * wheels_[i].torqueLimit;
            }
        }
    }

  private:
    /// Rates at which no wheel slips.
    void planRates(const Sensors& sensors, const DriveCommand& command) {
        const bool holds = settings_.headingHold || settings_.kind == ControllerKind::Hybrid;
        const double turn =
            holds ? heading_.turn(sensors.imu, command.speed, command.turn) : command.turn;
        Eigen::VectorXd asked =
            estimate_.model().rollingRates(estimate_.contacts(), command.speed, turn);
        // Slower, but along the same way: at a wall the rover waits for the wheel that climbs.
        double fastest = 1.0;
        const bool pushes = settings_.kind == ControllerKind::Hybrid;
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            const auto w = static_cast<Eigen::Index>(i);
            const double most = std::min(
                kFastest * std::max(std::abs(command.speed) / wheels_[i].radius, kSmallestRateCap),
                wheels_[i].speedLimit);
            const double steepest = kSteepest * std::abs(command.speed) / wheels_[i].radius;
            looks_[i].rolling = std::clamp(asked[w], -steepest, steepest);
            if (pushes) {
                asked[w] = std::clamp(asked[w], -most, most);
            }
            fastest = std::max(fastest, std::abs(asked[w]) / most);
        }
        const double share = settings_.period / (kSmoothing + settings_.period);
        rates_ += share * (asked / fastest - rates_);
        pace_ += share * (1.0 / fastest - pace_);
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            intent_->wheels[i].rate = rates_[static_cast<Eigen::Index>(i)];
        }
    }

    /// Whether the rover stands though it is to drive, by what was asked for at the last look.
    void watchStall(const Sensors& sensors, const DriveCommand& command) {
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            looks_[i].bears = estimate_.bears(i);
            looks_[i].rate = sensors.wheels[i].rate;
        }
        stuck_.update(command.speed, sensors.bodySpeed, looks_);
        intent_->resting = stuck_.stage() == StuckWheels::Stage::Rests;
    }

    /// What is asked of a wheel, in view of its cap.
    void noteCap(std::size_t i, double wanted, double cap) {
        looks_[i].atCap = std::abs(wanted) >= cap;
        looks_[i].atLimit = std::abs(wanted) >= wheels_[i].torqueLimit && looks_[i].atCap &&
                            cap >= wheels_[i].torqueLimit;
        held_ = held_ && looks_[i].atCap;
    }

    /// Torques of least required friction. Where none are found, the last ones fade.
    void planTorques() {
        const std::vector<statics::Contact>& contacts = estimate_.contacts();
        constexpr double kFade = 0.9;
        statics::Solution solution;
        if (!contacts.empty()) {
            const statics::Traction traction(
                estimate_.model().equilibrium(contacts, statics::ContactSet::All,
                                              dynamics::kGravity),
                estimate_.model().mechanism(), contacts);
            solution = traction.fixedPoint();
            if (solution.way == statics::Way::None) {
                solution = traction.equalTorque();
            }
        }
        if (solution.way != statics::Way::None) {
            intend(contacts, solution);
        }
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            optimum_[i] = solution.way == statics::Way::None
                              ? kFade * optimum_[i]
                              : std::clamp(solution.forces.torque[i], -wheels_[i].torqueLimit,
                                           wheels_[i].torqueLimit);
        }
    }

    void intend(const std::vector<statics::Contact>& contacts, const statics::Solution& solution) {
        intent_->requiredFriction = solution.friction;
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            intent_->wheels[i].torque = solution.forces.torque[i];
            intent_->wheels[i].normalForce = 0.0;
        }
        for (std::size_t c = 0; c < contacts.size(); ++c) {
            intent_->wheels[static_cast<std::size_t>(contacts[c].wheel)].normalForce +=
                solution.forces.normal[c];
        }
    }

    void synchronise(std::span<WheelCommand> out) const {
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            out[i] = rolling(i);
            out[i].proportional = gain(settings_.proportional, kLoopProportional, i);
            out[i].integral = gain(settings_.integral, kLoopIntegral, i);
        }
    }

    void shareIntegral(const Sensors& sensors, std::span<WheelCommand> out) {
        double error = 0.0;
        double limit = 0.0;
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            error += (rates_[static_cast<Eigen::Index>(i)] - sensors.wheels[i].rate) /
                     static_cast<double>(wheels_.size());
            limit = std::max(limit, wheels_[i].torqueLimit);
        }
        integral_ = std::clamp(
            integral_ + gain(settings_.integral, kCommonIntegral, 0) * error * settings_.period,
            -limit, limit);
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            out[i] = rolling(i);
            out[i].proportional = gain(settings_.proportional, kMildGain, i);
            out[i].torque = integral_ * shareOf(i);
        }
    }

    void driveByTorque(const Sensors& sensors, const DriveCommand& command,
                       std::span<WheelCommand> out) {
        const double common = loop_.torque(sensors.bodySpeed, command.speed, held_);
        intent_->commonTorque = common;
        intent_->frictionCap = trusted(settings_.assumedFriction);
        held_ = true;
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            out[i] = {};
            out[i].mode = WheelMode::Torque;
            out[i].torque = optimum_[i] + common * shareOf(i);
            out[i].speed =
                std::max(kRateCap * std::abs(command.speed) / wheels_[i].radius, kSmallestRateCap);
            out[i].proportional = kLoopProportional * wheels_[i].torqueLimit;
            out[i].integral = kLoopIntegral * wheels_[i].torqueLimit;
            out[i].torqueCap =
                tractionCap(sensors, i, stuck_.friction(i, settings_.assumedFriction));
            if (stuck_.stage() != StuckWheels::Stage::Drives) {
                out[i].speed = std::min(out[i].speed, stuck_.creep(i));
            }
            noteCap(i, out[i].torque, out[i].torqueCap);
        }
    }

    void driveHybrid(const Sensors& sensors, const DriveCommand& command,
                     std::span<WheelCommand> out) {
        learnFriction(sensors, command);
        const double common = loop_.torque(sensors.bodySpeed, command.speed, held_);
        intent_->commonTorque = common;
        intent_->frictionCap = trusted(friction_);
        held_ = true;
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            const double cap = tractionCap(sensors, i, stuck_.friction(i, friction_));
            const double wanted = optimum_[i] + common * shareOf(i);
            out[i] = rolling(i);
            out[i].torque = std::clamp(wanted, -cap, cap);
            out[i].proportional = kHybridGain * wheels_[i].torqueLimit;
            noteCap(i, wanted, cap);
            given_[i] = out[i].torque;
            if (stuck_.stage() != StuckWheels::Stage::Drives) {
                creep(sensors, i, cap, out[i]);
            }
        }
    }

    /// The same torque, from a wheel that must not race.
    void creep(const Sensors& sensors, std::size_t i, double cap, WheelCommand& out) const {
        out.mode = WheelMode::Torque;
        out.proportional = kLoopProportional * wheels_[i].torqueLimit;
        out.integral = kLoopIntegral * wheels_[i].torqueLimit;
        if (stuck_.stage() == StuckWheels::Stage::Rests) {
            out.torqueCap = cap;
        } else {
            out.torque += mildGains_[i] * (out.speed - sensors.wheels[i].rate);
        }
        out.speed = stuck_.creep(i);
    }

    /// A wheel that runs ahead of the ground gives what the ground holds, and less is asked then.
    void learnFriction(const Sensors& sensors, const DriveCommand& command) {
        friction_ = std::min(std::max(kFirstFriction, friction_),
                             friction_ + kFrictionRecovery * settings_.period);
        const double asked = pace_ * command.speed;
        const double speed = std::abs(asked) > 1e-6 ? sensors.bodySpeed / asked : 0.0;
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            const double rolls = speed * rates_[static_cast<Eigen::Index>(i)];
            const double ahead =
                std::copysign(1.0, command.speed) * (sensors.wheels[i].rate - rolls);
            const double load = std::min(estimate_.loads()[i], sensors.wheels[i].normalForce);
            slipping_[i] =
                estimate_.bears(i) && ahead > kSlips ? slipping_[i] + settings_.period : 0.0;
            if (slipping_[i] > kSlipTime && load > 0.0) {
                const double torque =
                    given_[i] +
                    mildGains_[i] * (rates_[static_cast<Eigen::Index>(i)] - sensors.wheels[i].rate);
                friction_ =
                    std::min(friction_, kBelowSlip * std::abs(torque) / (wheels_[i].radius * load));
            }
        }
        if (stuck_.stage() != StuckWheels::Stage::Drives) {
            friction_ = StuckWheels::kMostFriction;
        }
    }

    /// The most friction that a wheel is trusted with; no number where no cap is.
    double trusted(double assumed) const {
        double most = 0.0;
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            most = std::max(most, stuck_.friction(i, assumed));
        }
        return most > 0.0 ? most : Intent::kNone;
    }

    WheelCommand rolling(std::size_t i) const {
        WheelCommand command;
        command.speed = rates_[static_cast<Eigen::Index>(i)];
        command.torqueCap = wheels_[i].torqueLimit;
        return command;
    }

    double gain(double set, double share, std::size_t i) const {
        return set > 0.0 ? set : share * wheels_[i].torqueLimit;
    }

    /// N_i / N_mean.
    double shareOf(std::size_t i) const {
        return estimate_.meanLoad() > 0.0 ? estimate_.loads()[i] / estimate_.meanLoad() : 0.0;
    }

    /// What the ground takes when it has this friction; less at once where a wheel unloads.
    double tractionCap(const Sensors& sensors, std::size_t i, double friction) const {
        const double load = std::min(estimate_.loads()[i], sensors.wheels[i].normalForce);
        return friction > 0.0 ? std::min(wheels_[i].torqueLimit,
                                         friction * std::max(0.0, load) * wheels_[i].radius)
                              : wheels_[i].torqueLimit;
    }

    const std::vector<mechanism::Wheel> wheels_;
    const ControllerSettings settings_;
    RoverEstimate estimate_;
    BodySpeedLoop loop_;
    HeadingHold heading_;
    StuckWheels stuck_;
    std::unique_ptr<Controller> brake_;
    Intent* intent_ = nullptr;       ///< of this update
    Eigen::VectorXd rates_;          ///< at which nothing slips [rad/s]
    std::vector<double> optimum_;    ///< of least required friction [N m]
    std::vector<double> given_;      ///< by the model and the PID, in the last period [N m]
    std::vector<double> mildGains_;  ///< what the mild loops give [N m s/rad]
    std::vector<double> slipping_;   ///< for how long each wheel runs ahead [s]
    std::vector<StuckWheels::Wheel> looks_;
    double integral_ = 0.0;  ///< common [N m]
    double friction_ = kFirstFriction;
    double pace_ = 1.0;  ///< of the rover over what is asked, so that no wheel is too fast
    bool held_ = false;  ///< all wheels are at their caps
};

}  // namespace

std::unique_ptr<Controller> makeRollingController(const mechanism::Mechanism& mechanism,
                                                  const ControllerSettings& settings) {
    return std::make_unique<RollingController>(mechanism, settings);
}

}  // namespace simcore::control
