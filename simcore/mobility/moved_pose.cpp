#include "simcore/mobility/moved_pose.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <Eigen/QR>

#include "simcore/mobility/constraint_system.h"
#include "simcore/mobility/factorisation.h"

namespace simcore::mobility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kClosed = 1e-12;
constexpr double kStep = 1e-2;        // of the wheelbase
constexpr double kLargestTurn = 0.1;  // [rad]: assumed, keeps Newton's method well inside its basin
constexpr int kMostIterations = 30;

/// What Newton's method reached.
struct Closing {
    Stance stance;
    VectorXd residual;  ///< of all rows
    bool closed = false;
};

/// Length of the free motion that makes the documented step.
double stepOf(const mechanism::Mechanism& mechanism, const ConstraintSystem& system,
              const VectorXd& motion) {
    const Vec3 reference =
        system.start().bodies[static_cast<std::size_t>(mechanism.chassis)].position;
    double slide = 0.0;
    double turn = 0.0;
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        const int column = system.firstColumn()[b];
        if (column >= 0) {
            const Vec3 arm = system.start().bodies[b] * mechanism.bodies[b].com - reference;
            const Vec3 w = motion.segment<3>(column + 3);
            const Vec3 v = motion.segment<3>(column) + w.cross(arm) / system.length();
            slide = std::max(slide, v.norm());
            turn = std::max(turn, w.norm());
        }
    }
    return 1.0 / std::max(slide / kStep, turn / kLargestTurn);
}

/// Rows `kept` closed again after `first`, corrections at right angles to the columns of `held`.
Closing close(const ConstraintSystem& system, const VectorXd& first, const MatrixXd& held,
              const std::vector<Index>& kept) {
    Closing result;
    result.stance = system.moved(system.start(), first);
    const auto rows = static_cast<Index>(kept.size());
    double previous = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostIterations; ++i) {
        result.residual = system.residual(result.stance);
        VectorXd rest(rows + held.cols());
        rest << result.residual(kept), VectorXd::Zero(held.cols());
        const double largest = rows > 0 ? rest.cwiseAbs().maxCoeff() : 0.0;
        result.closed = largest <= kClosed;
        if (result.closed || (i > 5 && largest > 0.999 * previous)) {
            break;
        }
        previous = largest;
        MatrixXd matrix(rows + held.cols(), system.columns());
        matrix << system.matrix(result.stance)(kept, Eigen::all), held.transpose();
        Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
        solver.setThreshold(1e-9);
        solver.compute(matrix);
        result.stance = system.moved(result.stance, solver.solve(-rest));
    }
    return result;
}

std::vector<Index> allRows(Index count) {
    std::vector<Index> rows(static_cast<std::size_t>(count));
    for (Index i = 0; i < count; ++i) {
        rows[static_cast<std::size_t>(i)] = i;
    }
    return rows;
}

void nameMotion(const mechanism::Mechanism& mechanism, const ConstraintSystem& system,
                const VectorXd& motion, FreeMotion& named) {
    double largest = 0.0;
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        const int column = system.firstColumn()[b];
        const double size = column < 0 ? 0.0 : motion.segment<6>(column).norm();
        if (size > largest + 1e-12) {
            largest = size;
            named.body = mechanism.bodies[b].name;
            named.slide = motion.segment<3>(column) / size;
            named.turn = motion.segment<3>(column + 3) / size;
        }
    }
}

}  // namespace

MovedPose movedPose(const mechanism::Mechanism& mechanism, Model model, const Stance& stance) {
    const ConstraintSystem system(mechanism, model, stance);
    const ConstraintJacobian jacobian = system.jacobian();
    const Factorisation present(jacobian.matrix);
    const Index rows = jacobian.matrix.rows();
    const std::vector<Index> all = allRows(rows);
    // Independent rows can be closed after any small step; what they leave of the others tells
    // which of those were redundant in this pose only.
    std::vector<Index> redundant;
    for (const std::size_t row : chooseRedundantSet(present.selfStress, jacobian.priorities)) {
        redundant.push_back(static_cast<Index>(row));
    }
    std::vector<Index> independent;
    std::set_difference(all.begin(), all.end(), redundant.begin(), redundant.end(),
                        std::back_inserter(independent));

    MovedPose result;
    result.rank = static_cast<int>(present.rank);
    result.rankGap = present.gap;
    bool any = false;
    for (Index k = 0; k < present.motions.cols(); ++k) {
        const VectorXd direction = present.motions.col(k);
        const VectorXd first = stepOf(mechanism, system, direction) * direction;
        FreeMotion motion;
        nameMotion(mechanism, system, direction, motion);
        Closing closing = close(system, first, present.motions, all);
        if (!closing.closed) {
            const Closing part = close(system, first, present.motions, independent);
            for (const Index row : redundant) {
                const double gap = std::abs(part.residual[row]);
                if (gap > 10.0 * kClosed) {
                    const ConstraintName& name = jacobian.names[static_cast<std::size_t>(row)];
                    motion.inconsistent.push_back(
                        {name, name.kind == "slide" ? gap * system.length() : gap});
                }
            }
            closing = close(system, first, direction, all);
            motion.continuation =
                closing.closed ? Continuation::Branch : Continuation::Infinitesimal;
        }
        motion.closure = rows > 0 ? closing.residual.cwiseAbs().maxCoeff() : 0.0;
        motion.reached = closing.stance;
        if (closing.closed) {
            const Factorisation there(system.matrix(closing.stance));
            if (!any || there.rank > result.rank) {
                result.rank = static_cast<int>(there.rank);
                result.rankGap = there.gap;
            }
            any = true;
            ++result.moving;
        }
        result.motions.push_back(std::move(motion));
    }
    result.mobility = system.columns() - result.rank;
    result.redundant = static_cast<int>(rows) - result.rank;
    return result;
}

}  // namespace simcore::mobility
