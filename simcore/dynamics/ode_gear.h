#pragma once

#include <vector>

#include <ode/ode.h>

#include "simcore/mechanism/mechanism.h"

namespace simcore::dynamics {

/// The body that both pins of a gear turn against; -1 when there is none.
int carrierOf(const mechanism::Mechanism& mechanism, const mechanism::Gear& gear);

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
    /// Directions and points in rover axes at the drawn pose.
    struct Mesh {
        dBodyID pinned;
        Vec3 pinAxis;
        Vec3 tooth;
        Vec3 point;
        double spiderArm;  ///< of the spider's turn along the tooth [m]
        double turnSign;   ///< spider turn for a unit turn of the pinned body
    };

    dBodyID spider_;
    dBodyID carrier_;
    Vec3 center_;
    Vec3 carrierCom_;
    Vec3 spiderAxis_;
    std::vector<Mesh> meshes_;
};

}  // namespace simcore::dynamics
