#include "simcore/statics/traction.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

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
/// Loads of one wheel beyond this many rovers are not looked for: where joints are nearly locked,
/// wheels that press against each other could raise theirs without end.
constexpr double kMostRovers = 20.0;

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
    std::copy_if(equilibrium_.torque.begin(), equilibrium_.torque.end(),
                 std::back_inserter(torques_), [](int column) { return column >= 0; });
    const MatrixXd& matrix = equilibrium_.matrix;
    const VectorXd& right = equilibrium_.right;
    const Eigen::Index n = matrix.cols();
    Eigen::ColPivHouseholderQR<MatrixXd> qr(matrix.transpose());
    qr.setThreshold(kDependent);
    const Eigen::Index rank = qr.rank();
    const VectorXd permuted = qr.colsPermutation().transpose() * right;
    // U0 in the rows of M, and K square to them.
    MatrixXd solved = MatrixXd::Zero(n, 1 + n - rank);
    solved.col(0).head(rank) = qr.matrixR()
                                   .topLeftCorner(rank, rank)
                                   .template triangularView<Eigen::Upper>()
                                   .transpose()
                                   .solve(permuted.head(rank));
    solved.bottomRightCorner(n - rank, n - rank).setIdentity();
    solved.applyOnTheLeft(qr.householderQ());
    some_ = solved.col(0);
    motions_ = solved.rightCols(n - rank);
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
        equilibrium_.matrix.cols() - static_cast<Eigen::Index>(torques_.size());
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
    right.applyOnTheLeft(decomposition.householderQ().adjoint());
    const auto open = right.bottomRows(rows - decomposition.rank());
    wanted_ = open.col(0);
    conditions_ = -open.rightCols(wheels);
}

Forces Traction::forcesOf(const Eigen::Ref<const VectorXd>& unknowns) const {
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
    for (const int column : equilibrium_.stop) {
        forces.stop.push_back(at(column));
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
    for (std::size_t i = 0; i < forces.stop.size(); ++i) {
        unknowns[equilibrium_.stop[i]] = forces.stop[i];
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
    return forces.minNormal() >= 0.0 && std::all_of(forces.stop.begin(), forces.stop.end(),
                                                    [](double moment) { return moment >= 0.0; });
}

/// The forces of torques in these proportions. False when none of them hold the rover.
/// @param shares  of every wheel
bool Traction::withShares(const Scratch::Vector& shares, Scratch::Vector& unknowns) const {
    Scratch room;
    Scratch::Vector asked = room.vector(wanted_.size());
    asked.noalias() = conditions_ * shares;
    const double square = asked.squaredNorm();
    const double common = square > 0.0 ? asked.dot(wanted_) / square : 0.0;
    if (!((asked * common - wanted_).lpNorm<1>() <= kBalanced * scale_)) {
        return false;
    }
    auto forces = unknowns.head(withoutTorque_.size());
    forces = withoutTorque_;
    forces.noalias() += common * (perTorque_ * shares);
    for (std::size_t w = 0; w < radii_.size(); ++w) {
        if (equilibrium_.torque[w] >= 0) {
            unknowns[equilibrium_.torque[w]] = common * shares[static_cast<Eigen::Index>(w)];
        }
    }
    return true;
}

Solution Traction::equalTorque() const {
    Solution solution;
    // Differences between the torques vanish: one equation for each wheel after the first.
    const std::vector<int>& torques = torques_;
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
    Scratch room;
    solution = search(some, motions, room.vector(VectorXd::Zero(motions.cols())),
                      Objective::Friction, 1e-8);
    if (solution.way != Way::None) {
        solution.way = Way::Equal;
    }
    return solution;
}

Solution Traction::fixedPoint() const {
    Solution none;
    const auto wheels = static_cast<Eigen::Index>(radii_.size());
    Scratch room;
    Scratch::Vector shares = room.vector(VectorXd::Ones(wheels));
    Scratch::Vector next = room.vector(wheels);
    Scratch::Vector unknowns = room.vector(VectorXd::Zero(some_.size()));
    bool holds = withShares(shares, unknowns);
    for (int k = 0; holds && k < kMaxFixedPoint; ++k) {
        next.setZero();
        for (std::size_t i = 0; i < wheelOf_.size(); ++i) {
            const double load = unknowns[equilibrium_.normal[i]];
            if (!(load > 0.0)) {
                return none;
            }
            next[wheelOf_[i]] += load / load_ * radii_[static_cast<std::size_t>(wheelOf_[i])];
        }
        const double change = (next - shares).cwiseAbs().maxCoeff();
        shares += (k == 0 ? 1.0 : kDamping) * (next - shares);
        holds = withShares(shares, unknowns);
        if (holds && k > 0 && change < kFixedPointTolerance) {
            Solution solution;
            solution.forces = forcesOf(unknowns);
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
    Scratch room;
    Scratch::Vector y = room.vector(VectorXd::Zero(motions_.cols()));
    if (start.way != Way::None) {
        if (start.friction <= tolerance) {
            return start;  // there is no less than none
        }
        y.noalias() = motions_.transpose() * (unknownsOf(start.forces) - some_);
    }
    Solution found = search(some_, motions_, y, objective, tolerance);
    if (start.way != Way::None &&
        (found.way == Way::None || start.friction <= found.friction + tolerance)) {
        return start;
    }
    return found;
}

/// The best forces some + motions y for an objective, from near `y`.
Solution Traction::search(const VectorXd& some, const MatrixXd& motions, Scratch::Vector y,
                          Objective objective, double tolerance) const {
    Scratch room;
    const QuasiConvexProgram program = programOf(room, some, motions, objective);
    y /= load_;
    if (!minimise(program, y, tolerance)) {
        return {};
    }
    Scratch::Vector unknowns = room.vector(some);
    unknowns.noalias() += load_ * (motions * y);
    Solution found;
    found.way = Way::Search;
    found.forces = forcesOf(unknowns);
    found.friction = found.forces.maxRatio();
    return found;
}

/// The best y of forces some + motions y, in loads of a wheel.
QuasiConvexProgram Traction::programOf(Scratch& room, const VectorXd& some, const MatrixXd& motions,
                                       Objective objective) const {
    const std::size_t contacts = wheelOf_.size();
    const std::size_t wheels = radii_.size();
    QuasiConvexProgram program(room, motions.cols(), contacts + wheels,
                               2 * (contacts + wheels) + equilibrium_.stop.size());
    const auto addCone = [&](std::span<const int> columns) -> Cone& {
        Cone& cone = program.addCone(static_cast<Eigen::Index>(columns.size()));
        Eigen::Index row = 0;
        for (const int column : columns) {
            cone.rows.row(row) = motions.row(column);
            cone.offsets[row++] = some[column] / load_;
        }
        cone.start = 1.0;
        return cone;
    };
    // factor * unknown + start >= 0, of unknowns in loads.
    const auto addHalfSpace = [&](int column, double factor, double start) {
        HalfSpace& half = program.addHalfSpace();
        half.slope = factor * motions.row(column).transpose();
        half.start = start + factor * some[column] / load_;
    };
    for (std::size_t i = 0; i < contacts; ++i) {
        const int normal = equilibrium_.normal[i];
        if (objective == Objective::Friction) {
            const int columns[] = {equilibrium_.traction[i], equilibrium_.lateral[i]};
            Cone& cone = addCone(std::span(columns).first(columns[1] >= 0 ? 2 : 1));
            cone.slope = motions.row(normal).transpose();
            cone.start = some[normal] / load_;
        }
        addHalfSpace(normal, 1.0, 0.0);
        addHalfSpace(normal, -load_ / heaviest(), 1.0);
    }
    for (const int column : equilibrium_.stop) {
        addHalfSpace(column, 1.0, 0.0);
    }
    if (objective == Objective::Energy) {
        addCone(torques_);
    }
    for (std::size_t w = 0; w < wheels; ++w) {
        const int column = equilibrium_.torque[w];
        if (column < 0) {
            continue;
        }
        if (objective == Objective::Torque) {
            addCone(std::span(&column, 1));
        }
        addHalfSpace(column, load_ / torqueLimits_[w], 1.0);
        addHalfSpace(column, -load_ / torqueLimits_[w], 1.0);
    }
    return program;
}

}  // namespace simcore::statics
