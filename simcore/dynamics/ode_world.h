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

/// Share of a joint's error that is corrected in the next step (docs/engines.md): what a fast
/// swinging link drifts in one step (w^2 r h^2 / 2) would else add up over several.
inline constexpr double kJointErrorReduction = 1.0;

inline Vec3 toVec3(const dReal* v) {
    return {v[0], v[1], v[2]};
}

inline void toOde(dReal* to, const Vec3& from) {
    for (int k = 0; k < 3; ++k) {
        to[k] = from[k];
    }
}

/// Compliance that takes all force out of the normal row of a contact that serves for its friction
/// rows only.
inline constexpr double kNoForce = 1e3;

/// Owns a world and its contact group; joints and bodies die with the world. Each world has a
/// threading implementation of its own: ODE's default one is shared by all worlds, without locks,
/// and worlds that step in two threads at once corrupt it.
class OdeWorld {
  public:
    OdeWorld();
    ~OdeWorld();
    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;

    dWorldID world() const { return world_; }

    dJointGroupID contactGroup() const { return contactGroup_; }

  private:
    dThreadingImplementationID threading_;
    dWorldID world_;
    dJointGroupID contactGroup_;
};

}  // namespace simcore::dynamics
