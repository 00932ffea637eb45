#include "simcore/dynamics/reduced_inertia.h"

namespace simcore::dynamics {

ReducedInertia::ReducedInertia(const SpanningTree& tree, TreeMotion& motion,
                               const LoopClosures& loops)
    : motion_(motion),
      loops_(loops),
      resting_(static_cast<std::size_t>(tree.rateCount()), 0.0),
      noWrenches_(tree.bodies().size(), Vec6::Zero()),
      forces_(resting_) {}

void ReducedInertia::assemble(RowMajor& mass) {
    mass.setZero();
    motion_.massMatrix([&mass, &loops = loops_](int i, int j, double value) {
        for (const RateTerm& a : loops.terms(i)) {
            for (const RateTerm& b : loops.terms(j)) {
                const double part = a.factor * b.factor * value;
                mass(a.index, b.index) += part;
                if (i != j) {
                    mass(b.index, a.index) += part;
                }
            }
        }
    });
}

const std::vector<double>& ReducedInertia::times(std::span<const double> rates) {
    // As the force of that acceleration from rest without weight.
    motion_.inverseDynamics(resting_, rates, 0.0, noWrenches_, forces_);
    return forces_;
}

void ReducedInertia::project(std::span<const double> forces, double scale,
                             Eigen::VectorXd& projected) const {
    projected.setZero(loops_.independentCount());
    for (std::size_t j = 0; j < forces.size(); ++j) {
        for (const RateTerm& term : loops_.terms(static_cast<int>(j))) {
            projected[term.index] += scale * term.factor * forces[j];
        }
    }
}

}  // namespace simcore::dynamics
