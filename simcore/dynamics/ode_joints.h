#pragma once

#include <array>
#include <deque>
#include <span>
#include <vector>

#include <ode/ode.h>

#include "simcore/dynamics/engine.h"
#include "simcore/dynamics/ode_gear.h"
#include "simcore/mechanism/mechanism.h"

namespace simcore::dynamics {

/// What ODE's joints are told before every solve.
struct OdeSolve {
    dWorldID world;
    dJointGroupID group;  ///< of what lives for this solve only
    double step;          ///< [s]
    const mechanism::Mechanism& mechanism;
    const std::vector<Pose>& poses;  ///< X_WB at the start of the step
};

/// One joint of a mechanism: any set of free turns and slides.
///
/// Pins, balls, universal, sliding and cylindrical joints are ODE's own. Other sets are put
/// together from rows that ODE has elsewhere: translations are held by the two friction rows, made
/// unbounded, of a contact whose normal points along a free slide; rotations by a motor with
/// unlimited torque that is told to undo the error. All such rows are as exact as ODE's joints.
class OdeJoint {
  public:
    OdeJoint(dWorldID world, const mechanism::Joint& joint,
             const std::vector<mechanism::Freedom>& freedoms, dBodyID first, dBodyID second);
    OdeJoint(const OdeJoint&) = delete;
    OdeJoint& operator=(const OdeJoint&) = delete;

    /// @param motor  null when the joint is not driven
    void prepare(const OdeSolve& solve, const JointMotor* motor);
    JointReaction reaction(const OdeSolve& solve) const;

  private:
    struct Part {
        dJointID id = nullptr;
        dJointFeedback feedback{};
    };

    dJointID add(Part& part, dJointID id);
    void holdTranslations(const OdeSolve& solve);
    void holdRotations(const OdeSolve& solve);
    void setStopsAndMotor(const OdeSolve& solve, const JointMotor* motor);

    const mechanism::Joint& joint_;
    dBodyID first_;
    dBodyID second_;
    bool isPin_ = false;
    bool native_ = false;
    std::vector<Vec3> turns_;
    std::vector<Vec3> heldSlides_;
    Vec3 freeSlide_ = Vec3::Zero();
    Part main_;       ///< ODE's own joint, or the ball or contact that holds translations
    Part rotations_;  ///< motor that holds rotations
    Part axis_;       ///< motor about the joint's axis, for stops and drives of what is no pin
    double pinSign_ = 1.0;
};

/// The ODE joints and gears of a mechanism, made at the drawn pose.
class OdeJoints {
  public:
    OdeJoints(dWorldID world, const mechanism::Mechanism& mechanism, mechanism::Model model,
              const std::vector<dBodyID>& bodies);

    /// The mechanism's bodies, then the auxiliary ones of gears.
    const std::vector<dBodyID>& allBodies() const { return allBodies_; }

    /// Drawn positions of the auxiliary bodies' centres [m].
    const std::vector<Vec3>& auxiliaryPositions() const { return auxiliaryPositions_; }

    void prepare(const OdeSolve& solve, std::span<const JointMotor> motors);
    void readReactions(const OdeSolve& solve, std::vector<JointReaction>& reactions) const;

  private:
    std::deque<OdeJoint> joints_;  // ODE keeps pointers into them
    std::vector<dBodyID> allBodies_;
    std::vector<Vec3> auxiliaryPositions_;
    std::vector<OdeGear> gears_;
    std::vector<const JointMotor*> motorOf_;
};

}  // namespace simcore::dynamics
