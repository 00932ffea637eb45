#include "simcore/dynamics/reduced_inertia.h"

#include <algorithm>

namespace simcore::dynamics {

ReducedInertia::ReducedInertia(const SpanningTree& tree, TreeMotion& motion,
                               const LoopClosures& loops)
    : tree_(tree),
      motion_(motion),
      loops_(loops),
      resting_(static_cast<std::size_t>(tree.rateCount()), 0.0),
      noWrenches_(tree.bodies().size(), Vec6::Zero()),
      forces_(resting_) {}

void ReducedInertia::assemble(RowMajor& mass) {
    mass.setZero();
    motion_.visitMomenta([&](std::size_t body, int j, const Vec6& momentum) {
        const FloatingRoot* const root = loops_.rootOf(body);
        const int rootRate = loops_.lastRootRate(body);
        // The root's rates are its twist: what they share with others is a momentum as it stands.
        for (const RateTerm& own : loops_.terms(j)) {
            double* const row = mass.row(own.index).data();
            for (std::size_t k = 0; root != nullptr && k < 6; ++k) {
                row[root->indices[k]] += own.factor * momentum[static_cast<Eigen::Index>(k)];
            }
        }
        for (int i = j; i > rootRate; i = tree_.rateBefore(i)) {
            const double value = motion_.screws()[static_cast<std::size_t>(i)].dot(momentum);
            for (const RateTerm& a : loops_.terms(i)) {
                for (const RateTerm& b : loops_.terms(j)) {
                    const double part = a.factor * b.factor * value;
                    mass(a.index, b.index) += part;
                    if (i != j) {
                        mass(b.index, a.index) += part;
                    }
                }
            }
        }
    });
    for (const FloatingRoot& root : loops_.roots()) {
        // All that hangs from it is numbered before it.
        const int first = *std::min_element(root.indices.begin(), root.indices.end());
        for (int row = 0; row < first; ++row) {
            for (const int column : root.indices) {
                mass(column, row) = mass(row, column);
            }
        }
    }
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
