#include "simcore/dynamics/between.h"

#include <algorithm>

namespace simcore::dynamics {

Between between(const SpanningTree& tree, int first, int second) {
    return {first, second, relativeRates(tree, first, second)};
}

Vec6 axisOf(const mechanism::Joint& joint, const TreeMotion& motion) {
    return spatial(motion.poses()[static_cast<std::size_t>(joint.first)].rotation * joint.axis,
                   Vec3::Zero());
}

double rateAlong(const Between& between, const Vec6& wrench, const std::vector<Vec6>& screws,
                 std::span<const double> rates) {
    double rate = 0.0;
    for (const SignedRate& signed_ : between.rates) {
        const auto j = static_cast<std::size_t>(signed_.rate);
        rate += signed_.sign * wrench.dot(screws[j]) * rates[j];
    }
    return rate;
}

void pushOf(const Between& between, const Vec6& wrench, const TreeMotion& motion,
            const LoopClosures& loops, std::vector<int>& indices, std::vector<double>& factors) {
    indices.clear();
    factors.clear();
    for (const SignedRate& signed_ : between.rates) {
        const double lever =
            signed_.sign * wrench.dot(motion.screws()[static_cast<std::size_t>(signed_.rate)]);
        for (const RateTerm& term : loops.terms(signed_.rate)) {
            const auto at = std::find(indices.begin(), indices.end(), term.index);
            if (at == indices.end()) {
                indices.push_back(term.index);
                factors.push_back(lever * term.factor);
            } else {
                factors[static_cast<std::size_t>(at - indices.begin())] += lever * term.factor;
            }
        }
    }
}

}  // namespace simcore::dynamics
