#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "simcore/dynamics/between.h"
#include "simcore/dynamics/impulse_solver.h"

namespace simcore::dynamics {

/// All springs and dampers of a mechanism in a step.
///
/// Springs push with their length before the step, which keeps energy, unless they are so stiff
/// that a step is too long for them: those push with their length after it, which damps them.
/// Dampers push with their rate after the step, so that no damping is too strong for it.
class Elastics {
  public:
    Elastics(const mechanism::Mechanism& mechanism, const SpanningTree& tree);

    /// What every one of them acts between.
    std::vector<const Between*> betweens() const;

    /// Takes all springs for ones that swing well within a step.
    void resetStiff();
    /// Finds those that do not, at the pose of the last push(). Springs that reset with it.
    /// @param factored  mass with the step's dampers, factored by `lu`
    void findStiff(const TreeMotion& motion, const LoopClosures& loops, double step,
                   const RowMajor& factored, const PatternedLu& lu);

    /// Adds what they push at their length before the step to the wrenches on the tree's bodies.
    void push(const TreeMotion& motion, double step, std::vector<Vec6>& wrenches);
    /// Adds what they resist per rate after the step, times the step, to the mass.
    void resist(const TreeMotion& motion, const LoopClosures& loops, double step, RowMajor& mass);
    /// Adds what they did resist to the wrenches.
    /// @param screws  of the pose before the step
    /// @param rates   after it
    void damp(const std::vector<Vec6>& screws, std::span<const double> rates,
              std::vector<Vec6>& wrenches) const;

  private:
    /// A spring or damper and how far it was before the step.
    struct Elastic {
        const mechanism::Spring* spring = nullptr;  ///< null: only a damper
        int joint = -1;                             ///< its axis; -1: between two points
        double damping = 0.0;
        Between between;
        bool stiff = false;  ///< too stiff for the step to swing

        // in this step
        Vec6 wrench = Vec6::Zero();  ///< per unit of force or torque, on the second body
        double push = 0.0;           ///< at its length before the step, without damping
        double resisted = 0.0;       ///< per unit of rate after it [N s/m] or [N m s/rad]
    };

    double stretch(Elastic& elastic, const TreeMotion& motion) const;

    const mechanism::Mechanism& mechanism_;
    const SpanningTree& tree_;
    std::vector<Elastic> elastics_;
    // room that stays
    std::vector<int> indices_;
    std::vector<double> factors_;
};

}  // namespace simcore::dynamics
