#pragma once

#include <vector>

#include "simcore/dynamics/spanning_tree.h"

namespace simcore::dynamics {

/// Momentum of what floats, after a step.
struct Momentum {
    Vec6 about = Vec6::Zero();  ///< turning and linear, about the point [N m s], [N s]
    Vec3 point = Vec3::Zero();  ///< [m], world
};

/// What floats keeps its momentum to the last digit: the rates of its root are asked for what it
/// had after the last step and what came from outside since, not for inertia times old rates at the
/// new pose, which is the same to first order only.
class FloatingMomentum {
  public:
    explicit FloatingMomentum(const SpanningTree& tree);

    std::size_t count() const { return roots_.size(); }

    /// Of every root and all that hangs from it.
    void take(const TreeMotion& motion, const std::vector<Vec6>& twists,
              std::vector<Momentum>& momenta) const;

    /// Replaces the forces of the roots' rates by those that keep it.
    /// @param wrenches  on the tree's bodies from outside, gravity not included
    void conserve(const TreeMotion& motion, const std::vector<Momentum>& momenta,
                  const std::vector<Vec6>& wrenches, double gravity, double step,
                  std::vector<double>& forces) const;

  private:
    /// A root that floats, and all that hangs from it.
    struct Root {
        int body = -1;            ///< of the mechanism
        int rate = 0;             ///< the first of its six
        std::vector<int> bodies;  ///< positions in the tree
    };

    std::vector<Root> roots_;
};

}  // namespace simcore::dynamics
