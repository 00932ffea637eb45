#include "simcore/mobility/factorisation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/QR>

namespace simcore::mobility {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

// Pivots below this share of the largest count as zero; rover Jacobians have a gap of 1e10 there.
constexpr double kRankThreshold = 1e-9;

}  // namespace

Factorisation::Factorisation(const MatrixXd& jacobian) {
    const Index rows = jacobian.rows();
    const Index columns = jacobian.cols();
    if (rows == 0) {  // nothing is held; Eigen cannot factorise an empty matrix
        motions = MatrixXd::Identity(columns, columns);
        selfStress = MatrixXd(0, 0);
        return;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr;
    qr.setThreshold(kRankThreshold);
    qr.compute(jacobian.transpose());
    rank = qr.rank();
    const auto pivot = [&](Index i) { return std::abs(qr.matrixQR()(i, i)); };
    if (rank > 0) {
        const bool hasNext = rank < std::min(rows, columns);
        const double next = hasNext ? pivot(rank) : 0.0;
        gap = next > 0.0 ? pivot(rank - 1) / next : std::numeric_limits<double>::infinity();
    }
    motions = MatrixXd::Zero(columns, columns - rank);
    motions.bottomRows(columns - rank).setIdentity();
    motions.applyOnTheLeft(qr.householderQ());

    // J^T P = Q [R11 R12]: the self-stress states are P [-R11^-1 R12; 1].
    const Index redundant = rows - rank;
    MatrixXd basis(rows, redundant);
    if (redundant > 0) {
        basis.topRows(rank) = -qr.matrixQR().topRightCorner(rank, redundant);
        qr.matrixQR()
            .topLeftCorner(rank, rank)
            .triangularView<Eigen::Upper>()
            .solveInPlace(basis.topRows(rank));
        basis.bottomRows(redundant).setIdentity();
        const MatrixXd permuted = qr.colsPermutation() * basis;
        const Eigen::HouseholderQR<MatrixXd> orthonormal(permuted);
        basis = orthonormal.householderQ() * MatrixXd::Identity(rows, redundant);
    }
    selfStress = std::move(basis);
}

}  // namespace simcore::mobility
