#pragma once

#include <vector>

#include <Eigen/Core>

#include "simcore/mobility/mobility.h"

namespace simcore::mobility {

/// In which order constraints are given up when some are redundant: the later a kind stands here,
/// the earlier it goes. A wheel's lateral hold and a bearing's alignment are what a designer can
/// most easily do without.
enum class Priority { ContactNormal, ContactRolling, Gear, JointSlide, JointTurn, ContactLateral };

/// Velocity constraints J v = 0 of the mechanism on flat ground at its drawn pose.
///
/// Six columns a body that is not fixed: velocity of the rover frame's origin on that body over the
/// wheelbase L [1/s], then its angular velocity [rad/s]. Rows that hold a translation are divided
/// by L, so that all entries are comparable.
struct ConstraintJacobian {
    Eigen::MatrixXd matrix;             ///< rows x columns
    std::vector<ConstraintName> names;  ///< per row
    std::vector<Priority> priorities;   ///< per row
    std::vector<int> firstColumn;       ///< per body; -1 for one that is fixed
};

ConstraintJacobian constraintJacobian(const mechanism::Mechanism& mechanism, Model model);

/// Orthonormal directions at right angles to all of `directions`, as close to the rover's axes as
/// can be.
std::vector<Vec3> orthogonalComplement(const std::vector<Vec3>& directions);

}  // namespace simcore::mobility
