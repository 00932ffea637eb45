#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "simcore/base/problem.h"
#include "simcore/contact/wheel_contact.h"
#include "simcore/mechanism/freedoms.h"

/// Rigid-body engines behind one port. An engine advances a resolved mechanism under given wheel
/// torques and contacts; contact search, motors, controllers and measures live outside it.
namespace simcore::dynamics {

/// Standard engineering value used by the reference data [m/s^2].
inline constexpr double kGravity = 9.81;

struct EngineSettings {
    double step = 0.002;        ///< [s]
    double gravity = kGravity;  ///< along -z [m/s^2]
    mechanism::Model joints = mechanism::Model::Built;
};

/// A joint that is turned at a given rate about its axis, as far as a torque limit allows: a
/// steering servo, or (rate 0) a locked wheel.
struct JointMotor {
    int joint = -1;            ///< mechanism joint index
    double rate = 0.0;         ///< second body against first [rad/s]
    double torqueLimit = 0.0;  ///< [N m]
};

/// What acts on the mechanism during one step. Spans are as long as the mechanism's wheels.
struct StepInput {
    /// About each wheel's axis, equal and opposite on wheel and carrier [N m], + drives forward.
    std::span<const double> wheelTorques;
    /// About each wheel's axis, on the wheel alone (rolling resistance) [N m].
    std::span<const double> externalTorques;
    /// Where the wheels touch at the start of the step.
    std::span<const contact::Contact> contacts;
    /// Coulomb coefficient of each contact [-]; as long as `contacts`.
    std::span<const double> frictions;
    /// At most one a joint. A wheel with a motor on its axle gets its torque as well.
    std::span<const JointMotor> motors = {};
};

/// What the first body of a joint does to the second, motors and stops included, in the world: a
/// force at the joint's point [N] and a torque [N m]. In a hyperstatic mechanism only the parts
/// that the loads determine mean anything.
struct JointReaction {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
};

/// Velocity of a body: of its centre of mass [m/s] and angular [rad/s], world.
struct BodyVelocity {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};

/// Counters of how hard the steps were, for a run's report.
struct EngineCounters {
    long steps = 0;
    long passes = 0;          ///< solves, >= steps
    long solverMessages = 0;  ///< solves that failed, after all that the engine does about it
};

/// A mechanism in motion. Not thread safe: made, stepped and destroyed by one thread.
class Engine {
  public:
    virtual ~Engine() = default;

    virtual std::string name() const = 0;

    /// How far before they touch this engine wants to know of contacts [m].
    virtual double contactMargin() const { return 0.0; }

    /// Back to the drawn pose at the world's origin, at rest.
    virtual void reset() = 0;
    virtual void step(const StepInput& input) = 0;

    /// X_WB of every body, mechanism order.
    virtual const std::vector<Pose>& poses() const = 0;
    virtual const std::vector<BodyVelocity>& velocities() const = 0;
    /// Force of the ground on the wheel [N], world, per contact of the last step's input.
    virtual const std::vector<Vec3>& contactForces() const = 0;
    /// Of every joint in the last step, mechanism order. Empty before the first step.
    virtual const std::vector<JointReaction>& jointReactions() const = 0;

    /// Everything the next step depends on, as numbers: restoring it continues bit for bit.
    virtual std::vector<double> saveState() const = 0;
    virtual void restoreState(std::span<const double> state) = 0;

    virtual const EngineCounters& counters() const = 0;
};

/// Makes an engine for a mechanism; how a run is told which engine to use.
using EngineMaker =
    std::function<std::unique_ptr<Engine>(const mechanism::Mechanism&, const EngineSettings&)>;

/// Rate of mechanism::jointAngle() [rad/s].
double jointRate(const mechanism::Joint& joint, const std::vector<Pose>& poses,
                 const std::vector<BodyVelocity>& velocities);

/// Rate of a wheel against its carrier, about its axis in the world [rad/s], + forward.
double wheelRate(const mechanism::Wheel& wheel, const std::vector<Pose>& poses,
                 const std::vector<BodyVelocity>& velocities);

/// Largest gap between the two bodies of any joint, along the directions it holds [m].
double loopError(const mechanism::Mechanism& mechanism, const std::vector<Pose>& poses,
                 mechanism::Model model = mechanism::Model::Built);

/// What the engine in reduced coordinates cannot run in this mechanism; empty when it can.
Problems whyReducedCannotRun(const mechanism::Mechanism& mechanism);

/// Independent rates instead of constraints, and Coulomb's cone (docs/engines.md).
/// @throws std::invalid_argument when whyReducedCannotRun() is not empty
std::unique_ptr<Engine> makeReducedEngine(const mechanism::Mechanism& mechanism,
                                          const EngineSettings& settings);

/// What the ODE engine cannot run in this mechanism; empty when it can.
Problems whyOdeCannotRun(const mechanism::Mechanism& mechanism);

/// The Open Dynamics Engine.
/// @throws std::invalid_argument when whyOdeCannotRun() is not empty
std::unique_ptr<Engine> makeOdeEngine(const mechanism::Mechanism& mechanism,
                                      const EngineSettings& settings);

}  // namespace simcore::dynamics
