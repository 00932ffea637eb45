#pragma once

#include <vector>

#include <Eigen/Core>

#include "simcore/mobility/mobility.h"
#include "simcore/mobility/stance.h"

namespace simcore::mobility {

/// In which order constraints are given up when some are redundant: the later a kind stands here,
/// the earlier it goes. A wheel's lateral hold and a bearing's alignment are what a designer can
/// most easily do without.
enum class Priority { ContactNormal, ContactRolling, Gear, JointSlide, JointTurn, ContactLateral };

/// Velocity constraints J v = 0 of the mechanism at a stance.
///
/// Six columns a body that is not fixed: velocity of the point of that body that is now at the
/// chassis' origin, over the characteristic length L [1/s], then its angular velocity [rad/s]. Rows
/// that hold a translation are divided by L, so that all entries are comparable.
struct ConstraintJacobian {
    Eigen::MatrixXd matrix;             ///< rows x columns
    std::vector<ConstraintName> names;  ///< per row
    std::vector<Priority> priorities;   ///< per row
    std::vector<int> firstColumn;       ///< per body; -1 for one that is fixed
};

/// At the drawn pose on level ground.
ConstraintJacobian constraintJacobian(const mechanism::Mechanism& mechanism, Model model);
/// At any stance; throws std::invalid_argument when it does not fit the mechanism.
ConstraintJacobian constraintJacobian(const mechanism::Mechanism& mechanism, Model model,
                                      const Stance& stance);

}  // namespace simcore::mobility
