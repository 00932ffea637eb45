#pragma once

#include <vector>

#include <ode/ode.h>

#include "simcore/mechanism/mechanism.h"

namespace simcore::dynamics {

/// A gear row between two pins that share a carrier body, as ODE can run it: an auxiliary spider
/// wheel of negligible inertia on the carrier, meshing with both pinned bodies like the bevel gear
/// of a differential. Each mesh is a contact joint whose friction row along the tooth direction is
/// unbounded; ODE's own transmission joint aborts on a carrier that tilts.
class OdeGear {
  public:
    OdeGear(dWorldID world, const mechanism::Mechanism& mechanism, const mechanism::Gear& gear,
            const std::vector<dBodyID>& bodies);

    dBodyID spider() const { return spider_; }

    const Vec3& spiderPosition() const { return center_; }

    /// Adds the two meshes for the next step at the present state of ODE's bodies.
    void addMeshes(dWorldID world, dJointGroupID group, double step) const;

  private:
    struct Mesh {
        dBodyID pinned;
        double spiderArm;  ///< along the pin axis from the spider's axis [m]
        double turnSign;   ///< spider turn for a unit turn of the pinned body
        Vec3 point;        ///< in rover axes at the drawn pose
    };

    dBodyID spider_;
    dBodyID carrier_;
    Vec3 center_;
    Vec3 carrierCom_;
    Vec3 pinAxis_;
    Vec3 spiderAxis_;
    Vec3 tooth_;
    std::vector<Mesh> meshes_;
};

/// The ODE joints of a mechanism as built, made at the drawn pose.
class OdeJoints {
  public:
    OdeJoints(dWorldID world, const mechanism::Mechanism& mechanism,
              const std::vector<dBodyID>& bodies);

    /// The mechanism's bodies, then the auxiliary ones of gears.
    const std::vector<dBodyID>& allBodies() const { return allBodies_; }

    /// Drawn positions of the auxiliary bodies' centres [m].
    const std::vector<Vec3>& auxiliaryPositions() const { return auxiliaryPositions_; }

    /// Joints that ODE needs anew for every step, into the step's group.
    void addStepJoints(dWorldID world, dJointGroupID group, double step) const;

  private:
    std::vector<dBodyID> allBodies_;
    std::vector<Vec3> auxiliaryPositions_;
    std::vector<OdeGear> gears_;
};

}  // namespace simcore::dynamics
