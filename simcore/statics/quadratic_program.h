#pragma once

#include <Eigen/Core>

namespace simcore::statics {

/// Minimise 1/2 x' H x - r' x under the first `equations` rows J x = b and the other rows J x >= b.
struct QuadraticProgram {
    Eigen::MatrixXd hessian;  ///< H, positive definite
    Eigen::VectorXd right;    ///< r
    Eigen::MatrixXd rows;     ///< J
    Eigen::VectorXd bounds;   ///< b
    int equations = 0;
};

struct Optimum {
    Eigen::VectorXd x;
    Eigen::VectorXd multipliers;  ///< of the rows: H x = r + J' multipliers; 0 where a row is free
};

/// By the active rows of the dual problem (C. L. Lawson, R. J. Hanson, Solving Least Squares
/// Problems, 1974, ch. 23, with the Gram matrix J H^-1 J'). Rows may depend on each other. Rows
/// that contradict each other get the least violation, weighed by J H^-1 J'. Small problems:
/// everything is dense.
/// @param guess  multipliers of a program with the same rows that is nearly this one: which of them
///               are active need not be found anew
Optimum minimise(const QuadraticProgram& problem, const Eigen::VectorXd& guess = {});

/// A program that stands elsewhere.
struct QuadraticView {
    Eigen::Ref<const Eigen::MatrixXd> hessian;
    Eigen::Ref<const Eigen::VectorXd> right;
    Eigen::Ref<const Eigen::MatrixXd> rows;
    Eigen::Ref<const Eigen::VectorXd> bounds;
    int equations = 0;
};

/// The same without memory of its own (see Scratch).
/// @param multipliers  guess, then result
void minimise(const QuadraticView& problem, Eigen::Ref<Eigen::VectorXd> x,
              Eigen::Ref<Eigen::VectorXd> multipliers);

}  // namespace simcore::statics
