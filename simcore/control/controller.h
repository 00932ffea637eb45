#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "simcore/control/sensors.h"
#include "simcore/mechanism/mechanism.h"
#include "simcore/project/project.h"

/// Controllers: sensors in, a command per wheel out, at a fixed period. None of them knows the
/// ground's friction; caps use the controller's own assumed value.
namespace simcore::control {

/// What is asked of the rover now.
struct DriveCommand {
    double speed = 0.0;  ///< [m/s], + forward
    double turn = 0.0;   ///< yaw rate [rad/s], + left; EqualTorque does not turn
    /// Standing still on purpose (settling): hold the wheels.
    bool brake = false;
};

enum class WheelMode {
    Speed,   ///< the loop drives the wheel at `speed`, with `torque` on top of what it asks for
    Torque,  ///< the wheel gets `torque`; the loop takes over where its rate would pass `speed`
    Lock,    ///< the brake holds the wheel on its carrier, up to the torque limit
};

/// For one wheel: what its drive does at every engine step, until the next command.
struct WheelCommand {
    WheelMode mode = WheelMode::Speed;
    double torque = 0.0;        ///< Torque: wanted; Speed: fed forward [N m]
    double speed = 0.0;         ///< Speed: set-point; Torque: highest |rate| driven to [rad/s]
    double proportional = 0.0;  ///< of the loop [N m s/rad]
    double integral = 0.0;      ///< of the loop [N m/rad]
    double torqueCap = 0.0;     ///< |torque| stays below [N m]
    double steering = 0.0;      ///< turn of the steering joint to take up [rad]
};

/// Gains of a wheel's loop: full torque at 2 rad/s of error, and after 0.2 rad of accumulated error
/// (assumed: the stiffness of a small geared drive), in torque limits.
inline constexpr double kLoopProportional = 0.5;
inline constexpr double kLoopIntegral = 5.0;

/// What a controller had in mind at its last look, for those who watch it: NaN where it thinks of
/// no such thing.
struct Intent {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    struct Wheel {
        double torque = kNone;       ///< of least required friction, by the rover's model [N m]
        double normalForce = kNone;  ///< what those torques make of the load [N]
        double rate = kNone;         ///< that is wanted of the wheel [rad/s]
    };

    double commonTorque = kNone;      ///< Mc, of the loop on the body's speed [N m]
    double requiredFriction = kNone;  ///< by the rover's model [-]
    double frictionCap = kNone;       ///< friction that the ground is trusted with [-]
    bool resting = false;             ///< stuck: wheels gave all that the ground takes, in vain
    std::vector<Wheel> wheels;        ///< mechanism order
};

struct ControllerSettings {
    project::ControllerKind kind = project::ControllerKind::Speed;
    double assumedFriction = 0.5;
    double period = 0.01;                                          ///< [s]
    project::SteeringMode steering = project::SteeringMode::Auto;  ///< Speed, Manual
    bool headingHold = false;                                      ///< Speed, Manual
    /// 0 = derived from the rover, see each controller.
    double proportional = 0.0;
    double integral = 0.0;
    double derivative = 0.0;
};

class Controller {
  public:
    virtual ~Controller() = default;
    virtual void reset() = 0;
    /// Called once per period; writes one command per wheel.
    virtual void update(const Sensors& sensors, const DriveCommand& command,
                        std::span<WheelCommand> wheels) = 0;

    /// Of the last update(). Empty before the first.
    const Intent& intent() const { return intent_; }

  protected:
    /// For update() to fill: nothing is in mind for this many wheels.
    Intent& newIntent(std::size_t wheels) {
        intent_.resting = false;
        intent_.commonTorque = intent_.requiredFriction = intent_.frictionCap = Intent::kNone;
        intent_.wheels.assign(wheels, {});
        return intent_;
    }

  private:
    Intent intent_;
};

/// Every wheel rolls as the rover's speed and turn want it (steering.h), by a PI loop per wheel;
/// Manual parks a rover that nobody drives. Default gains kLoopProportional and kLoopIntegral; see
/// docs/controllers.md.
std::unique_ptr<Controller> makeSpeedController(const mechanism::Mechanism& mechanism,
                                                const ControllerSettings& settings);

/// One PID on the body's speed; its torque is shared as N_i / N_mean (Lamon et al. 2004, eq. 4),
/// capped at assumed_mu N_i R and held at 1.5 times the commanded wheel speed; a wheel in the air
/// follows the commanded speed gently instead. Default gains from a point mass: poles at -6/s
/// (assumed).
std::unique_ptr<Controller> makeEqualTorqueController(const mechanism::Mechanism& mechanism,
                                                      const ControllerSettings& settings);

/// Controllers that know the rover's mechanism, its pose and where its wheels touch; see
/// docs/controllers.md:
///
/// - Synchronised: every wheel at the rate at which nothing slips, by a PI loop per wheel;
/// - CommonIntegral: the same rates by P loops, and one integral for all, shared as N_i / N_mean;
/// - Torque: the torques of least required friction, and a PID on the body's speed, shared as
///   N_i / N_mean (Lamon et al. 2004, Figs. 2, 3 and eq. 4);
/// - Hybrid: those torques below a friction that is learned from slip, and a mild P loop on the
///   rates at which nothing slips.
std::unique_ptr<Controller> makeRollingController(const mechanism::Mechanism& mechanism,
                                                  const ControllerSettings& settings);

std::unique_ptr<Controller> makeController(const mechanism::Mechanism& mechanism,
                                           const ControllerSettings& settings);

}  // namespace simcore::control
