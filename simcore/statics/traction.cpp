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

    /// The least s that y is allowed with.
    double reached(const VectorXd& y) const {
        double s = 0.0;
        for (const Cone& cone : cones) {
            s = std::max(s, cone.vector(y).norm() / cone.reach(y));
        }
        return s;
    }

    /// From a `y` inside all of them, to `tolerance` of s, or until s is below `enough`.
    void minimise(VectorXd& y, double tolerance,
                  double enough = -std::numeric_limits<double>::infinity()) const {
        double allowed = 1.5 * reached(y) + tolerance;
        for (int k = 0; k < kMaxCenters; ++k) {
            center(y, allowed);
            const double s = reached(y);
            if (s <= enough || s <= tolerance) {
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
    const auto unknowns = withShares(VectorXd::Ones(static_cast<Eigen::Index>(radii_.size())));
    if (!unknowns) {
        return solution;
    }
    solution.forces = forcesOf(*unknowns);
    solution.way = Way::Equal;
    solution.friction = solution.forces.maxRatio();
    return solution;
}

Solution Traction::fixedPoint() const {
    const Solution none;
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
bool Traction::findInterior(VectorXd& y) const {
    // One more coordinate: by how much the limits are relaxed.
    const Eigen::Index n = motions_.cols();
    std::vector<std::pair<VectorXd, double>> limits;
    const auto add = [&](const VectorXd& slope, double start, double scale) {
        limits.emplace_back(slope / scale, start / scale);
    };
    for (const int column : equilibrium_.normal) {
        add(motions_.row(column).transpose(), some_[column], load_);
    }
    for (std::size_t w = 0; w < torqueLimits_.size(); ++w) {
        const int column = equilibrium_.torque[w];
        if (column >= 0) {
            const VectorXd slope = motions_.row(column).transpose();
            add(slope, torqueLimits_[w] + some_[column], load_ * radii_[w]);
            add(-slope, torqueLimits_[w] - some_[column], load_ * radii_[w]);
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
    const Solution start = objective == Objective::Friction ? fixedPoint() : Solution{};
    VectorXd y = VectorXd::Zero(motions_.cols());
    if (start.way != Way::None) {
        y = motions_.transpose() * (unknownsOf(start.forces) - some_);
    }
    if (!findInterior(y)) {
        return none;
    }
    Centers centers;
    const auto rowOf = [&](int column) { return motions_.row(column); };
    for (std::size_t i = 0; i < wheelOf_.size(); ++i) {
        const int normal = equilibrium_.normal[i];
        if (objective == Objective::Friction) {
            Cone cone;
            cone.rows = MatrixXd::Zero(2, y.size());
            cone.offsets = VectorXd::Zero(2);
            cone.rows.row(0) = rowOf(equilibrium_.traction[i]);
            cone.offsets[0] = some_[equilibrium_.traction[i]];
            if (equilibrium_.lateral[i] >= 0) {
                cone.rows.row(1) = rowOf(equilibrium_.lateral[i]);
                cone.offsets[1] = some_[equilibrium_.lateral[i]];
            }
            cone.slope = rowOf(normal).transpose();
            cone.start = some_[normal];
            centers.cones.push_back(std::move(cone));
        }
        centers.halfSpaces.push_back({rowOf(normal).transpose() / load_, some_[normal] / load_});
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
        const double offset = some_[column] / torqueLimits_[w];
        centers.halfSpaces.push_back({slope, 1.0 + offset});
        centers.halfSpaces.push_back({-slope, 1.0 - offset});
        if (objective == Objective::Torque) {
            Cone cone;
            cone.rows = rowOf(column);
            cone.offsets = VectorXd::Constant(1, some_[column]);
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
            all.offsets[static_cast<Eigen::Index>(k)] = some_[torques[k]];
        }
        all.slope = VectorXd::Zero(y.size());
        all.start = 1.0;
        centers.cones.push_back(std::move(all));
    }
    centers.minimise(y, tolerance);
    Solution found;
    found.way = Way::Search;
    found.forces = forcesOf(some_ + motions_ * y);
    found.friction = found.forces.maxRatio();
    if (start.way != Way::None && start.friction <= found.friction + tolerance) {
        return start;
    }
    return found;
}

}  // namespace simcore::statics
