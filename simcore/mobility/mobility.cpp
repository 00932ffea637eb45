#include "simcore/mobility/mobility.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <Eigen/QR>

#include "simcore/base/text.h"
#include "simcore/mobility/constraint_jacobian.h"
#include "simcore/mobility/factorisation.h"

namespace simcore::mobility {
namespace {

const std::string kContact = "contact ";

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double kNoMotion = 1e-9;

/// The motion of one body in a free motion of the whole.
IdleFreedom idleOf(const std::string& body, const Eigen::Matrix<double, 6, 1>& motion) {
    return {body, motion.tail<3>(), motion.head<3>()};
}

/// Free motions in which every body of `watched` stands still.
MatrixXd hiddenFrom(const std::vector<int>& watched, const ConstraintJacobian& jacobian,
                    const MatrixXd& motions) {
    MatrixXd visible(6 * static_cast<Index>(watched.size()), motions.cols());
    Index row = 0;
    for (const int body : watched) {
        const int column = jacobian.firstColumn[static_cast<std::size_t>(body)];
        if (column >= 0) {
            visible.middleRows(row, 6) = motions.middleRows(column, 6);
            row += 6;
        }
    }
    visible.conservativeResize(row, Eigen::NoChange);
    if (row == 0) {
        return motions;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr(visible.transpose());
    qr.setThreshold(kNoMotion);
    const Index hidden = motions.cols() - qr.rank();
    MatrixXd combination = MatrixXd::Zero(motions.cols(), hidden);
    combination.bottomRows(hidden).setIdentity();
    combination.applyOnTheLeft(qr.householderQ());
    return motions * combination;
}

/// The body that moves most, for every motion.
std::vector<IdleFreedom> nameByBody(const mechanism::Mechanism& mechanism,
                                    const ConstraintJacobian& jacobian, const MatrixXd& motions) {
    std::vector<IdleFreedom> found;
    for (Index k = 0; k < motions.cols(); ++k) {
        std::size_t most = 0;
        double largest = 0.0;
        for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
            const int column = jacobian.firstColumn[b];
            const double size = column < 0 ? 0.0 : motions.col(k).segment<6>(column).norm();
            if (size > largest + 1e-12) {
                largest = size;
                most = b;
            }
        }
        const int column = jacobian.firstColumn[most];
        found.push_back(
            idleOf(mechanism.bodies[most].name, motions.col(k).segment<6>(column) / largest));
    }
    return found;
}

/// Free motions of one body between two or more others that all stand still.
MatrixXd idleBetween(const mechanism::Mechanism& mechanism, const ConstraintJacobian& jacobian) {
    MatrixXd found(jacobian.matrix.cols(), 0);
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        std::set<int> neighbours;  // -1 is the world
        for (const mechanism::Joint& joint : mechanism.joints) {
            const int body = static_cast<int>(b);
            if (joint.first == body || joint.second == body) {
                const int other = joint.first == body ? joint.second : joint.first;
                const bool fixed = mechanism.bodies[static_cast<std::size_t>(other)].fixed;
                neighbours.insert(fixed ? -1 : other);
            }
        }
        const int column = jacobian.firstColumn[b];
        if (column < 0 || neighbours.size() < 2) {
            continue;
        }
        const Factorisation alone(jacobian.matrix.middleCols(column, 6));
        for (Index k = 0; k < alone.motions.cols(); ++k) {
            found.conservativeResize(Eigen::NoChange, found.cols() + 1);
            found.rightCols(1).setZero();
            found.rightCols(1).middleRows(column, 6) = alone.motions.col(k);
        }
    }
    return found;
}

void countJoints(const mechanism::Mechanism& mechanism, Model model, const Stance& stance,
                 Report& report) {
    const auto count = [&](std::size_t freedoms) {
        ++report.joints;
        if (freedoms >= 1 && freedoms <= 5) {
            ++report.jointsByFreedom[freedoms - 1];
        }
    };
    for (const mechanism::Joint& joint : mechanism.joints) {
        count(freedomsOf(joint, model).size());
    }
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        if (!stance.wheels[i].touching) {
            continue;
        }
        const mechanism::Wheel& wheel = mechanism.wheels[i];
        count(model == Model::Relaxed && wheel.relaxedLateral ? 4 : 3);
    }
    for (std::size_t i = 0; i < mechanism.gears.size(); ++i) {
        count(5);
    }
}

}  // namespace

MatrixXd idleMotions(const mechanism::Mechanism& mechanism, const ConstraintJacobian& jacobian,
                     const MatrixXd& motions) {
    if (motions.cols() == 0) {
        return motions;
    }
    if (mechanism.wheels.empty()) {  // nothing says which body does the work
        return idleBetween(mechanism, jacobian);
    }
    std::vector<int> watched{mechanism.chassis};
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        watched.push_back(wheel.body);
    }
    return hiddenFrom(watched, jacobian, motions);
}

std::vector<std::size_t> chooseRedundantSet(const MatrixXd& selfStress,
                                            const std::vector<Priority>& priorities) {
    std::vector<std::size_t> order(priorities.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return static_cast<int>(priorities[a]) > static_cast<int>(priorities[b]);
    });
    std::vector<std::size_t> chosen;
    MatrixXd basis(selfStress.cols(), selfStress.cols());
    Index found = 0;
    for (const std::size_t row : order) {
        if (found == selfStress.cols()) {
            break;
        }
        Eigen::VectorXd v = selfStress.row(static_cast<Index>(row)).transpose();
        for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Kahan, Parlett)
            v -= basis.leftCols(found) * (basis.leftCols(found).transpose() * v);
        }
        if (v.norm() > 1e-6) {
            basis.col(found++) = v.normalized();
            chosen.push_back(row);
        }
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

Report analyse(const mechanism::Mechanism& mechanism, Model model) {
    return analyse(mechanism, model, drawnStance(mechanism));
}

Report analyse(const mechanism::Mechanism& mechanism, Model model, const Stance& stance) {
    const ConstraintJacobian jacobian = constraintJacobian(mechanism, model, stance);
    const Factorisation factors(jacobian.matrix);
    Report report;
    report.model = model;
    countJoints(mechanism, model, stance, report);
    report.columns = static_cast<int>(jacobian.matrix.cols());
    report.bodies = report.columns / 6;
    report.rows = static_cast<int>(jacobian.matrix.rows());
    report.gruebler = report.columns - report.rows;
    report.rank = static_cast<int>(factors.rank);
    report.mobility = report.columns - report.rank;
    report.redundant = report.rows - report.rank;
    report.rankGap = factors.gap;
    std::vector<ConstraintName> named = jacobian.names;
    for (std::size_t i = 0; i < named.size(); ++i) {
        named[i].share = factors.selfStress.row(static_cast<Index>(i)).squaredNorm();
        if (named[i].share > kNoShare) {
            report.removable.push_back(named[i]);
        }
    }
    std::stable_sort(
        report.removable.begin(), report.removable.end(),
        [](const ConstraintName& a, const ConstraintName& b) { return a.share > b.share + 1e-9; });
    for (const std::size_t row : chooseRedundantSet(factors.selfStress, jacobian.priorities)) {
        report.redundantSet.push_back(named[row]);
    }
    report.idle =
        nameByBody(mechanism, jacobian, idleMotions(mechanism, jacobian, factors.motions));
    return report;
}

std::string contactOf(const std::string& wheel) {
    return kContact + wheel;
}

std::string wheelOfContact(const std::string& element) {
    return element.starts_with(kContact) ? element.substr(kContact.size()) : std::string();
}

std::string describe(const Report& report) {
    std::string text;
    const auto add = [&](const std::string& sentence) { text += " " + sentence; };
    if (report.mobility == 0) {
        text = Text::of("Cannot move: the constraints hold every body.");
    } else if (report.mobility == 1) {
        text = Text::of("Moves with one freedom, as a rover on its wheels should.");
    } else {
        text = Text::of("Moves with {} freedoms.", report.mobility);
    }
    if (report.redundant > 0) {
        add(report.redundant == 1
                ? Text::of("Hyperstatic: 1 constraint repeats what others already hold. Its "
                           "reaction cannot be told from statics, and inaccurate parts strain "
                           "each other.")
                : Text::of("Hyperstatic: {} constraints repeat what others already hold. Their "
                           "reactions cannot be told from statics, and inaccurate parts strain "
                           "each other.",
                           report.redundant));
    } else {
        add(Text::of("Statically determinate: every reaction follows from the loads."));
    }
    if (report.gruebler != report.mobility) {
        add(Text::of("The Grübler count ({}) cannot see this.", report.gruebler));
    }
    if (!report.idle.empty()) {
        const std::size_t idle = report.idle.size();
        add(idle == 1
                ? Text::of("1 of the freedoms is idle: neither chassis nor wheels move.")
                : Text::of("{} of the freedoms are idle: neither chassis nor wheels move.", idle));
    }
    return text;
}

}  // namespace simcore::mobility
