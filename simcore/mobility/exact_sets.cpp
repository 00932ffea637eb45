#include "simcore/mobility/exact_sets.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace simcore::mobility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Below this, a reaction follows from others. Self-stress states are orthonormal and good to
// about 1e-12; what is regular in rovers is above 1e-3.
constexpr double kDependent = 1e-6;

constexpr int kStepsBetweenStops = 64;

/// Orthonormal columns at right angles to all rows.
MatrixXd complementOf(const MatrixXd& rows) {
    const Index size = rows.cols();
    if (rows.rows() == 0) {
        return MatrixXd::Identity(size, size);
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr;
    qr.setThreshold(kDependent);
    qr.compute(rows.transpose());
    MatrixXd complement = MatrixXd::Zero(size, size - qr.rank());
    complement.bottomRows(complement.cols()).setIdentity();
    complement.applyOnTheLeft(qr.householderQ());
    return complement;
}

}  // namespace

ExactSetSearch::ExactSetSearch(std::vector<std::vector<Choice>> elements, int redundant)
    : elements_(std::move(elements)),
      redundant_(redundant),
      basis_(redundant, redundant),
      choice_(elements_.size(), -1) {
    for (const std::vector<Choice>& choices : elements_) {
        int most = 0;
        for (const Choice& choice : choices) {
            most = std::max(most, choice.cost);
        }
        mostCost_ += most;
    }
    const auto states =
        static_cast<std::size_t>(redundant_ + 1) * static_cast<std::size_t>(mostCost_ + 1);
    canEnd_.assign(elements_.size() + 1, std::vector<char>(states, 0));
    unreachable_.resize(elements_.size() + 1);
    canEnd_.back()[0] = 1;
    MatrixXd reachable(0, redundant_);
    unreachable_.back() = complementOf(reachable);
    for (std::size_t i = elements_.size(); i-- > 0;) {
        for (int rows = 0; rows <= redundant_; ++rows) {
            for (int cost = 0; cost <= mostCost_; ++cost) {
                bool can = canEnd(i + 1, rows, cost);
                for (const Choice& choice : elements_[i]) {
                    can = can || canEnd(i + 1, rows - static_cast<int>(choice.relieved.rows()),
                                        cost - choice.cost);
                }
                canEnd_[i][static_cast<std::size_t>(rows * (mostCost_ + 1) + cost)] = can ? 1 : 0;
            }
        }
        for (const Choice& choice : elements_[i]) {
            const Index before = reachable.rows();
            reachable.conservativeResize(before + choice.relieved.rows(), Eigen::NoChange);
            reachable.bottomRows(choice.relieved.rows()) = choice.relieved;
        }
        unreachable_[i] = complementOf(reachable);
    }
    for (int cost = 0; cost <= mostCost_; ++cost) {
        if (canEnd(0, redundant_, cost)) {
            costs_.push_back(cost);
        }
    }
}

bool ExactSetSearch::canEnd(std::size_t element, int rows, int cost) const {
    return rows >= 0 && cost >= 0 && cost <= mostCost_ &&
           canEnd_[element][static_cast<std::size_t>(rows * (mostCost_ + 1) + cost)] != 0;
}

bool ExactSetSearch::othersCanFollow(std::size_t element) const {
    const MatrixXd& missing = unreachable_[element];
    if (missing.cols() == 0) {
        return true;
    }
    if (missing.cols() > size_) {
        return false;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr;
    qr.setThreshold(kDependent);
    qr.compute(missing.transpose() * basis_.leftCols(size_));
    return qr.maxPivot() > kDependent && qr.rank() == missing.cols();
}

/// Takes the directions into the basis; false when they depend on what is there.
bool ExactSetSearch::add(const MatrixXd& relieved) {
    for (Index k = 0; k < relieved.rows(); ++k) {
        Eigen::VectorXd v = relieved.row(k).transpose();
        for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Kahan, Parlett)
            v -= basis_.leftCols(size_) * (basis_.leftCols(size_).transpose() * v);
        }
        const double rest = v.norm();
        if (rest < kDependent) {
            return false;
        }
        basis_.col(size_++) = v / rest;
    }
    return true;
}

double ExactSetSearch::margin() const {
    MatrixXd all(redundant_, redundant_);
    Index row = 0;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
        if (choice_[i] >= 0) {
            const MatrixXd& relieved = elements_[i][static_cast<std::size_t>(choice_[i])].relieved;
            all.middleRows(row, relieved.rows()) = relieved;
            row += relieved.rows();
        }
    }
    if (redundant_ == 0) {
        return 1.0;
    }
    // Not by SVD: it is asked for thousands of sets, and half the digits will do.
    const Eigen::SelfAdjointEigenSolver<MatrixXd> squares(all * all.transpose(),
                                                          Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, squares.eigenvalues()[0]));
}

void ExactSetSearch::descend(std::size_t element, int costLeft) {
    if (++steps_ % kStepsBetweenStops == 0 && *stop_ && (*stop_)()) {
        stopped_ = true;
    }
    if (stopped_ || !othersCanFollow(element)) {
        return;
    }
    if (element == elements_.size()) {
        (*found_)({choice_, cost_, margin()});
        return;
    }
    const int before = size_;
    for (std::size_t k = 0; k < elements_[element].size() && !stopped_; ++k) {
        const Choice& choice = elements_[element][k];
        const int rows = redundant_ - before - static_cast<int>(choice.relieved.rows());
        if (canEnd(element + 1, rows, costLeft - choice.cost) && add(choice.relieved)) {
            choice_[element] = static_cast<int>(k);
            descend(element + 1, costLeft - choice.cost);
        }
        size_ = before;
    }
    choice_[element] = -1;
    if (!stopped_ && canEnd(element + 1, redundant_ - before, costLeft)) {
        descend(element + 1, costLeft);
    }
}

bool ExactSetSearch::visit(int cost, const std::function<bool()>& stop,
                           const std::function<void(const ExactSet&)>& found) {
    stop_ = &stop;
    found_ = &found;
    stopped_ = false;
    cost_ = cost;
    size_ = 0;
    std::fill(choice_.begin(), choice_.end(), -1);
    if (canEnd(0, redundant_, cost)) {
        descend(0, cost);
    }
    return !stopped_;
}

}  // namespace simcore::mobility
