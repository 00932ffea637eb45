#include "simcore/statics/quadratic_program.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

namespace simcore::statics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Share of the Gram matrix's largest element by which rows give way, so that dependent and
/// contradicting ones have an answer.
constexpr double kYield = 1e-12;
/// Share of the largest element of what is asked below which a row is not violated.
constexpr double kViolated = 1e-12;

/// min 1/2 l' A l - c' l, l >= 0 but for the first `free` ones.
class Multipliers {
  public:
    /// @param yield  that was added to the diagonal of `gram`
    Multipliers(const MatrixXd& gram, double yield, const VectorXd& asked, int free)
        : gram_(gram),
          yield_(yield),
          asked_(asked),
          free_(free),
          now_(VectorXd::Zero(asked.size())),
          isActive_(static_cast<std::size_t>(asked.size()), false),
          matrix_(asked.size(), asked.size()),
          wanted_(asked.size()),
          correction_(asked.size()),
          violation_(asked.size()) {
        active_.reserve(static_cast<std::size_t>(asked.size()));
        for (int i = 0; i < free; ++i) {
            activate(i);
        }
    }

    /// Begins with the rows that hold here.
    void begin(const VectorXd& guess) {
        for (int i = free_; i < guess.size(); ++i) {
            if (guess[i] > 0.0) {
                now_[i] = guess[i];
                activate(i);
            }
        }
    }

    const VectorXd& solve() {
        const Eigen::Index m = asked_.size();
        take();
        const double enough =
            kViolated * std::max(1e-300, m > 0 ? asked_.cwiseAbs().maxCoeff() : 0.0);
        for (Eigen::Index k = 0; k < 4 * m; ++k) {
            violation_ = asked_;
            for (const int row : active_) {
                violation_ -= now_[row] * gram_.col(row);
            }
            int worst = -1;
            for (int i = free_; i < m; ++i) {
                if (!isActive_[static_cast<std::size_t>(i)] && violation_[i] > enough &&
                    (worst < 0 || violation_[i] > violation_[worst])) {
                    worst = i;
                }
            }
            if (worst < 0) {
                break;
            }
            activate(worst);
            take();
        }
        return now_;
    }

  private:
    void activate(int row) {
        active_.push_back(row);
        isActive_[static_cast<std::size_t>(row)] = true;
    }

    /// Solves for the active ones, giving up those that would pull.
    void take() {
        while (!active_.empty()) {
            const auto n = static_cast<Eigen::Index>(active_.size());
            auto wanted = wanted_.head(n);
            for (Eigen::Index j = 0; j < n; ++j) {
                const int column = active_[static_cast<std::size_t>(j)];
                wanted[j] = asked_[column];
                for (Eigen::Index i = j; i < n; ++i) {
                    matrix_(i, j) = gram_(active_[static_cast<std::size_t>(i)], column);
                }
            }
            Eigen::Ref<MatrixXd> matrix = matrix_.topLeftCorner(n, n);
            const Eigen::LDLT<Eigen::Ref<MatrixXd>> factor(matrix);
            factor.solveInPlace(wanted);
            // What the rows gave way is asked for once more.
            correction_.head(n) = yield_ * wanted;
            auto correction = correction_.head(n);
            factor.solveInPlace(correction);
            wanted += correction;
            double share = 1.0;
            for (Eigen::Index i = 0; i < n; ++i) {
                const int row = active_[static_cast<std::size_t>(i)];
                if (row >= free_ && wanted[i] < 0.0) {
                    share = std::min(share, now_[row] / (now_[row] - wanted[i]));
                }
            }
            std::size_t kept = 0;
            for (Eigen::Index i = 0; i < n; ++i) {
                const int row = active_[static_cast<std::size_t>(i)];
                const double rounding = 1e-14 * (now_[row] + std::abs(wanted[i]));
                now_[row] += share * (wanted[i] - now_[row]);
                if (row >= free_ && share < 1.0 && now_[row] <= rounding) {
                    now_[row] = 0.0;
                    isActive_[static_cast<std::size_t>(row)] = false;
                } else {
                    active_[kept++] = row;
                }
            }
            const bool dropped = kept < active_.size();
            active_.resize(kept);
            if (!dropped) {
                return;
            }
        }
    }

    const MatrixXd& gram_;
    const double yield_;
    const VectorXd& asked_;
    const int free_;
    VectorXd now_;
    std::vector<int> active_;
    std::vector<bool> isActive_;
    MatrixXd matrix_;  ///< workspace
    VectorXd wanted_;
    VectorXd correction_;
    VectorXd violation_;
};

}  // namespace

Optimum minimise(const QuadraticProgram& problem, const VectorXd& guess) {
    // With H = L L' all is about z = L' x, in which H is the unit.
    const Eigen::LLT<MatrixXd> factor(problem.hessian);
    Optimum optimum;
    optimum.x = factor.matrixL().solve(problem.right);
    const MatrixXd reached = factor.matrixL().solve(problem.rows.transpose());
    // Small: as good as any blocked product.
    MatrixXd gram = reached.transpose().lazyProduct(reached);
    const double yield = gram.size() > 0 ? kYield * gram.diagonal().maxCoeff() : 0.0;
    gram.diagonal().array() += yield;
    const VectorXd asked = problem.bounds - reached.transpose() * optimum.x;
    Multipliers multipliers(gram, yield, asked, problem.equations);
    if (guess.size() == asked.size()) {
        multipliers.begin(guess);
    }
    optimum.multipliers = multipliers.solve();
    optimum.x += reached * optimum.multipliers;
    factor.matrixU().solveInPlace(optimum.x);
    return optimum;
}

}  // namespace simcore::statics
