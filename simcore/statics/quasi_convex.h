#pragma once

#include <vector>

#include <Eigen/Core>

namespace simcore::statics {

/// |rows y + offsets| <= s (slope y + start): s is to become small.
struct Cone {
    Eigen::MatrixXd rows;
    Eigen::VectorXd offsets;
    Eigen::VectorXd slope;
    double start = 0.0;

    Eigen::VectorXd vector(const Eigen::VectorXd& y) const { return rows * y + offsets; }

    double reach(const Eigen::VectorXd& y) const { return slope.dot(y) + start; }
};

/// slope y + start >= 0.
struct HalfSpace {
    Eigen::VectorXd slope;
    double start = 0.0;

    double room(const Eigen::VectorXd& y) const { return slope.dot(y) + start; }
};

/// Minimise s over y within all half-spaces: a quasi-convex problem, whose every local minimum is
/// the minimum. Numbers of the order of 1, a handful of them.
struct QuasiConvexProgram {
    std::vector<Cone> cones;
    std::vector<HalfSpace> halfSpaces;

    /// The least s that y is allowed with; infinite where a cone reaches nothing.
    double reached(const Eigen::VectorXd& y) const;
};

/// From near `y`. False, with `y` as it may be, when no y is within all half-spaces.
///
/// First a sequence of quadratic programs shows which cones and half-spaces hold the minimum, and
/// Newton's method on their conditions of Karush, Kuhn and Tucker ends it and proves it. Where that
/// does not do, the method of centers (S. Boyd, L. El Ghaoui, Linear Algebra Appl. 188, 1993), to
/// `tolerance` of s.
bool minimise(const QuasiConvexProgram& program, Eigen::VectorXd& y, double tolerance);

}  // namespace simcore::statics
