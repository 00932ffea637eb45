#pragma once

#include <vector>

#include <Eigen/Core>

#include "simcore/mobility/constraint_jacobian.h"

namespace simcore::mobility {

/// Rank and both null spaces of a constraint Jacobian from one column-pivoted QR of its transpose.
struct Factorisation {
    Eigen::Index rank = 0;
    double gap = 0.0;            ///< last kept / first dropped pivot
    Eigen::MatrixXd motions;     ///< columns: free motions, orthonormal
    Eigen::MatrixXd selfStress;  ///< columns: self-stress states, orthonormal

    explicit Factorisation(const Eigen::MatrixXd& jacobian);
};

/// Columns: independent free motions, out of the span of `motions`, that move neither chassis nor
/// wheels. In a mechanism without wheels: those of one body between two or more others.
Eigen::MatrixXd idleMotions(const mechanism::Mechanism& mechanism,
                            const ConstraintJacobian& jacobian, const Eigen::MatrixXd& motions);

/// Shares in the self-stress below this are round-off. A share is the square of an amplitude, whose
/// round-off is about 1e-15 in rovers.
inline constexpr double kNoShare = 1e-16;

/// Indices of one removable set: rows whose removal leaves the rank, least wanted first; sorted.
///
/// A set of rows can go exactly when the self-stress states restricted to it are independent
/// (matroid duality), so a greedy choice in order of priority finds the least wanted set.
std::vector<std::size_t> chooseRedundantSet(const Eigen::MatrixXd& selfStress,
                                            const std::vector<Priority>& priorities);

}  // namespace simcore::mobility
