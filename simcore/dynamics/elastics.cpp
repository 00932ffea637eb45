#include "simcore/dynamics/elastics.h"

#include "simcore/dynamics/engine.h"

namespace simcore::dynamics {
namespace {

/// Square of angular frequency times step from which a spring is stiff: symplectic Euler is stable
/// up to 4.
constexpr double kStiffSpring = 0.5;

}  // namespace

Elastics::Elastics(const mechanism::Mechanism& mechanism, const SpanningTree& tree)
    : mechanism_(mechanism),
      tree_(tree) {
    for (const mechanism::Spring& spring : mechanism_.springs) {
        Elastic elastic;
        elastic.spring = &spring;
        elastic.joint = spring.joint;
        elastic.damping = spring.damping;
        elastic.between = between(tree_, spring.first, spring.second);
        elastics_.push_back(std::move(elastic));
    }
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
        const mechanism::Joint& joint = mechanism_.joints[i];
        if (joint.damping > 0.0) {
            Elastic elastic;
            elastic.joint = static_cast<int>(i);
            elastic.damping = joint.damping;
            elastic.between = between(tree_, joint.first, joint.second);
            elastics_.push_back(std::move(elastic));
        }
    }
    indices_.reserve(static_cast<std::size_t>(tree_.rateCount()));
    factors_.reserve(static_cast<std::size_t>(tree_.rateCount()));
}

std::vector<const Between*> Elastics::betweens() const {
    std::vector<const Between*> betweens;
    for (const Elastic& elastic : elastics_) {
        betweens.push_back(&elastic.between);
    }
    return betweens;
}

void Elastics::resetStiff() {
    for (Elastic& elastic : elastics_) {
        elastic.stiff = false;
    }
}

void Elastics::findStiff(const TreeMotion& motion, const LoopClosures& loops, double step,
                         const RowMajor& factored, const PatternedLu& lu) {
    for (Elastic& elastic : elastics_) {
        if (elastic.spring == nullptr) {
            continue;
        }
        pushOf(elastic.between, elastic.wrench, motion, loops, indices_, factors_);
        Eigen::VectorXd push = Eigen::VectorXd::Zero(loops.independentCount());
        for (std::size_t i = 0; i < indices_.size(); ++i) {
            push[indices_[i]] = factors_[i];
        }
        Eigen::VectorXd moved = push;
        lu.solve(factored, moved);
        const double square = elastic.spring->stiffness * push.dot(moved);  // [rad^2/s^2]
        elastic.stiff = step * step * square > kStiffSpring;
    }
}

/// Takes the wrench and the push of the pose; the stiffness.
double Elastics::stretch(Elastic& elastic, const TreeMotion& motion) const {
    elastic.push = 0.0;
    if (elastic.joint >= 0) {
        const mechanism::Joint& joint = mechanism_.joints[static_cast<std::size_t>(elastic.joint)];
        elastic.wrench = axisOf(joint, motion);
        if (elastic.spring == nullptr) {
            return 0.0;
        }
        elastic.push =
            elastic.spring->preload - elastic.spring->stiffness * jointAngle(joint, motion.poses());
        return elastic.spring->stiffness;
    }
    const mechanism::Spring& spring = *elastic.spring;
    const Vec3 a = motion.poses()[static_cast<std::size_t>(spring.first)] * spring.firstPoint;
    const Vec3 b = motion.poses()[static_cast<std::size_t>(spring.second)] * spring.secondPoint;
    const double drawn = (spring.secondPoint - spring.firstPoint).norm();
    const int moving = tree_.positionOf(spring.second) >= 0 ? spring.second : spring.first;
    elastic.wrench = forceAt((b - a).normalized(), b - motion.origin(moving));
    elastic.push = spring.preload + spring.stiffness * (drawn - (b - a).norm());
    return spring.stiffness;
}

void Elastics::push(const TreeMotion& motion, double step, std::vector<Vec6>& wrenches) {
    for (Elastic& elastic : elastics_) {
        const double stiffness = stretch(elastic, motion);
        elastic.resisted = elastic.damping + (elastic.stiff ? step * stiffness : 0.0);
        pushBetween(tree_, elastic.between.first, elastic.between.second,
                    elastic.push * elastic.wrench, wrenches);
    }
}

void Elastics::resist(const TreeMotion& motion, const LoopClosures& loops, double step,
                      RowMajor& mass) {
    for (const Elastic& elastic : elastics_) {
        pushOf(elastic.between, elastic.wrench, motion, loops, indices_, factors_);
        for (std::size_t i = 0; i < indices_.size(); ++i) {
            for (std::size_t j = 0; j < indices_.size(); ++j) {
                mass(indices_[i], indices_[j]) +=
                    step * elastic.resisted * factors_[i] * factors_[j];
            }
        }
    }
}

void Elastics::damp(const std::vector<Vec6>& screws, std::span<const double> rates,
                    std::vector<Vec6>& wrenches) const {
    for (const Elastic& elastic : elastics_) {
        const double rate = rateAlong(elastic.between, elastic.wrench, screws, rates);
        pushBetween(tree_, elastic.between.first, elastic.between.second,
                    -elastic.resisted * rate * elastic.wrench, wrenches);
    }
}

}  // namespace simcore::dynamics
