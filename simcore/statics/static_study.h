#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/statics/pose_solver.h"
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
    bool touches = true;
    double contactAngle = 0.0;                           ///< [rad]
    double normal = 0.0, traction = 0.0, lateral = 0.0;  ///< of the best torques [N]
    double torque = 0.0;                                 ///< [N m]
    double ratio = 0.0;                                  ///< tangential over normal [-]
    double equalNormal = 0.0, equalRatio = 0.0;          ///< of equal torques [N], [-]
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
    double leastSquares = 0.0;       ///< least sum of squared torques (Objective::Energy) [N^2 m^2]
    double leastSquaresRatio = 0.0;  ///< friction that those torques ask for [-]
    double tipOver = 0.0;            ///< least angle to tip over a side of the footholds [rad]
    double rollingConflict = 0.0;    ///< slip that the joints force, per way of the chassis [-]
    std::vector<WheelStudy> wheels;  ///< all, in the order of the mechanism
};

/// At the drawn pose. Problems: no such wheel, an angle beyond the upper half of the wheel, a rover
/// that no engine could run, no wheels.
Result<Study> studyDrawnPose(const mechanism::Mechanism& mechanism, const StudyRequest& request);

/// The stops at which a rover's joints stand.
std::vector<JointStop> stopsOf(const StaticModel& model, const StandingPose& pose);

/// At a pose that a rover has taken up.
/// @param searched  also look for the least torques
Study studyPose(StaticModel& model, const StandingPose& pose, std::optional<ContactSet> contacts,
                bool backwards = false, bool searched = true);

/// The wheels that need the friction required, within a thousandth of it, in the order of the
/// mechanism; none where no torques hold the rover.
std::vector<int> limitingWheels(const Study& study);

/// Least angle by which the rover would have to turn about a line between two neighbouring
/// footholds until its centre of mass is above it (E. G. Papadopoulos, D. A. Rey, ICRA 1996); 0
/// where it would tip, and with fewer than three footholds [rad].
double tipOverAngle(const Vec3& centerOfMass, std::span<const Contact> contacts);

}  // namespace simcore::statics
