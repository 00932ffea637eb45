#include "simcore/statics/quadratic_program.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "simcore/base/scratch.h"

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
    /// @param now    l: which of them are active to begin with, then the result
    Multipliers(const Scratch::Matrix& gram, double yield, const Scratch::Vector& asked, int free,
                Eigen::Ref<VectorXd> now)
        : gram_(gram),
          yield_(yield),
          asked_(asked),
          free_(free),
          now_(now),
          active_(room_.list<int>(static_cast<std::size_t>(asked.size()))),
          isActive_(room_.list<bool>(static_cast<std::size_t>(asked.size()))),
          matrix_(room_.matrix(asked.size(), asked.size())),
          wanted_(room_.vector(asked.size())),
          correction_(room_.vector(asked.size())),
          violation_(room_.vector(asked.size())) {
        for (int i = 0; i < asked.size(); ++i) {
            if (i < free) {
                now_[i] = 0.0;
                activate(i);
            } else if (now_[i] > 0.0) {
                activate(i);
            } else {
                now_[i] = 0.0;
            }
        }
    }

    void solve() {
        const Eigen::Index m = asked_.size();
        take();
        const double enough =
            kViolated * std::max(1e-300, m > 0 ? asked_.cwiseAbs().maxCoeff() : 0.0);
        for (Eigen::Index k = 0; k < 4 * m; ++k) {
            violation_ = asked_;
            for (const int row : active_.first(count_)) {
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
    }

  private:
    void activate(int row) {
        active_[count_++] = row;
        isActive_[static_cast<std::size_t>(row)] = true;
    }

    /// Solves for the active ones, giving up those that would pull.
    void take() {
        while (count_ > 0) {
            const auto n = static_cast<Eigen::Index>(count_);
            auto wanted = wanted_.head(n);
            for (Eigen::Index j = 0; j < n; ++j) {
                const int column = active_[static_cast<std::size_t>(j)];
                wanted[j] = asked_[column];
                for (Eigen::Index i = j; i < n; ++i) {
                    matrix_(i, j) = gram_(active_[static_cast<std::size_t>(i)], column);
                }
            }
            Eigen::Ref<MatrixXd> matrix = matrix_.topLeftCorner(n, n);
            const Eigen::LLT<Eigen::Ref<MatrixXd>> factor(matrix);
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
            const bool dropped = kept < count_;
            count_ = kept;
            if (!dropped) {
                return;
            }
        }
    }

    Scratch room_;
    const Scratch::Matrix& gram_;
    const double yield_;
    const Scratch::Vector& asked_;
    const int free_;
    Eigen::Ref<VectorXd> now_;
    std::span<int> active_;  ///< the first `count_`
    std::size_t count_ = 0;
    std::span<bool> isActive_;
    Scratch::Matrix matrix_;  ///< workspace
    Scratch::Vector wanted_;
    Scratch::Vector correction_;
    Scratch::Vector violation_;
};

}  // namespace

void minimise(const QuadraticView& problem, Eigen::Ref<VectorXd> x,
              Eigen::Ref<VectorXd> multipliers) {
    Scratch room;
    const Eigen::Index n = problem.hessian.rows();
    const Eigen::Index m = problem.rows.rows();
    // With H = L L' all is about z = L' x, in which H is the unit.
    Scratch::Matrix hessian = room.matrix(n, n);
    hessian = problem.hessian;
    Eigen::Ref<MatrixXd> inPlace(hessian);
    const Eigen::LLT<Eigen::Ref<MatrixXd>> factor(inPlace);
    x = problem.right;
    factor.matrixL().solveInPlace(x);
    Scratch::Matrix reached = room.matrix(n, m);
    reached = problem.rows.transpose();
    factor.matrixL().solveInPlace(reached);
    // Small: as good as any blocked product.
    Scratch::Matrix gram = room.matrix(m, m);
    gram.noalias() = reached.transpose().lazyProduct(reached);
    const double yield = gram.size() > 0 ? kYield * gram.diagonal().maxCoeff() : 0.0;
    gram.diagonal().array() += yield;
    Scratch::Vector asked = room.vector(problem.bounds);
    asked.noalias() -= reached.transpose() * x;
    Multipliers(gram, yield, asked, problem.equations, multipliers).solve();
    x.noalias() += reached * multipliers;
    factor.matrixU().solveInPlace(x);
}

Optimum minimise(const QuadraticProgram& problem, const VectorXd& guess) {
    Optimum optimum;
    optimum.x.resize(problem.right.size());
    optimum.multipliers = guess;
    if (guess.size() != problem.bounds.size()) {
        optimum.multipliers.setZero(problem.bounds.size());
    }
    minimise({problem.hessian, problem.right, problem.rows, problem.bounds, problem.equations},
             optimum.x, optimum.multipliers);
    return optimum;
}

}  // namespace simcore::statics
