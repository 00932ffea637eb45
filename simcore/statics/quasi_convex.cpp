#include "simcore/statics/quasi_convex.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "simcore/statics/quadratic_program.h"

namespace simcore::statics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxCenters = 400;
constexpr int kMaxNewton = 30;
/// Share of the way back from what a center reaches to what it was allowed.
constexpr double kBack = 0.1;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What holds a minimum: cones at their border, half-spaces at theirs, and how much each counts.
struct Holding {
    std::vector<const Cone*> cones;
    std::vector<const HalfSpace*> halfSpaces;
    VectorXd multipliers;  ///< of the cones, then of the half-spaces
};

bool allReach(const QuasiConvexProgram& program, const VectorXd& y) {
    return std::all_of(program.cones.begin(), program.cones.end(),
                       [&](const Cone& cone) { return cone.reach(y) > 0.0; });
}

/// Within all half-spaces, but for rounding.
bool isWithin(const QuasiConvexProgram& program, const VectorXd& y) {
    return std::all_of(program.halfSpaces.begin(), program.halfSpaces.end(),
                       [&](const HalfSpace& half) { return half.room(y) >= -1e-9; });
}

/// What is near its border at `y`.
Holding holdingNear(const QuasiConvexProgram& program, const VectorXd& y, double s) {
    constexpr double kNear = 0.05;
    Holding holding;
    for (const Cone& cone : program.cones) {
        if (cone.vector(y).norm() > (1.0 - kNear) * s * cone.reach(y)) {
            holding.cones.push_back(&cone);
        }
    }
    for (const HalfSpace& half : program.halfSpaces) {
        if (half.room(y) < 0.1 * kNear) {
            holding.halfSpaces.push_back(&half);
        }
    }
    const std::size_t rows = holding.cones.size() + holding.halfSpaces.size();
    holding.multipliers = VectorXd::Zero(static_cast<Index>(rows));
    return holding;
}

/// Newton's method on the conditions of Karush, Kuhn and Tucker of what is said to hold.
class Sharpening {
  public:
    Sharpening(const QuasiConvexProgram& program, const Holding& holding)
        : program_(program),
          holding_(holding),
          cones_(static_cast<Index>(holding.cones.size())),
          halfSpaces_(static_cast<Index>(holding.halfSpaces.size())) {}

    /// Moves `y` to the minimum. False, with `y` spoilt, where what holds is not what was said.
    bool solve(VectorXd& y, double s) {
        constexpr int kMost = 12;
        constexpr double kFar = 10.0;
        const double before = program_.reached(y);
        VectorXd multipliers = holding_.multipliers;
        for (const Cone* cone : holding_.cones) {
            scale_ = std::max(scale_, cone->vector(y).norm());
        }
        double open = kInfinity;
        double moved = kInfinity;
        for (int iteration = 0; iteration < kMost; ++iteration) {
            if (!linearise(y, s, multipliers)) {
                return false;
            }
            const VectorXd step = matrix_.partialPivLu().solve(right_);
            if (!step.allFinite()) {
                return false;
            }
            open = (matrix_ * step - right_).lpNorm<Eigen::Infinity>();
            y += step.head(y.size());
            s += step[y.size()];
            multipliers = step.tail(cones_ + halfSpaces_);
            moved = step.head(y.size()).norm() / (1.0 + y.norm()) + std::abs(step[y.size()]);
            if (iteration > 0 && moved < 1e-12) {
                break;
            }
            if (iteration > 3 && moved > kFar) {
                return false;
            }
        }
        return open < 1e-7 && moved < 1e-7 && allReach(program_, y) && isWithin(program_, y) &&
               pushes(multipliers) && program_.reached(y) <= std::min(before, s + 1e-10) + 1e-12;
    }

  private:
    /// The conditions about y and s. Columns: y, s, multipliers. Rows: what the Lagrangian asks,
    /// then the borders. Unknown are the steps of y and s, and the multipliers themselves. False
    /// where a cone has no slope.
    bool linearise(const VectorXd& y, double s, const VectorXd& multipliers) {
        constexpr double kFlat = 1e-7;
        constexpr double kDependent = 1e-11;
        const Index n = y.size();
        const Index size = n + 1 + cones_ + halfSpaces_;
        matrix_.setZero(size, size);
        right_.setZero(size);
        right_[n] = -1.0;
        for (Index i = 0; i < cones_; ++i) {
            const Cone& cone = *holding_.cones[static_cast<std::size_t>(i)];
            const VectorXd v = cone.vector(y);
            const double length = v.norm();
            if (!(length > 1e-9 * scale_)) {
                return false;
            }
            const VectorXd along = cone.rows.transpose() * v / length;
            const double reach = cone.reach(y);
            matrix_.topLeftCorner(n, n) +=
                multipliers[i] / length *
                (cone.rows.transpose().lazyProduct(cone.rows) - along * along.transpose());
            // Mixed derivatives of y and s.
            matrix_.col(n).head(n) -= multipliers[i] * cone.slope;
            matrix_.row(n).head(n) -= multipliers[i] * cone.slope.transpose();
            border(n + 1 + i, along - s * cone.slope);
            matrix_(n, n + 1 + i) = -reach;
            matrix_(n + 1 + i, n) = -reach;
            right_[n + 1 + i] = s * reach - length;
        }
        for (Index i = 0; i < halfSpaces_; ++i) {
            const HalfSpace& half = *holding_.halfSpaces[static_cast<std::size_t>(i)];
            border(n + 1 + cones_ + i, -half.slope);
            right_[n + 1 + cones_ + i] = half.room(y);
        }
        // What the conditions leave open stays where it is.
        matrix_.diagonal().head(n).array() += kFlat;
        matrix_.diagonal().tail(cones_ + halfSpaces_).array() -= kDependent;
        return true;
    }

    void border(Index at, const VectorXd& slope) {
        matrix_.col(at).head(slope.size()) = slope;
        matrix_.row(at).head(slope.size()) = slope.transpose();
    }

    /// Whether what holds pushes and does not pull.
    static bool pushes(const VectorXd& multipliers) {
        return multipliers.size() == 0 || multipliers.minCoeff() >= -1e-9 * multipliers.maxCoeff();
    }

    const QuasiConvexProgram& program_;
    const Holding& holding_;
    const Index cones_, halfSpaces_;
    double scale_ = 1e-12;  ///< longest vector of the cones
    MatrixXd matrix_;
    VectorXd right_;
};

/// Each step solves the program with its cones taken as the half-spaces that touch them here, bent
/// as they are.
class Sequence {
  public:
    explicit Sequence(const QuasiConvexProgram& program) : program_(program) {}

    /// Moves `y` to the minimum. False, with `y` spoilt, when it does not get there.
    bool solve(VectorXd& y, double tolerance) {
        prepare(y.size());
        double best = isWithin(program_, y) ? reachedNear(y) : kInfinity;
        double s = std::min(kLargest, reachedNear(y));
        double caution = kFirstCaution;
        std::vector<bool> last;
        for (int k = 0; k < kMostSteps; ++k) {
            linearise(y, s, caution);
            Optimum optimum = minimise(quadratic_, multipliers_);
            multipliers_ = std::move(optimum.multipliers);
            VectorXd next = y + optimum.x.head(y.size());
            const double reached = reachedNear(next);
            const double promised = -optimum.x[y.size()];
            if (std::isfinite(best)) {
                // Nothing to be gained, however far: the conditions hold here.
                if (promised < tolerance) {
                    if (caution <= kLeastCaution) {
                        return true;
                    }
                    caution = kLeastCaution;
                    continue;
                }
                const double kept = (best - reached) / promised;
                caution = std::clamp(caution * (kept < 0.25  ? 5.0
                                                : kept > 0.7 ? 0.1
                                                             : 1.0),
                                     kLeastCaution, kMostCaution);
                if (!(reached < best)) {
                    continue;
                }
            }
            y = std::move(next);
            best = reached;
            if (!isWithin(program_, y)) {
                return false;  // the half-spaces leave nothing
            }
            s = std::isfinite(reached) ? reached : std::max(tolerance, s + optimum.x[y.size()]);
            if (reached <= tolerance) {
                return true;  // there is no less than none
            }
            std::vector<bool> active = activeNow();
            if (active == last && std::isfinite(reached)) {
                const Holding holding = holdingNow();
                VectorXd sharp = y;
                if (Sharpening(program_, holding).solve(sharp, s)) {
                    y = std::move(sharp);
                    return true;
                }
            }
            last = std::move(active);
        }
        return false;
    }

  private:
    static constexpr int kMostSteps = 40;
    // What long steps cost: more after one that did not keep what it promised, less after one that
    // did.
    static constexpr double kFirstCaution = 0.1;
    static constexpr double kLeastCaution = 1e-3;
    static constexpr double kMostCaution = 1e4;
    static constexpr double kProximal = 1e-3;  ///< the same for s
    /// A cone that reaches less counts as if it did, so that s may grow to free it.
    static constexpr double kLeastReach = 0.05;
    static constexpr double kLeastLength = 1e-9;
    static constexpr double kLargest = 10.0;

    /// What y reaches; infinite where that is so much that it tells nothing of the way to less.
    double reachedNear(const VectorXd& y) const {
        const double reached = program_.reached(y);
        return reached <= kLargest ? reached : kInfinity;
    }

    Index cones() const { return static_cast<Index>(program_.cones.size()); }

    void prepare(Index n) {
        const auto halfSpaces = static_cast<Index>(program_.halfSpaces.size());
        quadratic_.hessian.resize(n + 1, n + 1);
        quadratic_.right = -VectorXd::Unit(n + 1, n);
        quadratic_.rows.setZero(cones() + halfSpaces, n + 1);
        quadratic_.bounds.resize(cones() + halfSpaces);
        for (Index i = 0; i < halfSpaces; ++i) {
            quadratic_.rows.row(cones() + i).head(n) =
                program_.halfSpaces[static_cast<std::size_t>(i)].slope.transpose();
        }
        multipliers_.setZero(cones() + halfSpaces);
    }

    std::vector<bool> activeNow() const {
        std::vector<bool> active(static_cast<std::size_t>(multipliers_.size()));
        for (std::size_t i = 0; i < active.size(); ++i) {
            active[i] = multipliers_[static_cast<Index>(i)] > 0.0;
        }
        return active;
    }

    void linearise(const VectorXd& y, double s, double caution) {
        const Index n = y.size();
        quadratic_.hessian.setZero();
        quadratic_.hessian.diagonal().setConstant(caution);
        quadratic_.hessian(n, n) = kProximal;
        for (Index i = 0; i < cones(); ++i) {
            const Cone& cone = program_.cones[static_cast<std::size_t>(i)];
            const VectorXd v = cone.vector(y);
            const double length = v.norm();
            const double reach = cone.reach(y);
            VectorXd along = VectorXd::Zero(n);
            if (length > kLeastLength) {
                along.noalias() = cone.rows.transpose() * v / length;
                if (cone.rows.rows() > 1 && multipliers_[i] > 0.0) {
                    quadratic_.hessian.topLeftCorner(n, n) +=
                        multipliers_[i] / length *
                        (cone.rows.transpose().lazyProduct(cone.rows) - along * along.transpose());
                }
            }
            quadratic_.rows.row(i).head(n) = (s * cone.slope - along).transpose();
            quadratic_.rows(i, n) = std::max(kLeastReach, reach);
            quadratic_.bounds[i] = length - s * reach;
        }
        for (std::size_t i = 0; i < program_.halfSpaces.size(); ++i) {
            quadratic_.bounds[cones() + static_cast<Index>(i)] = -program_.halfSpaces[i].room(y);
        }
    }

    Holding holdingNow() const {
        Holding holding;
        std::vector<double> multipliers;
        for (Index i = 0; i < multipliers_.size(); ++i) {
            if (!(multipliers_[i] > 0.0)) {
                continue;
            }
            multipliers.push_back(multipliers_[i]);
            if (i < cones()) {
                holding.cones.push_back(&program_.cones[static_cast<std::size_t>(i)]);
            } else {
                holding.halfSpaces.push_back(
                    &program_.halfSpaces[static_cast<std::size_t>(i - cones())]);
            }
        }
        holding.multipliers =
            VectorXd::Map(multipliers.data(), static_cast<Index>(multipliers.size()));
        return holding;
    }

    const QuasiConvexProgram& program_;
    QuadraticProgram quadratic_;  ///< of the steps of y and s
    VectorXd multipliers_;
};

/// The method of centers: the best place within all borders, which are then drawn closer.
class Centers {
  public:
    explicit Centers(const QuasiConvexProgram& program) : program_(program) {}

    /// From a `y` inside all half-spaces, until it shows what holds the minimum, which then is
    /// found at once; to `tolerance` where that does not do.
    void solve(VectorXd& y, double tolerance) const {
        for (double coarse = 0.1; coarse > 2.0 * tolerance; coarse *= 0.1) {
            minimise(y, coarse * std::max(1e-3, program_.reached(y)));
            const double s = program_.reached(y);
            const Holding holding = holdingNear(program_, y, s);
            VectorXd sharp = y;
            if (Sharpening(program_, holding).solve(sharp, s)) {
                y = sharp;
                return;
            }
        }
        minimise(y, tolerance);
    }

  private:
    /// From a `y` inside all of them, to `tolerance` of s.
    void minimise(VectorXd& y, double tolerance) const {
        double allowed = 1.5 * program_.reached(y) + tolerance;
        for (int k = 0; k < kMaxCenters; ++k) {
            center(y, allowed);
            const double s = program_.reached(y);
            if (s <= tolerance) {
                return;
            }
            const double next = s + kBack * (allowed - s);
            if (allowed - next < 0.05 * tolerance) {
                return;
            }
            allowed = next;
        }
    }

    /// Sum of -log of how far each is from its border; infinite outside.
    double barrier(const VectorXd& y, double s) const {
        double sum = 0.0;
        for (const Cone& cone : program_.cones) {
            const double reach = s * cone.reach(y);
            const double room = reach * reach - cone.vector(y).squaredNorm();
            if (!(reach > 0.0) || !(room > 0.0)) {
                return std::numeric_limits<double>::infinity();
            }
            sum -= weight() * std::log(room);
        }
        for (const HalfSpace& half : program_.halfSpaces) {
            const double room = half.room(y);
            if (!(room > 0.0)) {
                return std::numeric_limits<double>::infinity();
            }
            sum -= std::log(room);
        }
        return sum;
    }

    /// Cones count for more than what only has to hold.
    double weight() const { return 1.0 + static_cast<double>(program_.halfSpaces.size()); }

    void center(VectorXd& y, double s) const {
        const Eigen::Index n = y.size();
        double value = barrier(y, s);
        for (int iteration = 0; iteration < kMaxNewton; ++iteration) {
            VectorXd gradient = VectorXd::Zero(n);
            MatrixXd hessian = MatrixXd::Zero(n, n);
            for (const Cone& cone : program_.cones) {
                const VectorXd v = cone.vector(y);
                const double reach = s * cone.reach(y);
                const double room = reach * reach - v.squaredNorm();
                const VectorXd slope =
                    2.0 * s * reach * cone.slope - 2.0 * cone.rows.transpose() * v;
                gradient -= weight() / room * slope;
                hessian.noalias() += weight() / (room * room) * slope * slope.transpose();
                hessian.noalias() -=
                    weight() * 2.0 * s * s / room * cone.slope * cone.slope.transpose();
                hessian.noalias() += weight() * 2.0 / room * cone.rows.transpose() * cone.rows;
            }
            for (const HalfSpace& half : program_.halfSpaces) {
                const double room = half.room(y);
                gradient -= half.slope / room;
                hessian.noalias() += half.slope * half.slope.transpose() / (room * room);
            }
            // What nothing bounds stays where it is.
            hessian.diagonal().array() += 1e-14 * hessian.diagonal().maxCoeff();
            const VectorXd step = -hessian.ldlt().solve(gradient);
            const double decrease = -gradient.dot(step);
            if (!(decrease > 1e-10)) {
                return;
            }
            double share = 1.0;
            double next = barrier(y + step, s);
            while (!(next <= value - 0.1 * share * decrease) && share > 1e-10) {
                share *= 0.5;
                next = barrier(y + share * step, s);
            }
            if (share <= 1e-10) {
                return;
            }
            y += share * step;
            value = next;
        }
    }

    const QuasiConvexProgram& program_;
};

/// Some y within all half-spaces, away from their borders. False when there is none.
bool findInterior(const std::vector<HalfSpace>& halfSpaces, VectorXd& y) {
    // One more coordinate: by how much the borders are relaxed.
    const Index n = y.size();
    const auto slack = [&](const VectorXd& at) {
        double smallest = kInfinity;
        for (const HalfSpace& half : halfSpaces) {
            smallest = std::min(smallest, half.room(at));
        }
        return smallest;
    };
    double least = slack(y);
    // Newton's method on the barrier of limits relaxed ever less, until none need be.
    for (int k = 0; k < kMaxCenters; ++k) {
        if (least > 1e-6) {
            return true;
        }
        const double relaxed = -least + 0.1 * std::max(1e-6, std::abs(least)) + 1e-6;
        for (int iteration = 0; iteration < kMaxNewton; ++iteration) {
            VectorXd gradient = VectorXd::Zero(n);
            MatrixXd hessian = MatrixXd::Zero(n, n);
            for (const HalfSpace& half : halfSpaces) {
                const double room = half.room(y) + relaxed;
                gradient -= half.slope / room;
                hessian.noalias() += half.slope * half.slope.transpose() / (room * room);
            }
            hessian.diagonal().array() += 1e-14 * std::max(1e-300, hessian.diagonal().maxCoeff());
            const VectorXd step = -hessian.ldlt().solve(gradient);
            const double decrease = -gradient.dot(step);
            if (!(decrease > 1e-6)) {
                break;
            }
            double share = 1.0;
            while (slack(y + share * step) + relaxed <= 0.0 && share > 1e-12) {
                share *= 0.5;
            }
            // Damped as self-concordance asks: the barrier falls for certain.
            share = std::min(share, 1.0 / (1.0 + std::sqrt(decrease)));
            y += share * step;
        }
        const double next = slack(y);
        if (!(next > least + 1e-9)) {
            return false;
        }
        least = next;
    }
    return false;
}

}  // namespace

double QuasiConvexProgram::reached(const VectorXd& y) const {
    double s = 0.0;
    for (const Cone& cone : cones) {
        const double reach = cone.reach(y);
        if (!(reach > 0.0)) {
            return kInfinity;
        }
        s = std::max(s, cone.vector(y).norm() / reach);
    }
    return s;
}

bool minimise(const QuasiConvexProgram& program, VectorXd& y, double tolerance) {
    if (const double s = program.reached(y); std::isfinite(s)) {
        const Holding holding = holdingNear(program, y, s);
        VectorXd sharp = y;
        if (Sharpening(program, holding).solve(sharp, s)) {
            y = std::move(sharp);
            return true;
        }
    }
    if (VectorXd sharp = y; Sequence(program).solve(sharp, tolerance)) {
        y = std::move(sharp);
        return true;
    }
    if (!findInterior(program.halfSpaces, y)) {
        return false;
    }
    Centers(program).solve(y, tolerance);
    return true;
}

}  // namespace simcore::statics
