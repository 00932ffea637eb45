#pragma once

#include <span>
#include <vector>

#include "simcore/dynamics/between.h"
#include "simcore/dynamics/engine.h"
#include "simcore/dynamics/impulse_solver.h"

namespace simcore::dynamics {

/// Stops, motors and dry friction of all joints, as rows of an ImpulseProblem: each pushes about
/// its joint's axis within limits.
class ScalarRows {
  public:
    ScalarRows(const mechanism::Mechanism& mechanism, const SpanningTree& tree);

    /// The bodies of every joint of the mechanism.
    const std::vector<Between>& joints() const { return joints_; }

    std::size_t mostRows() const { return rows_.size(); }

    /// Those of a step, at the pose that it starts from.
    /// @param rates  all of the tree's, before the step
    std::span<ScalarRow> make(const TreeMotion& motion, const LoopClosures& loops,
                              std::span<const double> rates, std::span<const JointMotor> motors,
                              double step);

    /// What the solved rows push, per joint of the mechanism, on its second body.
    void wrenches(double step, std::vector<Vec6>& wrenches) const;

  private:
    struct Place {
        const TreeMotion& motion;
        const LoopClosures& loops;
        std::span<const double> rates;
    };

    ScalarRow& add(std::size_t joint, const Vec6& wrench, const Place& at);
    void addStops(std::size_t joint, const Place& at, double step);
    void addMotor(std::size_t joint, const Place& at, double step);

    const mechanism::Mechanism& mechanism_;
    std::vector<Between> joints_;
    std::vector<const JointMotor*> motorOf_;  ///< of every joint; null = none
    std::vector<ScalarRow> rows_;             ///< room for the most there can be
    // of the rows in use
    std::vector<std::size_t> rowJoints_;
    std::vector<Vec6> rowWrenches_;  ///< per unit, on the joint's second body
};

}  // namespace simcore::dynamics
