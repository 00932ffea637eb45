#include "simcore/mobility/free_motions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <Eigen/QR>

#include "simcore/base/text.h"
#include "simcore/mobility/constraint_system.h"
#include "simcore/mobility/factorisation.h"

namespace simcore::mobility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the largest motion: what moves less stands still for people.
constexpr double kStandsStill = 1e-3;

/// A basis of the same motions in which each has a coordinate of its own, as large as can be: so
/// motions that have nothing to do with each other come apart.
MatrixXd separated(MatrixXd motions) {
    for (Index k = 0; k < motions.cols(); ++k) {
        Index row = 0;
        Index column = k;
        double largest = 0.0;
        for (Index c = k; c < motions.cols(); ++c) {
            for (Index r = 0; r < motions.rows(); ++r) {
                // The first of many alike, whatever their round-off.
                if (std::abs(motions(r, c)) > largest * (1.0 + 1e-9)) {
                    largest = std::abs(motions(r, c));
                    row = r;
                    column = c;
                }
            }
        }
        motions.col(k).swap(motions.col(column));
        motions.col(k) /= motions(row, k);
        for (Index c = 0; c < motions.cols(); ++c) {
            if (c != k) {
                motions.col(c) -= motions(row, c) * motions.col(k);
            }
        }
    }
    return motions;
}

/// Columns of an orthonormal basis of what `motions` has at right angles to `idle`.
MatrixXd atRightAngles(const MatrixXd& motions, const MatrixXd& idle) {
    if (idle.cols() == 0) {
        return motions;
    }
    const Eigen::HouseholderQR<MatrixXd> idleQr(idle);
    const MatrixXd basis = idleQr.householderQ() * MatrixXd::Identity(idle.rows(), idle.cols());
    const Index count = motions.cols() - idle.cols();
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(motions - basis * (basis.transpose() * motions));
    return qr.householderQ() * MatrixXd::Identity(motions.rows(), count);
}

/// Velocity of a body: of its centre of mass over the characteristic length, and its turn.
struct BodyMotion {
    Vec3 slide = Vec3::Zero();
    Vec3 turn = Vec3::Zero();

    double size() const { return std::hypot(slide.norm(), turn.norm()); }
};

std::vector<BodyMotion> motionsOfBodies(const mechanism::Mechanism& mechanism,
                                        const ConstraintSystem& system, const VectorXd& motion) {
    const Vec3 reference =
        system.start().bodies[static_cast<std::size_t>(mechanism.chassis)].position;
    std::vector<BodyMotion> bodies(mechanism.bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const int column = system.firstColumn()[b];
        if (column >= 0) {
            const Vec3 arm = system.start().bodies[b] * mechanism.bodies[b].com - reference;
            bodies[b].turn = motion.segment<3>(column + 3);
            bodies[b].slide =
                motion.segment<3>(column) + bodies[b].turn.cross(arm) / system.length();
        }
    }
    return bodies;
}

/// "y", or the components of a direction; without a sign, as a swing goes both ways.
std::string axisText(const Vec3& vector) {
    const Vec3 axis = vector.normalized();
    static constexpr const char* kAxes[] = {"x", "y", "z"};
    for (Index i = 0; i < 3; ++i) {
        if (std::abs(axis[i]) > 0.9999) {
            return kAxes[i];
        }
    }
    return fmt::format("({:.2f}, {:.2f}, {:.2f})", axis.x(), axis.y(), axis.z());
}

std::string motionText(const BodyMotion& motion) {
    const double least = kStandsStill * motion.size();
    if (motion.turn.norm() <= least) {
        return Text::of("moves along {}", axisText(motion.slide));
    }
    if (motion.slide.norm() <= least) {
        return Text::of("turns about {}", axisText(motion.turn));
    }
    return Text::of("moves along {} and turns about {}", axisText(motion.slide),
                    axisText(motion.turn));
}

std::string wheelsText(const mechanism::Mechanism& mechanism, const std::vector<BodyMotion>& bodies,
                       double least) {
    const auto rolling = static_cast<std::size_t>(std::count_if(
        mechanism.wheels.begin(), mechanism.wheels.end(), [&](const mechanism::Wheel& wheel) {
            return bodies[static_cast<std::size_t>(wheel.body)].turn.norm() > least;
        }));
    return rolling == mechanism.wheels.size()
               ? Text::of("all wheels roll")
               : Text::of("{} of {} wheels roll", rolling, mechanism.wheels.size());
}

/// How many joints that are no axles move.
int movingJoints(const mechanism::Mechanism& mechanism, const std::vector<BodyMotion>& bodies,
                 double least) {
    int moving = 0;
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
        const bool axle = std::any_of(
            mechanism.wheels.begin(), mechanism.wheels.end(),
            [&](const mechanism::Wheel& wheel) { return wheel.axle == static_cast<int>(j); });
        const auto first = static_cast<std::size_t>(mechanism.joints[j].first);
        const auto second = static_cast<std::size_t>(mechanism.joints[j].second);
        moving += !axle && (bodies[second].turn - bodies[first].turn).norm() > least ? 1 : 0;
    }
    return moving;
}

void describeMotion(const mechanism::Mechanism& mechanism, const std::vector<BodyMotion>& bodies,
                    Swing& swing) {
    std::size_t most = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].size() > bodies[most].size() * (1.0 + 1e-9)) {
            most = b;
        }
    }
    const double least = kStandsStill * bodies[most].size();
    const auto moving = std::count_if(bodies.begin(), bodies.end(), [&](const BodyMotion& motion) {
        return motion.size() > least;
    });
    swing.body = mechanism.bodies[most].name;
    const auto chassis = static_cast<std::size_t>(mechanism.chassis);
    if (!mechanism.wheels.empty() && bodies[chassis].size() > least) {
        swing.description =
            fmt::format("{} {}; {}", mechanism.bodies[chassis].name, motionText(bodies[chassis]),
                        wheelsText(mechanism, bodies, least));
        const int joints = movingJoints(mechanism, bodies, least);
        if (joints > 0) {
            swing.description +=
                "; " + (joints == 1 ? Text::of("1 joint of the suspension turns")
                                    : Text::of("{} joints of the suspension turn", joints));
        }
        return;
    }
    swing.description = fmt::format("{} {}", swing.body, motionText(bodies[most]));
    swing.description +=
        "; " + (moving == 1 ? Text::of("nothing else moves") : Text::of("{} bodies move", moving));
}

/// Closes loops and contacts by Newton's method. A factorisation serves as long as it brings the
/// violation down quickly: neighbouring poses share it.
class Closer {
  public:
    /// Corrections are at right angles to the columns of `held`.
    Closer(const ConstraintSystem& system, MatrixXd held)
        : system_(system),
          held_(std::move(held)) {
        solver_.setThreshold(1e-9);
    }

    /// False, and a pose that is good for nothing, when it cannot be closed near by.
    bool close(Stance& stance, double nearBy) {
        double previous = std::numeric_limits<double>::infinity();
        double corrected = 0.0;
        for (int i = 0; i < kMostIterations; ++i) {
            const VectorXd residual = system_.residual(stance);
            closure_ = residual.size() > 0 ? residual.cwiseAbs().maxCoeff() : 0.0;
            if (closure_ <= kClosedEnough) {
                return true;
            }
            if (!std::isfinite(closure_) || corrected > nearBy) {
                return false;
            }
            if (!factorised_ || closure_ > kSlow * previous) {
                factorise(stance);
            }
            previous = closure_;
            VectorXd rest = VectorXd::Zero(residual.size() + held_.cols());
            rest.head(residual.size()) = -residual;
            const VectorXd correction = solver_.solve(rest);
            corrected += correction.norm();
            stance = system_.moved(stance, correction);
        }
        return false;
    }

    /// What close() left.
    double closure() const { return closure_; }

  private:
    static constexpr double kClosedEnough = 1e-10;
    static constexpr double kSlow = 0.5;
    static constexpr int kMostIterations = 40;

    void factorise(const Stance& stance) {
        const MatrixXd rows = system_.matrix(stance);
        MatrixXd matrix(rows.rows() + held_.cols(), system_.columns());
        matrix << rows, held_.transpose();
        solver_.compute(matrix);
        factorised_ = true;
    }

    const ConstraintSystem& system_;
    MatrixXd held_;
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver_;
    bool factorised_ = false;
    double closure_ = 0.0;
};

/// Stances along `step` from the start, without it, until one cannot be closed.
std::vector<std::vector<Pose>> follow(const ConstraintSystem& system, const MatrixXd& held,
                                      const VectorXd& step, int steps, double& closure) {
    Closer closer(system, held);
    // Corrections that are much longer than the way there lead somewhere else. At a branching point
    // they are about as long: they find the motions that have to go along.
    const double nearBy = 10.0 * step.norm();
    std::vector<std::vector<Pose>> poses;
    Stance stance = system.start();
    for (int i = 0; i < steps; ++i) {
        stance = system.moved(stance, step);
        if (!closer.close(stance, nearBy)) {
            break;
        }
        closure = std::max(closure, closer.closure());
        poses.push_back(stance.bodies);
    }
    return poses;
}

/// Fills in the poses; false when there are none but the start.
bool followBothWays(const ConstraintSystem& system, const MatrixXd& held, const VectorXd& step,
                    int steps, Swing& swing) {
    std::vector<std::vector<Pose>> back = follow(system, held, -step, steps, swing.closure);
    std::vector<std::vector<Pose>> forth = follow(system, held, step, steps, swing.closure);
    std::reverse(back.begin(), back.end());
    swing.poses = std::move(back);
    swing.middle = swing.poses.size();
    swing.poses.push_back(system.start().bodies);
    swing.poses.insert(swing.poses.end(), std::make_move_iterator(forth.begin()),
                       std::make_move_iterator(forth.end()));
    return swing.poses.size() > 1;
}

Swing swingAlong(const mechanism::Mechanism& mechanism, const ConstraintSystem& system,
                 const MatrixXd& motions, const VectorXd& motion, const SwingLimits& limits) {
    const std::vector<BodyMotion> bodies = motionsOfBodies(mechanism, system, motion);
    Swing swing;
    describeMotion(mechanism, bodies, swing);
    double slide = 0.0;
    double turn = 0.0;
    for (const BodyMotion& body : bodies) {
        slide = std::max(slide, body.slide.norm());
        turn = std::max(turn, body.turn.norm());
    }
    const VectorXd step =
        motion / std::max(slide / limits.travel, turn / limits.turn) / limits.steps;
    if (followBothWays(system, motions, step, limits.steps, swing)) {
        return swing;
    }
    swing.continuation = Continuation::Branch;
    if (!followBothWays(system, motion.normalized(), step, limits.steps, swing)) {
        swing.continuation = Continuation::Infinitesimal;
        swing.closure = 0.0;
    }
    return swing;
}

}  // namespace

std::vector<Pose> Swing::at(double swing) const {
    const double reach = static_cast<double>(swing < 0.0 ? middle : poses.size() - 1 - middle);
    const double place = static_cast<double>(middle) + std::clamp(swing, -1.0, 1.0) * reach;
    const auto before = std::min(static_cast<std::size_t>(place), poses.size() - 1);
    const std::size_t after = std::min(before + 1, poses.size() - 1);
    const double part = place - static_cast<double>(before);
    std::vector<Pose> between = poses[before];
    for (std::size_t b = 0; b < between.size(); ++b) {
        const Pose& next = poses[after][b];
        between[b].position += part * (next.position - between[b].position);
        between[b].rotation = between[b].rotation.slerp(part, next.rotation);
    }
    return between;
}

std::vector<Swing> freeMotions(const mechanism::Mechanism& mechanism, Model model) {
    return freeMotions(mechanism, model, drawnStance(mechanism));
}

std::vector<Swing> freeMotions(const mechanism::Mechanism& mechanism, Model model,
                               const Stance& stance, const SwingLimits& limits) {
    if (limits.steps < 1) {
        throw std::invalid_argument("a motion is followed by one step at least");
    }
    const ConstraintSystem system(mechanism, model, stance);
    const ConstraintJacobian jacobian = system.jacobian();
    const Factorisation present(jacobian.matrix);
    if (present.motions.cols() == 0) {
        return {};
    }
    const MatrixXd idle = separated(idleMotions(mechanism, jacobian, present.motions));
    const MatrixXd wanted = separated(atRightAngles(present.motions, idle));
    std::vector<Swing> swings;
    for (Index k = 0; k < wanted.cols(); ++k) {
        swings.push_back(swingAlong(mechanism, system, present.motions, wanted.col(k), limits));
    }
    for (Index k = 0; k < idle.cols(); ++k) {
        swings.push_back(swingAlong(mechanism, system, present.motions, idle.col(k), limits));
        swings.back().idle = true;
    }
    return swings;
}

}  // namespace simcore::mobility
