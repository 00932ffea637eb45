#pragma once

#include <ode/ode.h>

#include "simcore/base/pose.h"

/// Thin helpers around the C interface of ODE. Only simcore/dynamics includes this.
namespace simcore::dynamics {

/// Makes ODE usable on the calling thread until that thread ends.
/// @throws std::runtime_error when the library was built in single precision
void useOdeOnThisThread();

/// Complaints ("LCP internal error") of ODE on this thread so far.
long odeMessagesOnThisThread();

inline Vec3 toVec3(const dReal* v) {
    return {v[0], v[1], v[2]};
}

/// Owns a world and its contact group; joints and bodies die with the world.
class OdeWorld {
  public:
    OdeWorld();
    ~OdeWorld();
    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;

    dWorldID world() const { return world_; }

    dJointGroupID contactGroup() const { return contactGroup_; }

  private:
    dWorldID world_;
    dJointGroupID contactGroup_;
};

}  // namespace simcore::dynamics
