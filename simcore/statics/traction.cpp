#include "simcore/statics/traction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace simcore::statics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Share of the largest pivot below which a row of M depends on the others.
constexpr double kDependent = 1e-10;
/// Unbalanced share of the loads up to which forces hold the rover: rounding.
constexpr double kBalanced = 1e-9;
constexpr int kMaxFixedPoint = 100;
constexpr double kFixedPointTolerance = 1e-11;
constexpr double kDamping = 0.5;
constexpr int kMaxCenters = 400;
constexpr int kMaxNewton = 30;
/// Loads of one wheel beyond this many rovers are not looked for: where joints are nearly locked,
/// wheels that press against each other could raise theirs without end.
constexpr double kMostRovers = 20.0;
/// Share of the way back from what a center reaches to what it was allowed.
constexpr double kBack = 0.1;

/// |rows y + offsets| <= s (slope y + start): s is to become small.
struct Cone {
    MatrixXd rows;
    VectorXd offsets;
    VectorXd slope;
    double start = 0.0;

    VectorXd vector(const VectorXd& y) const { return rows * y + offsets; }

    double reach(const VectorXd& y) const { return slope.dot(y) + start; }
};

/// slope y + start >= 0.
struct HalfSpace {
    VectorXd slope;
    double start = 0.0;
};

/// Minimises s over y within all half-spaces.
class Centers {
  public:
    std::vector<Cone> cones;
    std::vector<HalfSpace> halfSpaces;

    /// Centers until it shows which cones and half-spaces hold the minimum, then Newton's method on
    /// these alone; to `tolerance` by centers where that does not do.
    void solve(VectorXd& y, double tolerance) const {
        for (double coarse = 0.1; coarse > 2.0 * tolerance; coarse *= 0.1) {
            minimise(y, coarse * std::max(1e-3, reached(y)));
            VectorXd sharp = y;
            if (sharpen(sharp)) {
                y = sharp;
                return;
            }
        }
        minimise(y, tolerance);
    }

    /// Newton's method on the conditions of Karush, Kuhn and Tucker of what is near its border.
    /// False, with `y` spoilt, where that is not the minimum.
    bool sharpen(VectorXd& y) const {
        constexpr double kNear = 0.05;
        constexpr int kMost = 12;
        constexpr double kSmall = 1e-11;
        for (const Cone& cone : cones) {
            if (!(cone.reach(y) > 0.0)) {
                return false;
            }
        }
        const double before = reached(y);
        double s = before;
        std::vector<const Cone*> holding;
        std::vector<const HalfSpace*> limits;
        for (const Cone& cone : cones) {
            if (cone.vector(y).norm() > (1.0 - kNear) * s * cone.reach(y)) {
                holding.push_back(&cone);
            }
        }
        for (const HalfSpace& half : halfSpaces) {
            if (half.slope.dot(y) + half.start < 0.1 * kNear) {
                limits.push_back(&half);
            }
        }
        const Eigen::Index n = y.size();
        const auto c = static_cast<Eigen::Index>(holding.size());
        const auto h = static_cast<Eigen::Index>(limits.size());
        VectorXd multipliers = VectorXd::Zero(c + h);
        double open = 0.0;  // of the conditions
        double scale = 1e-12;
        for (const Cone* cone : holding) {
            scale = std::max(scale, cone->vector(y).norm());
        }
        for (int iteration = 0; iteration < kMost; ++iteration) {
            // Columns: y, s, multipliers. Rows: what the Lagrangian asks, then the borders.
            MatrixXd matrix = MatrixXd::Zero(n + 1 + c + h, n + 1 + c + h);
            VectorXd right = VectorXd::Zero(n + 1 + c + h);
            right[n] = -1.0;
            for (Eigen::Index i = 0; i < c; ++i) {
                const Cone& cone = *holding[static_cast<std::size_t>(i)];
                const VectorXd v = cone.vector(y);
                const double length = v.norm();
                if (!(length > 1e-9 * scale)) {
                    return false;
                }
                const VectorXd along = cone.rows.transpose() * v / length;
                matrix.topLeftCorner(n, n) +=
                    multipliers[i] / length *
                    (cone.rows.transpose() * cone.rows - along * along.transpose());
                const VectorXd slope = along - s * cone.slope;
                // Mixed derivatives of y and s.
                matrix.col(n).head(n) -= multipliers[i] * cone.slope;
                matrix.row(n).head(n) -= multipliers[i] * cone.slope.transpose();
                matrix.col(n + 1 + i).head(n) = slope;
                matrix.row(n + 1 + i).head(n) = slope.transpose();
                matrix(n, n + 1 + i) = -cone.reach(y);
                matrix(n + 1 + i, n) = -cone.reach(y);
                right[n + 1 + i] = s * cone.reach(y) - length;
            }
            for (Eigen::Index i = 0; i < h; ++i) {
                const HalfSpace& half = *limits[static_cast<std::size_t>(i)];
                matrix.col(n + 1 + c + i).head(n) = -half.slope;
                matrix.row(n + 1 + c + i).head(n) = -half.slope.transpose();
                right[n + 1 + c + i] = half.slope.dot(y) + half.start;
            }
            // Unknown are the steps of y and s, and the multipliers themselves.
            // What the conditions leave open stays where it is.
            matrix.diagonal().head(n).array() += kSmall;
            matrix.diagonal().tail(c + h).array() -= kSmall;
            const VectorXd step = matrix.partialPivLu().solve(right);
            if (!step.allFinite()) {
                return false;
            }
            open = (matrix * step - right).lpNorm<Eigen::Infinity>();
            y += step.head(n);
            s += step[n];
            multipliers = step.tail(c + h);
            const double moved = step.head(n).norm() / (1.0 + y.norm()) + std::abs(step[n]);
            if (iteration > 0 && moved < 1e-13) {
                break;
            }
        }
        for (const HalfSpace& half : halfSpaces) {
            if (half.slope.dot(y) + half.start < -1e-9) {
                return false;
            }
        }
        for (const Cone& cone : cones) {
            if (!(cone.reach(y) > 0.0)) {
                return false;
            }
        }
        const double least = multipliers.size() > 0 ? multipliers.minCoeff() : 0.0;
        const double most = multipliers.size() > 0 ? multipliers.maxCoeff() : 0.0;
        return open < 1e-7 && reached(y) <= std::min(before, s + 1e-10) + 1e-12 &&
               least >= -1e-9 * most;
    }

    /// The least s that y is allowed with.
    double reached(const VectorXd& y) const {
        double s = 0.0;
        for (const Cone& cone : cones) {
            s = std::max(s, cone.vector(y).norm() / cone.reach(y));
        }
        return s;
    }

    /// From a `y` inside all of them, to `tolerance` of s.
    void minimise(VectorXd& y, double tolerance) const {
        double allowed = 1.5 * reached(y) + tolerance;
        for (int k = 0; k < kMaxCenters; ++k) {
            center(y, allowed);
            const double s = reached(y);
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

  private:
    /// Sum of -log of how far each is from its border; infinite outside.
    double barrier(const VectorXd& y, double s) const {
        double sum = 0.0;
        for (const Cone& cone : cones) {
            const double reach = s * cone.reach(y);
            const double room = reach * reach - cone.vector(y).squaredNorm();
            if (!(reach > 0.0) || !(room > 0.0)) {
                return std::numeric_limits<double>::infinity();
            }
            sum -= weight() * std::log(room);
        }
        for (const HalfSpace& half : halfSpaces) {
            const double room = half.slope.dot(y) + half.start;
            if (!(room > 0.0)) {
                return std::numeric_limits<double>::infinity();
            }
            sum -= std::log(room);
        }
        return sum;
    }

    /// Cones count for more than what only has to hold.
    double weight() const { return 1.0 + static_cast<double>(halfSpaces.size()); }

    void center(VectorXd& y, double s) const {
        const Eigen::Index n = y.size();
        double value = barrier(y, s);
        for (int iteration = 0; iteration < kMaxNewton; ++iteration) {
            VectorXd gradient = VectorXd::Zero(n);
            MatrixXd hessian = MatrixXd::Zero(n, n);
            for (const Cone& cone : cones) {
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
            for (const HalfSpace& half : halfSpaces) {
                const double room = half.slope.dot(y) + half.start;
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
};

}  // namespace

double Forces::ratio(std::size_t contact) const {
    const double tangential = std::hypot(traction[contact], lateral[contact]);
    if (normal[contact] > 0.0) {
        return tangential / normal[contact];
    }
    return tangential > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

double Forces::maxRatio() const {
    double most = 0.0;
    for (std::size_t i = 0; i < normal.size(); ++i) {
        most = std::max(most, ratio(i));
    }
    return most;
}

double Forces::maxTorque() const {
    double most = 0.0;
    for (const double t : torque) {
        most = std::max(most, std::abs(t));
    }
    return most;
}

double Forces::minNormal() const {
    return normal.empty() ? 0.0 : *std::min_element(normal.begin(), normal.end());
}

Traction::Traction(const Equilibrium& equilibrium, const mechanism::Mechanism& mechanism,
                   std::span<const Contact> contacts)
    : equilibrium_(equilibrium) {
    for (const Contact& contact : contacts) {
        wheelOf_.push_back(contact.wheel);
    }
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        torqueLimits_.push_back(wheel.torqueLimit);
        radii_.push_back(wheel.radius);
    }
    const MatrixXd& matrix = equilibrium_.matrix;
    const VectorXd& right = equilibrium_.right;
    const Eigen::Index n = matrix.cols();
    Eigen::ColPivHouseholderQR<MatrixXd> qr(matrix.transpose());
    qr.setThreshold(kDependent);
    const Eigen::Index rank = qr.rank();
    const MatrixXd q = qr.householderQ() * MatrixXd::Identity(n, n);
    const VectorXd permuted = qr.colsPermutation().transpose() * right;
    const VectorXd z = qr.matrixR()
                           .topLeftCorner(rank, rank)
                           .template triangularView<Eigen::Upper>()
                           .transpose()
                           .solve(permuted.head(rank));
    some_ = q.leftCols(rank) * z;
    motions_ = q.rightCols(n - rank);
    scale_ = std::max(1e-12, right.cwiseAbs().maxCoeff());
    imbalance_ = (matrix * some_ - right).cwiseAbs().maxCoeff() / scale_;
    solveForTorques();
    const auto count = static_cast<double>(std::max<std::size_t>(1, wheelOf_.size()));
    load_ = std::max(1e-9, mechanism.mass()) * 10.0 / count;
}

/// The forces at the contacts by the torques, and what the torques must fulfil for there to be any.
void Traction::solveForTorques() {
    const auto wheels = static_cast<Eigen::Index>(radii_.size());
    const Eigen::Index others =
        equilibrium_.matrix.cols() - std::count_if(equilibrium_.torque.begin(),
                                                   equilibrium_.torque.end(),
                                                   [](int column) { return column >= 0; });
    const Eigen::Index rows = equilibrium_.matrix.rows();
    MatrixXd right(rows, 1 + wheels);
    right.setZero();
    right.col(0) = equilibrium_.right;
    for (std::size_t w = 0; w < radii_.size(); ++w) {
        if (equilibrium_.torque[w] >= 0) {
            right.col(1 + static_cast<Eigen::Index>(w)) =
                -equilibrium_.matrix.col(equilibrium_.torque[w]);
        }
    }
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
    decomposition.setThreshold(kDependent);
    decomposition.compute(equilibrium_.matrix.leftCols(others));
    const MatrixXd solved = decomposition.solve(right);
    withoutTorque_ = solved.col(0);
    perTorque_ = solved.rightCols(wheels);
    const MatrixXd q = decomposition.householderQ() * MatrixXd::Identity(rows, rows);
    const MatrixXd open = q.rightCols(rows - decomposition.rank()).transpose() * right;
    wanted_ = open.col(0);
    conditions_ = -open.rightCols(wheels);
}

Forces Traction::forcesOf(const VectorXd& unknowns) const {
    const auto at = [&](int column) { return column >= 0 ? unknowns[column] : 0.0; };
    Forces forces;
    for (std::size_t i = 0; i < wheelOf_.size(); ++i) {
        forces.normal.push_back(at(equilibrium_.normal[i]));
        forces.traction.push_back(at(equilibrium_.traction[i]));
        forces.lateral.push_back(at(equilibrium_.lateral[i]));
    }
    for (const int column : equilibrium_.torque) {
        forces.torque.push_back(at(column));
    }
    return forces;
}

VectorXd Traction::unknownsOf(const Forces& forces) const {
    VectorXd unknowns = VectorXd::Zero(some_.size());
    for (std::size_t i = 0; i < wheelOf_.size(); ++i) {
        unknowns[equilibrium_.normal[i]] = forces.normal[i];
        unknowns[equilibrium_.traction[i]] = forces.traction[i];
        if (equilibrium_.lateral[i] >= 0) {
            unknowns[equilibrium_.lateral[i]] = forces.lateral[i];
        }
    }
    for (std::size_t w = 0; w < radii_.size(); ++w) {
        if (equilibrium_.torque[w] >= 0) {
            unknowns[equilibrium_.torque[w]] = forces.torque[w];
        }
    }
    return unknowns;
}

double Traction::residual(const Forces& forces) const {
    const VectorXd& right = equilibrium_.right;
    return (equilibrium_.matrix * unknownsOf(forces) - right).cwiseAbs().maxCoeff() / scale_;
}

Forces Traction::moved(const Forces& forces, int axis, double step) const {
    return forcesOf(unknownsOf(forces) + step * motions_.col(axis));
}

double Traction::heaviest() const {
    return kMostRovers * load_ * static_cast<double>(wheelOf_.size());
}

Forces Traction::under(const std::vector<double>& torques) const {
    const VectorXd given = VectorXd::Map(torques.data(), static_cast<Eigen::Index>(torques.size()));
    VectorXd unknowns = VectorXd::Zero(some_.size());
    unknowns.head(withoutTorque_.size()) = withoutTorque_ + perTorque_ * given;
    for (std::size_t w = 0; w < radii_.size(); ++w) {
        if (equilibrium_.torque[w] >= 0) {
            unknowns[equilibrium_.torque[w]] = torques[w];
        }
    }
    return forcesOf(unknowns);
}

bool Traction::allowed(const Forces& forces) const {
    for (std::size_t w = 0; w < forces.torque.size(); ++w) {
        if (std::abs(forces.torque[w]) > torqueLimits_[w] * (1.0 + 1e-9)) {
            return false;
        }
    }
    return forces.minNormal() >= 0.0;
}

/// The forces of torques in these proportions; nothing when none of them hold the rover.
/// @param shares  of every wheel
std::optional<VectorXd> Traction::withShares(const VectorXd& shares) const {
    const VectorXd asked = conditions_ * shares;
    const double square = asked.squaredNorm();
    const double common = square > 0.0 ? asked.dot(wanted_) / square : 0.0;
    if (!((asked * common - wanted_).lpNorm<1>() <= kBalanced * scale_)) {
        return std::nullopt;
    }
    VectorXd unknowns = VectorXd::Zero(some_.size());
    const Eigen::Index others = withoutTorque_.size();
    unknowns.head(others) = withoutTorque_ + common * (perTorque_ * shares);
    for (std::size_t w = 0; w < radii_.size(); ++w) {
        if (equilibrium_.torque[w] >= 0) {
            unknowns[equilibrium_.torque[w]] = common * shares[static_cast<Eigen::Index>(w)];
        }
    }
    return unknowns;
}

Solution Traction::equalTorque() const {
    Solution solution;
    // Differences between the torques vanish: one equation for each wheel after the first.
    std::vector<int> torques;
    for (const int column : equilibrium_.torque) {
        if (column >= 0) {
            torques.push_back(column);
        }
    }
    if (torques.empty() || imbalance_ > kBalanced) {
        return solution;
    }
    const auto rows = static_cast<Eigen::Index>(torques.size()) - 1;
    MatrixXd differences(rows, motions_.cols());
    VectorXd wanted(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const int column = torques[static_cast<std::size_t>(i) + 1];
        differences.row(i) = motions_.row(column) - motions_.row(torques[0]);
        wanted[i] = some_[torques[0]] - some_[column];
    }
    VectorXd some = some_;
    MatrixXd motions = motions_;
    if (rows > 0 && motions_.cols() == 0 && wanted.cwiseAbs().maxCoeff() > kBalanced * scale_) {
        return solution;
    }
    if (rows > 0 && motions_.cols() > 0) {
        Eigen::ColPivHouseholderQR<MatrixXd> qr(differences.transpose());
        qr.setThreshold(kDependent);
        const MatrixXd q = qr.householderQ() * MatrixXd::Identity(motions_.cols(), motions_.cols());
        const VectorXd step = differences.completeOrthogonalDecomposition().solve(wanted);
        if ((differences * step - wanted).cwiseAbs().maxCoeff() > kBalanced * scale_) {
            return solution;
        }
        some += motions_ * step;
        motions = motions_ * q.rightCols(motions_.cols() - qr.rank());
    }
    if (motions.cols() == 0) {
        solution.forces = forcesOf(some);
        solution.way = Way::Equal;
        solution.friction = solution.forces.maxRatio();
        return solution;
    }
    solution = search(some, motions, VectorXd::Zero(motions.cols()), Objective::Friction, 1e-8);
    if (solution.way != Way::None) {
        solution.way = Way::Equal;
    }
    return solution;
}

Solution Traction::fixedPoint() const {
    Solution none;
    const auto wheels = static_cast<Eigen::Index>(radii_.size());
    VectorXd shares = VectorXd::Ones(wheels);
    std::optional<VectorXd> unknowns = withShares(shares);
    for (int k = 0; unknowns && k < kMaxFixedPoint; ++k) {
        VectorXd next = VectorXd::Zero(wheels);
        for (std::size_t i = 0; i < wheelOf_.size(); ++i) {
            const double load = (*unknowns)[equilibrium_.normal[i]];
            if (!(load > 0.0)) {
                return none;
            }
            next[wheelOf_[i]] += load / load_ * radii_[static_cast<std::size_t>(wheelOf_[i])];
        }
        const double change = (next - shares).cwiseAbs().maxCoeff();
        shares += (k == 0 ? 1.0 : kDamping) * (next - shares);
        unknowns = withShares(shares);
        if (unknowns && k > 0 && change < kFixedPointTolerance) {
            Solution solution;
            solution.forces = forcesOf(*unknowns);
            if (!allowed(solution.forces)) {
                return none;
            }
            solution.way = Way::FixedPoint;
            solution.friction = solution.forces.maxRatio();
            return solution;
        }
    }
    return none;
}

/// Some y with all loads and torques within their limits, away from them. False when there is none.
bool Traction::findInterior(const VectorXd& some, const MatrixXd& motions, VectorXd& y) const {
    // One more coordinate: by how much the limits are relaxed.
    const Eigen::Index n = motions.cols();
    std::vector<std::pair<VectorXd, double>> limits;
    const auto add = [&](const VectorXd& slope, double start, double scale) {
        limits.emplace_back(slope / scale, start / scale);
    };
    for (const int column : equilibrium_.normal) {
        add(motions.row(column).transpose(), some[column], load_);
        add(-motions.row(column).transpose(), heaviest() - some[column], heaviest());
    }
    for (std::size_t w = 0; w < torqueLimits_.size(); ++w) {
        const int column = equilibrium_.torque[w];
        if (column >= 0) {
            const VectorXd slope = motions.row(column).transpose();
            add(slope, torqueLimits_[w] + some[column], load_ * radii_[w]);
            add(-slope, torqueLimits_[w] - some[column], load_ * radii_[w]);
        }
    }
    double least = std::numeric_limits<double>::infinity();
    const auto slack = [&](const VectorXd& at) {
        double smallest = std::numeric_limits<double>::infinity();
        for (const auto& [slope, start] : limits) {
            smallest = std::min(smallest, slope.dot(at) + start);
        }
        return smallest;
    };
    least = slack(y);
    // Newton's method on the barrier of limits relaxed ever less, until none need be.
    for (int k = 0; k < kMaxCenters; ++k) {
        if (least > 1e-6) {
            return true;
        }
        const double relaxed = -least + 0.1 * std::max(1e-6, std::abs(least)) + 1e-6;
        for (int iteration = 0; iteration < kMaxNewton; ++iteration) {
            VectorXd gradient = VectorXd::Zero(n);
            MatrixXd hessian = MatrixXd::Zero(n, n);
            for (const auto& [slope, start] : limits) {
                const double room = slope.dot(y) + start + relaxed;
                gradient -= slope / room;
                hessian.noalias() += slope * slope.transpose() / (room * room);
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

Solution Traction::best(Objective objective, double tolerance) const {
    Solution none;
    if (imbalance_ > kBalanced) {
        return none;
    }
    if (motions_.cols() == 0) {
        Solution only;
        only.forces = forcesOf(some_);
        only.way = allowed(only.forces) ? Way::Search : Way::None;
        only.friction = only.forces.maxRatio();
        return only;
    }
    Solution start = objective == Objective::Friction ? fixedPoint() : Solution{};
    VectorXd y = VectorXd::Zero(motions_.cols());
    if (start.way != Way::None) {
        y = motions_.transpose() * (unknownsOf(start.forces) - some_);
    }
    Solution found = search(some_, motions_, y, objective, tolerance);
    if (start.way != Way::None &&
        (found.way == Way::None || start.friction <= found.friction + tolerance)) {
        return start;
    }
    return found;
}

/// The best forces some + motions y for an objective, from near `y`.
Solution Traction::search(const VectorXd& some, const MatrixXd& motions, VectorXd y,
                          Objective objective, double tolerance) const {
    Centers centers;
    const auto rowOf = [&](int column) { return motions.row(column); };
    for (std::size_t i = 0; i < wheelOf_.size(); ++i) {
        const int normal = equilibrium_.normal[i];
        if (objective == Objective::Friction) {
            Cone cone;
            cone.rows = MatrixXd::Zero(2, y.size());
            cone.offsets = VectorXd::Zero(2);
            cone.rows.row(0) = rowOf(equilibrium_.traction[i]);
            cone.offsets[0] = some[equilibrium_.traction[i]];
            if (equilibrium_.lateral[i] >= 0) {
                cone.rows.row(1) = rowOf(equilibrium_.lateral[i]);
                cone.offsets[1] = some[equilibrium_.lateral[i]];
            }
            cone.slope = rowOf(normal).transpose();
            cone.start = some[normal];
            centers.cones.push_back(std::move(cone));
        }
        centers.halfSpaces.push_back({rowOf(normal).transpose() / load_, some[normal] / load_});
        centers.halfSpaces.push_back(
            {-rowOf(normal).transpose() / heaviest(), 1.0 - some[normal] / heaviest()});
    }
    Cone all;
    std::vector<int> torques;
    for (std::size_t w = 0; w < radii_.size(); ++w) {
        const int column = equilibrium_.torque[w];
        if (column < 0) {
            continue;
        }
        torques.push_back(column);
        const VectorXd slope = rowOf(column).transpose() / torqueLimits_[w];
        const double offset = some[column] / torqueLimits_[w];
        centers.halfSpaces.push_back({slope, 1.0 + offset});
        centers.halfSpaces.push_back({-slope, 1.0 - offset});
        if (objective == Objective::Torque) {
            Cone cone;
            cone.rows = rowOf(column);
            cone.offsets = VectorXd::Constant(1, some[column]);
            cone.slope = VectorXd::Zero(y.size());
            cone.start = 1.0;
            centers.cones.push_back(std::move(cone));
        }
    }
    if (objective == Objective::Energy) {
        all.rows.resize(static_cast<Eigen::Index>(torques.size()), y.size());
        all.offsets.resize(all.rows.rows());
        for (std::size_t k = 0; k < torques.size(); ++k) {
            all.rows.row(static_cast<Eigen::Index>(k)) = rowOf(torques[k]);
            all.offsets[static_cast<Eigen::Index>(k)] = some[torques[k]];
        }
        all.slope = VectorXd::Zero(y.size());
        all.start = 1.0;
        centers.cones.push_back(std::move(all));
    }
    VectorXd sharp = y;
    if (centers.sharpen(sharp)) {
        y = sharp;
    } else if (findInterior(some, motions, y)) {
        centers.solve(y, tolerance);
    } else {
        return {};
    }
    Solution found;
    found.way = Way::Search;
    found.forces = forcesOf(some + motions * y);
    found.friction = found.forces.maxRatio();
    return found;
}

}  // namespace simcore::statics
