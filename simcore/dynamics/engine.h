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
/// force at the joint's point [N] and a torque [N m].
struct JointReaction {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
    /// Whether the loads alone determine it: all of it vanishes in every self-stress. What is not
    /// determined depends on play, stiffness and errors of manufacture; engines give the split that
    /// is least in norm, or what their solver came to.
    bool determined = true;
};

/// Velocity of a body: of its centre of mass [m/s] and angular [rad/s], world.
struct BodyVelocity {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
};

/// How hard the steps were, for a run's report. What an engine has no such thing of stays as it is
/// here.
struct EngineCounters {
    long steps = 0;
    long passes = 0;             ///< solves, >= steps; of the reduced engine: Newton's iterations
    long solverMessages = 0;     ///< solves that failed, after all that the engine does about it
    long fallbacks = 0;          ///< solves that were left to the slower and surer method
    double worstResidual = 0.0;  ///< by which a contact force missed its law [N]
    long dividedSteps = 0;       ///< made of shorter ones, as a loop changed its motion fast
    long choices = 0;            ///< times that the dependent joints were chosen anew
    /// Of the joints that a loop makes dependent, at the worst pose: 1 = well conditioned, 0 =
    /// singular pose.
    double leastPivotRatio = 1.0;
    /// What a user should know, each once.
    std::vector<std::string> warnings;
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
    /// In `numbers`, which keeps its room.
    virtual void writeState(std::vector<double>& numbers) const = 0;
    virtual void restoreState(std::span<const double> state) = 0;

    std::vector<double> saveState() const {
        std::vector<double> numbers;
        writeState(numbers);
        return numbers;
    }

    virtual const EngineCounters& counters() const = 0;

    /// Why the last step is not to be trusted; empty when it is. The run ends there.
    virtual std::string trouble() const { return {}; }
};

/// Makes an engine for a mechanism; how a run is told which engine to use.
using EngineMaker =
    std::function<std::unique_ptr<Engine>(const mechanism::Mechanism&, const EngineSettings&)>;

/// What turns or holds a joint with its dry friction: a motor of rate 0 where there is none.
/// Friction helps to hold; of a servo that turns it takes its share.
/// @param motor  may be null
JointMotor withFriction(const mechanism::Joint& joint, const JointMotor* motor);

/// Rate of mechanism::jointAngle() [rad/s].
double jointRate(const mechanism::Joint& joint, const std::vector<Pose>& poses,
                 const std::vector<BodyVelocity>& velocities);

/// Rate of a wheel against its carrier, about its axis in the world [rad/s], + forward.
double wheelRate(const mechanism::Wheel& wheel, const std::vector<Pose>& poses,
                 const std::vector<BodyVelocity>& velocities);

/// Measures the largest gap between the two bodies of any joint, along the directions it holds.
class LoopErrorMeter {
  public:
    explicit LoopErrorMeter(const mechanism::Mechanism& mechanism,
                            mechanism::Model model = mechanism::Model::Built);

    double measure(const std::vector<Pose>& poses) const;  ///< [m]

  private:
    const mechanism::Mechanism& mechanism_;
    std::vector<std::vector<Vec3>> slides_;  ///< free ones of every joint, its first body's frame
};

/// The same, once [m].
double loopError(const mechanism::Mechanism& mechanism, const std::vector<Pose>& poses,
                 mechanism::Model model = mechanism::Model::Built);

/// What no engine can run in this mechanism; empty when there is nothing.
Problems whyNoEngineCanRun(const mechanism::Mechanism& mechanism);

/// What the engine in reduced coordinates cannot run in this mechanism; empty when it can.
Problems whyReducedCannotRun(const mechanism::Mechanism& mechanism,
                             mechanism::Model joints = mechanism::Model::Built);

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
