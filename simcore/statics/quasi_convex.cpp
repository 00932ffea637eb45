#include "simcore/statics/quasi_convex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

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
/// A place y.
using Given = Eigen::Ref<const VectorXd>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What holds a minimum: cones at their border, half-spaces at theirs, and how much each counts.
class Holding {
  public:
    /// Of no more than the program has.
    Holding(Scratch& room, const QuasiConvexProgram& program)
        : cones_(room.list<const Cone*>(program.cones().size())),
          halfSpaces_(room.list<const HalfSpace*>(program.halfSpaces().size())),
          multipliers_(room.vector(static_cast<Index>(cones_.size() + halfSpaces_.size()))) {}

    /// All cones before the half-spaces.
    void add(const Cone& cone, double multiplier) {
        multipliers_[count()] = multiplier;
        cones_[coneCount_++] = &cone;
    }

    void add(const HalfSpace& half, double multiplier) {
        multipliers_[count()] = multiplier;
        halfSpaces_[halfSpaceCount_++] = &half;
    }

    std::span<const Cone* const> cones() const { return cones_.first(coneCount_); }

    std::span<const HalfSpace* const> halfSpaces() const {
        return halfSpaces_.first(halfSpaceCount_);
    }

    Index count() const { return static_cast<Index>(coneCount_ + halfSpaceCount_); }

    /// Of the cones, then of the half-spaces.
    auto multipliers() const { return multipliers_.head(count()); }

  private:
    std::span<const Cone*> cones_;
    std::span<const HalfSpace*> halfSpaces_;
    Scratch::Vector multipliers_;
    std::size_t coneCount_ = 0;
    std::size_t halfSpaceCount_ = 0;
};

bool allReach(const QuasiConvexProgram& program, const Given& y) {
    return std::all_of(program.cones().begin(), program.cones().end(),
                       [&](const Cone& cone) { return cone.reach(y) > 0.0; });
}

/// Within all half-spaces, but for rounding.
bool isWithin(const QuasiConvexProgram& program, const Given& y) {
    return std::all_of(program.halfSpaces().begin(), program.halfSpaces().end(),
                       [&](const HalfSpace& half) { return half.room(y) >= -1e-9; });
}

/// What is near its border at `y`.
Holding holdingNear(Scratch& room, const QuasiConvexProgram& program, const Given& y, double s) {
    constexpr double kNear = 0.05;
    Holding holding(room, program);
    for (const Cone& cone : program.cones()) {
        if (cone.length(y) > (1.0 - kNear) * s * cone.reach(y)) {
            holding.add(cone, 0.0);
        }
    }
    for (const HalfSpace& half : program.halfSpaces()) {
        if (half.room(y) < 0.1 * kNear) {
            holding.add(half, 0.0);
        }
    }
    return holding;
}

/// Gaussian elimination with the largest pivot of each column, which spoils the matrix. Not finite
/// where it is singular.
void eliminate(Scratch::Matrix& matrix, Scratch::Vector& right) {
    const Index n = matrix.rows();
    for (Index k = 0; k < n; ++k) {
        Index best = 0;
        matrix.col(k).tail(n - k).cwiseAbs().maxCoeff(&best);
        if (best > 0) {
            matrix.row(k).tail(n - k).swap(matrix.row(k + best).tail(n - k));
            std::swap(right[k], right[k + best]);
        }
        const Index below = n - k - 1;
        matrix.col(k).tail(below) /= matrix(k, k);
        right.tail(below) -= right[k] * matrix.col(k).tail(below);
        for (Index column = k + 1; column < n; ++column) {
            matrix.col(column).tail(below) -= matrix(k, column) * matrix.col(k).tail(below);
        }
    }
    matrix.triangularView<Eigen::Upper>().solveInPlace(right);
}

/// into += factor (rows' rows - along along').
template <class Block>
void addBend(const Cone& cone, double factor, const Scratch::Vector& along, Block&& into) {
    into.noalias() += factor * cone.rows.transpose().lazyProduct(cone.rows);
    into.noalias() -= factor * along.lazyProduct(along.transpose());
}

/// Newton's method on the conditions of Karush, Kuhn and Tucker of what is said to hold.
class Sharpening {
  public:
    Sharpening(const QuasiConvexProgram& program, const Holding& holding)
        : program_(program),
          holding_(holding),
          cones_(static_cast<Index>(holding.cones().size())),
          halfSpaces_(static_cast<Index>(holding.halfSpaces().size())),
          size_(program.unknowns() + 1 + cones_ + halfSpaces_),
          matrix_(room_.matrix(size_, size_)),
          spoilt_(room_.matrix(size_, size_)),
          right_(room_.vector(size_)),
          step_(room_.vector(size_)),
          multipliers_(room_.vector(holding.multipliers())),
          along_(room_.vector(program.unknowns())) {}

    /// Moves `y` to the minimum. False, with `y` spoilt, where what holds is not what was said.
    bool solve(Eigen::Ref<VectorXd> y, double s) {
        constexpr int kMost = 12;
        constexpr double kFar = 10.0;
        const double before = program_.reached(y);
        for (const Cone* cone : holding_.cones()) {
            scale_ = std::max(scale_, cone->length(y));
        }
        double open = kInfinity;
        double moved = kInfinity;
        for (int iteration = 0; iteration < kMost; ++iteration) {
            if (!linearise(y, s)) {
                return false;
            }
            step_ = right_;
            spoilt_ = matrix_;
            eliminate(spoilt_, step_);
            if (!step_.allFinite()) {
                return false;
            }
            right_.noalias() -= matrix_ * step_;
            open = right_.lpNorm<Eigen::Infinity>();
            y += step_.head(y.size());
            s += step_[y.size()];
            multipliers_ = step_.tail(cones_ + halfSpaces_);
            moved = step_.head(y.size()).norm() / (1.0 + y.norm()) + std::abs(step_[y.size()]);
            if (iteration > 0 && moved < 1e-12) {
                break;
            }
            if (iteration > 3 && moved > kFar) {
                return false;
            }
        }
        return open < 1e-7 && moved < 1e-7 && allReach(program_, y) && isWithin(program_, y) &&
               pushes() && program_.reached(y) <= std::min(before, s + 1e-10) + 1e-12;
    }

  private:
    /// The conditions about y and s. Columns: y, s, multipliers. Rows: what the Lagrangian asks,
    /// then the borders. Unknown are the steps of y and s, and the multipliers themselves. False
    /// where a cone has no slope.
    bool linearise(const Given& y, double s) {
        constexpr double kFlat = 1e-7;
        constexpr double kDependent = 1e-11;
        const Index n = y.size();
        matrix_.setZero();
        right_.setZero();
        right_[n] = -1.0;
        for (Index i = 0; i < cones_; ++i) {
            const Cone& cone = *holding_.cones()[static_cast<std::size_t>(i)];
            Scratch room;
            const Scratch::Vector v = cone.vector(room, y);
            const double length = v.norm();
            if (!(length > 1e-9 * scale_)) {
                return false;
            }
            along_.noalias() = cone.rows.transpose().lazyProduct(v) / length;
            const double reach = cone.reach(y);
            addBend(cone, multipliers_[i] / length, along_, matrix_.topLeftCorner(n, n));
            // Mixed derivatives of y and s.
            matrix_.col(n).head(n) -= multipliers_[i] * cone.slope;
            matrix_.row(n).head(n) -= multipliers_[i] * cone.slope.transpose();
            border(n + 1 + i, along_ - s * cone.slope);
            matrix_(n, n + 1 + i) = -reach;
            matrix_(n + 1 + i, n) = -reach;
            right_[n + 1 + i] = s * reach - length;
        }
        for (Index i = 0; i < halfSpaces_; ++i) {
            const HalfSpace& half = *holding_.halfSpaces()[static_cast<std::size_t>(i)];
            border(n + 1 + cones_ + i, -half.slope);
            right_[n + 1 + cones_ + i] = half.room(y);
        }
        // What the conditions leave open stays where it is.
        matrix_.diagonal().head(n).array() += kFlat;
        matrix_.diagonal().tail(cones_ + halfSpaces_).array() -= kDependent;
        return true;
    }

    template <class Expression>
    void border(Index at, const Expression& slope) {
        matrix_.col(at).head(slope.size()) = slope;
        matrix_.row(at).head(slope.size()) = slope.transpose();
    }

    /// Whether what holds pushes and does not pull.
    bool pushes() const {
        return multipliers_.size() == 0 ||
               multipliers_.minCoeff() >= -1e-9 * multipliers_.maxCoeff();
    }

    Scratch room_;
    const QuasiConvexProgram& program_;
    const Holding& holding_;
    const Index cones_, halfSpaces_, size_;
    double scale_ = 1e-12;  ///< longest vector of the cones
    Scratch::Matrix matrix_, spoilt_;
    Scratch::Vector right_, step_, multipliers_, along_;
};

/// Each step solves the program with its cones taken as the half-spaces that touch them here, bent
/// as they are.
class Sequence {
  public:
    explicit Sequence(const QuasiConvexProgram& program)
        : program_(program),
          cones_(static_cast<Index>(program.cones().size())),
          rowCount_(cones_ + static_cast<Index>(program.halfSpaces().size())),
          hessian_(room_.matrix(program.unknowns() + 1, program.unknowns() + 1)),
          right_(room_.vector(program.unknowns() + 1)),
          rows_(room_.matrix(rowCount_, program.unknowns() + 1)),
          bounds_(room_.vector(rowCount_)),
          step_(room_.vector(program.unknowns() + 1)),
          multipliers_(room_.vector(rowCount_)),
          next_(room_.vector(program.unknowns())),
          along_(room_.vector(program.unknowns())) {
        right_ = -VectorXd::Unit(right_.size(), program.unknowns());
        rows_.setZero();
        for (Index i = cones_; i < rowCount_; ++i) {
            rows_.row(i).head(program.unknowns()) = halfSpace(i).slope.transpose();
        }
        multipliers_.setZero();
    }

    /// Moves `y` to the minimum. False, with `y` spoilt, when it does not get there.
    bool solve(Eigen::Ref<VectorXd> y, double tolerance) {
        double best = isWithin(program_, y) ? reachedNear(y) : kInfinity;
        double s = std::min(kLargest, reachedNear(y));
        double caution = kFirstCaution;
        const std::span<bool> last = room_.list<bool>(static_cast<std::size_t>(rowCount_));
        bool settled = false;
        for (int k = 0; k < kMostSteps; ++k) {
            linearise(y, s, caution);
            minimise({hessian_, right_, rows_, bounds_}, step_, multipliers_);
            next_ = y + step_.head(y.size());
            const double reached = reachedNear(next_);
            const double promised = -step_[y.size()];
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
            y = next_;
            best = reached;
            if (!isWithin(program_, y)) {
                return false;  // the half-spaces leave nothing
            }
            s = std::isfinite(reached) ? reached : std::max(tolerance, s + step_[y.size()]);
            if (reached <= tolerance) {
                return true;  // there is no less than none
            }
            const bool same = takeActive(last);
            if (settled && same && std::isfinite(reached)) {
                Scratch room;
                const Holding holding = holdingNow(room);
                Scratch::Vector sharp = room.vector(y);
                if (Sharpening(program_, holding).solve(sharp, s)) {
                    y = sharp;
                    return true;
                }
            }
            settled = true;
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
    double reachedNear(const Given& y) const {
        const double reached = program_.reached(y);
        return reached <= kLargest ? reached : kInfinity;
    }

    const HalfSpace& halfSpace(Index row) const {
        return program_.halfSpaces()[static_cast<std::size_t>(row - cones_)];
    }

    /// Notes which rows are active. Whether they are those noted before.
    bool takeActive(std::span<bool> noted) const {
        bool same = true;
        for (std::size_t i = 0; i < noted.size(); ++i) {
            const bool active = multipliers_[static_cast<Index>(i)] > 0.0;
            same = same && active == noted[i];
            noted[i] = active;
        }
        return same;
    }

    void linearise(const Given& y, double s, double caution) {
        const Index n = y.size();
        hessian_.setZero();
        hessian_.diagonal().setConstant(caution);
        hessian_(n, n) = kProximal;
        for (Index i = 0; i < cones_; ++i) {
            const Cone& cone = program_.cones()[static_cast<std::size_t>(i)];
            Scratch room;
            const Scratch::Vector v = cone.vector(room, y);
            const double length = v.norm();
            const double reach = cone.reach(y);
            along_.setZero();
            if (length > kLeastLength) {
                along_.noalias() = cone.rows.transpose().lazyProduct(v) / length;
                if (cone.rows.rows() > 1 && multipliers_[i] > 0.0) {
                    addBend(cone, multipliers_[i] / length, along_, hessian_.topLeftCorner(n, n));
                }
            }
            rows_.row(i).head(n) = (s * cone.slope - along_).transpose();
            rows_(i, n) = std::max(kLeastReach, reach);
            bounds_[i] = length - s * reach;
        }
        for (Index i = cones_; i < rowCount_; ++i) {
            bounds_[i] = -halfSpace(i).room(y);
        }
    }

    Holding holdingNow(Scratch& room) const {
        Holding holding(room, program_);
        for (Index i = 0; i < rowCount_; ++i) {
            if (!(multipliers_[i] > 0.0)) {
                continue;
            }
            if (i < cones_) {
                holding.add(program_.cones()[static_cast<std::size_t>(i)], multipliers_[i]);
            } else {
                holding.add(halfSpace(i), multipliers_[i]);
            }
        }
        return holding;
    }

    Scratch room_;
    const QuasiConvexProgram& program_;
    const Index cones_, rowCount_;
    // The quadratic program of the steps of y and s.
    Scratch::Matrix hessian_;
    Scratch::Vector right_;
    Scratch::Matrix rows_;
    Scratch::Vector bounds_;
    Scratch::Vector step_, multipliers_;
    Scratch::Vector next_, along_;
};

/// The method of centers: the best place within all borders, which are then drawn closer.
class Centers {
  public:
    explicit Centers(const QuasiConvexProgram& program)
        : program_(program),
          step_(room_.vector(program.unknowns())),
          gradient_(room_.vector(program.unknowns())),
          slope_(room_.vector(program.unknowns())),
          tried_(room_.vector(program.unknowns())),
          hessian_(room_.matrix(program.unknowns(), program.unknowns())) {}

    /// From a `y` inside all half-spaces, until it shows what holds the minimum, which then is
    /// found at once; to `tolerance` where that does not do.
    void solve(Eigen::Ref<VectorXd> y, double tolerance) {
        for (double coarse = 0.1; coarse > 2.0 * tolerance; coarse *= 0.1) {
            minimise(y, coarse * std::max(1e-3, program_.reached(y)));
            const double s = program_.reached(y);
            Scratch room;
            const Holding holding = holdingNear(room, program_, y, s);
            Scratch::Vector sharp = room.vector(y);
            if (Sharpening(program_, holding).solve(sharp, s)) {
                y = sharp;
                return;
            }
        }
        minimise(y, tolerance);
    }

    /// Some y within all half-spaces, away from their borders. False when there is none.
    bool findInterior(Eigen::Ref<VectorXd> y) {
        double least = slack(y);
        // Newton's method on the barrier of limits relaxed ever less, until none need be.
        for (int k = 0; k < kMaxCenters; ++k) {
            if (least > 1e-6) {
                return true;
            }
            const double relaxed = -least + 0.1 * std::max(1e-6, std::abs(least)) + 1e-6;
            for (int iteration = 0; iteration < kMaxNewton; ++iteration) {
                gradient_.setZero();
                hessian_.setZero();
                addHalfSpaces(y, relaxed);
                const double decrease = descend(std::max(1e-300, hessian_.diagonal().maxCoeff()));
                if (!(decrease > 1e-6)) {
                    break;
                }
                double share = 1.0;
                const auto outside = [&] {
                    tried_ = y + share * step_;
                    return slack(tried_) + relaxed <= 0.0;
                };
                while (outside() && share > 1e-12) {
                    share *= 0.5;
                }
                // Damped as self-concordance asks: the barrier falls for certain.
                share = std::min(share, 1.0 / (1.0 + std::sqrt(decrease)));
                y += share * step_;
            }
            const double next = slack(y);
            if (!(next > least + 1e-9)) {
                return false;
            }
            least = next;
        }
        return false;
    }

  private:
    /// From a `y` inside all of them, to `tolerance` of s.
    void minimise(Eigen::Ref<VectorXd> y, double tolerance) {
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

    double slack(const Given& y) const {
        double smallest = kInfinity;
        for (const HalfSpace& half : program_.halfSpaces()) {
            smallest = std::min(smallest, half.room(y));
        }
        return smallest;
    }

    /// Sum of -log of how far each is from its border; infinite outside.
    double barrier(const Given& y, double s) const {
        double sum = 0.0;
        for (const Cone& cone : program_.cones()) {
            const double reach = s * cone.reach(y);
            const double length = cone.length(y);
            const double room = reach * reach - length * length;
            if (!(reach > 0.0) || !(room > 0.0)) {
                return kInfinity;
            }
            sum -= weight() * std::log(room);
        }
        for (const HalfSpace& half : program_.halfSpaces()) {
            const double room = half.room(y);
            if (!(room > 0.0)) {
                return kInfinity;
            }
            sum -= std::log(room);
        }
        return sum;
    }

    /// Cones count for more than what only has to hold.
    double weight() const { return 1.0 + static_cast<double>(program_.halfSpaces().size()); }

    /// hessian += factor slope slope'.
    void addSquare(double factor, const Scratch::Vector& slope) {
        hessian_.noalias() += factor * slope.lazyProduct(slope.transpose());
    }

    /// @param relaxed  by how much their borders are further away
    void addHalfSpaces(const Given& y, double relaxed) {
        for (const HalfSpace& half : program_.halfSpaces()) {
            const double room = half.room(y) + relaxed;
            gradient_ -= half.slope / room;
            addSquare(1.0 / (room * room), half.slope);
        }
    }

    void addCones(const Given& y, double s) {
        for (const Cone& cone : program_.cones()) {
            Scratch room;
            const Scratch::Vector v = cone.vector(room, y);
            const double reach = s * cone.reach(y);
            const double left = reach * reach - v.squaredNorm();
            slope_ = 2.0 * s * reach * cone.slope;
            slope_.noalias() -= 2.0 * cone.rows.transpose().lazyProduct(v);
            gradient_ -= weight() / left * slope_;
            addSquare(weight() / (left * left), slope_);
            addSquare(-weight() * 2.0 * s * s / left, cone.slope);
            hessian_.noalias() +=
                weight() * 2.0 / left * cone.rows.transpose().lazyProduct(cone.rows);
        }
    }

    /// The step of Newton's method. By how much the barrier would fall.
    /// @param largest  of the hessian's diagonal: what nothing bounds stays where it is
    double descend(double largest) {
        hessian_.diagonal().array() += 1e-14 * largest;
        step_ = -gradient_;
        eliminate(hessian_, step_);
        return -gradient_.dot(step_);
    }

    void center(Eigen::Ref<VectorXd> y, double s) {
        double value = barrier(y, s);
        for (int iteration = 0; iteration < kMaxNewton; ++iteration) {
            gradient_.setZero();
            hessian_.setZero();
            addCones(y, s);
            addHalfSpaces(y, 0.0);
            const double decrease = descend(hessian_.diagonal().maxCoeff());
            if (!(decrease > 1e-10)) {
                return;
            }
            double share = 1.0;
            double next = 0.0;
            const auto tooHigh = [&] {
                tried_ = y + share * step_;
                next = barrier(tried_, s);
                return !(next <= value - 0.1 * share * decrease);
            };
            while (tooHigh() && share > 1e-10) {
                share *= 0.5;
            }
            if (share <= 1e-10) {
                return;
            }
            y = tried_;
            value = next;
        }
    }

    Scratch room_;
    const QuasiConvexProgram& program_;
    Scratch::Vector step_, gradient_, slope_, tried_;
    Scratch::Matrix hessian_;
};

}  // namespace

QuasiConvexProgram::QuasiConvexProgram(Scratch& room, Index unknowns, std::size_t cones,
                                       std::size_t halfSpaces)
    : room_(room),
      unknowns_(unknowns),
      cones_(room.list<Cone>(cones)),
      halfSpaces_(room.list<HalfSpace>(halfSpaces)) {}

Cone& QuasiConvexProgram::addCone(Index rows) {
    // Constructed where it stands: a map is told its place only when it is made.
    Cone* const cone = std::construct_at(
        &cones_[coneCount_++],
        Cone{room_.matrix(rows, unknowns_), room_.vector(rows), room_.vector(unknowns_), 0.0});
    cone->rows.setZero();
    cone->offsets.setZero();
    cone->slope.setZero();
    return *cone;
}

HalfSpace& QuasiConvexProgram::addHalfSpace() {
    HalfSpace* const half =
        std::construct_at(&halfSpaces_[halfSpaceCount_++], HalfSpace{room_.vector(unknowns_), 0.0});
    half->slope.setZero();
    return *half;
}

double QuasiConvexProgram::reached(const Given& y) const {
    double s = 0.0;
    for (const Cone& cone : cones()) {
        const double reach = cone.reach(y);
        if (!(reach > 0.0)) {
            return kInfinity;
        }
        s = std::max(s, cone.length(y) / reach);
    }
    return s;
}

bool minimise(const QuasiConvexProgram& program, Eigen::Ref<VectorXd> y, double tolerance) {
    Scratch room;
    Scratch::Vector sharp = room.vector(y);
    if (const double s = program.reached(y); std::isfinite(s)) {
        const Holding holding = holdingNear(room, program, y, s);
        if (Sharpening(program, holding).solve(sharp, s)) {
            y = sharp;
            return true;
        }
    }
    sharp = y;
    if (Sequence(program).solve(sharp, tolerance)) {
        y = sharp;
        return true;
    }
    Centers centers(program);
    if (!centers.findInterior(y)) {
        return false;
    }
    centers.solve(y, tolerance);
    return true;
}

}  // namespace simcore::statics
