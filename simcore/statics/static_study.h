#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/statics/traction.h"

namespace simcore::statics {

/// A wheel that stands against something.
struct WheelAngle {
    std::string wheel;
    double angle = 0.0;  ///< contact angle [rad], positive: the obstacle is ahead
};

struct StudyRequest {
    Model joints = Model::Built;
    std::optional<ContactSet> contacts;  ///< without one: Free where left and right are alike
    std::vector<WheelAngle> angles;      ///< others stand on level ground
};

struct WheelStudy {
    std::string name;
    double contactAngle = 0.0;                           ///< [rad]
    double normal = 0.0, traction = 0.0, lateral = 0.0;  ///< of the best torques [N]
    double torque = 0.0;                                 ///< [N m]
    double ratio = 0.0;                                  ///< tangential over normal [-]
};

/// What a rover needs to begin to move where it stands.
struct Study {
    int equations = 0;          ///< balances of all bodies
    int internalReactions = 0;  ///< that the motions leave out
    int rows = 0;               ///< of M
    int unknowns = 0;           ///< columns of M
    int dimension = 0;          ///< of the space of solutions
    bool feasible = false;
    std::vector<std::string> flags;     ///< see docs/statics.md
    std::optional<double> equalTorque;  ///< [N m]; nothing when none holds the rover
    double equalMaxRatio = 0.0;         ///< [-]
    double frictionRequired = 0.0;      ///< mu* [-]
    double minimumTorque = 0.0;         ///< largest torque of the best for Objective::Torque
    std::vector<WheelStudy> wheels;
};

/// At the drawn pose. Problems: no such wheel, an angle beyond the upper half of the wheel, a rover
/// that no engine could run, no wheels.
Result<Study> studyDrawnPose(const mechanism::Mechanism& mechanism, const StudyRequest& request);

}  // namespace simcore::statics
