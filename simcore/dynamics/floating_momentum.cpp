#include "simcore/dynamics/floating_momentum.h"

namespace simcore::dynamics {

FloatingMomentum::FloatingMomentum(const SpanningTree& tree) {
    std::vector<int> rootOf;
    for (const TreeBody& at : tree.bodies()) {
        const int position = static_cast<int>(rootOf.size());
        if (at.parent >= 0) {
            rootOf.push_back(rootOf[static_cast<std::size_t>(at.parent)]);
        } else if (at.joint < 0) {
            rootOf.push_back(static_cast<int>(roots_.size()));
            roots_.push_back({at.body, at.elements.front().rate, {}});
        } else {
            rootOf.push_back(-1);
        }
        if (rootOf.back() >= 0) {
            roots_[static_cast<std::size_t>(rootOf.back())].bodies.push_back(position);
        }
    }
}

void FloatingMomentum::take(const TreeMotion& motion, const std::vector<Vec6>& twists,
                            std::vector<Momentum>& momenta) const {
    for (std::size_t k = 0; k < roots_.size(); ++k) {
        Vec6 momentum = Vec6::Zero();
        for (const int body : roots_[k].bodies) {
            const auto b = static_cast<std::size_t>(body);
            momentum += motion.inertia(b) * twists[b];
        }
        momenta[k] = {momentum, motion.origin(roots_[k].body)};
    }
}

void FloatingMomentum::conserve(const TreeMotion& motion, const std::vector<Momentum>& momenta,
                                const std::vector<Vec6>& wrenches, double gravity, double step,
                                std::vector<double>& forces) const {
    for (std::size_t k = 0; k < roots_.size(); ++k) {
        const Root& root = roots_[k];
        Vec6 momentum = momenta[k].about;
        momentum.head<3>() -=
            (motion.origin(root.body) - momenta[k].point).cross(momentum.tail<3>());
        for (const int body : root.bodies) {
            const auto b = static_cast<std::size_t>(body);
            momentum += step * (wrenches[b] + motion.weight(b, gravity));
        }
        for (int rate = root.rate; rate < root.rate + 6; ++rate) {
            const auto j = static_cast<std::size_t>(rate);
            forces[j] = -motion.screws()[j].dot(momentum) / step;
        }
    }
}

}  // namespace simcore::dynamics
