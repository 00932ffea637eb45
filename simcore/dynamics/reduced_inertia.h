#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "simcore/dynamics/impulse_solver.h"
#include "simcore/dynamics/loop_closures.h"
#include "simcore/dynamics/spanning_tree.h"

namespace simcore::dynamics {

/// Inertia of a mechanism at the pose it was weighed at: H in the tree's rates, P^T H P in the
/// independent ones, with P from independent to all rates.
class ReducedInertia {
  public:
    ReducedInertia(const SpanningTree& tree, TreeMotion& motion, const LoopClosures& loops);

    /// P^T H P.
    void assemble(RowMajor& mass);
    /// H q', until the next call.
    const std::vector<double>& times(std::span<const double> rates);
    /// scale P^T f.
    /// @param forces  per rate of the tree
    void project(std::span<const double> forces, double scale, Eigen::VectorXd& projected) const;

  private:
    const SpanningTree& tree_;
    TreeMotion& motion_;
    const LoopClosures& loops_;
    const std::vector<double> resting_;  ///< no rates
    const std::vector<Vec6> noWrenches_;
    std::vector<double> forces_;
};

}  // namespace simcore::dynamics
