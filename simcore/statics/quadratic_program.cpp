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
    Multipliers(const MatrixXd& gram, const VectorXd& asked, int free)
        : gram_(gram),
          asked_(asked),
          free_(free) {
        for (int i = 0; i < free; ++i) {
            active_.push_back(i);
        }
    }

    VectorXd solve() {
        const Eigen::Index m = asked_.size();
        VectorXd now = VectorXd::Zero(m);
        if (free_ > 0) {
            take(now);
        }
        const double enough =
            kViolated * std::max(1e-300, asked_.size() > 0 ? asked_.cwiseAbs().maxCoeff() : 0.0);
        for (Eigen::Index k = 0; k < 4 * m; ++k) {
            const VectorXd violation = asked_ - gram_ * now;
            int worst = -1;
            for (int i = free_; i < m; ++i) {
                const bool idle = std::find(active_.begin(), active_.end(), i) == active_.end();
                if (idle && violation[i] > enough &&
                    (worst < 0 || violation[i] > violation[worst])) {
                    worst = i;
                }
            }
            if (worst < 0) {
                break;
            }
            active_.push_back(worst);
            take(now);
        }
        return now;
    }

  private:
    /// Solves for the active ones, giving up those that would pull.
    void take(VectorXd& now) {
        while (!active_.empty()) {
            const auto n = static_cast<Eigen::Index>(active_.size());
            MatrixXd matrix(n, n);
            VectorXd right(n);
            for (Eigen::Index i = 0; i < n; ++i) {
                right[i] = asked_[active_[static_cast<std::size_t>(i)]];
                for (Eigen::Index j = 0; j < n; ++j) {
                    matrix(i, j) = gram_(active_[static_cast<std::size_t>(i)],
                                         active_[static_cast<std::size_t>(j)]);
                }
            }
            const VectorXd wanted = matrix.ldlt().solve(right);
            double share = 1.0;
            for (Eigen::Index i = 0; i < n; ++i) {
                const int row = active_[static_cast<std::size_t>(i)];
                if (row >= free_ && wanted[i] < 0.0) {
                    share = std::min(share, now[row] / (now[row] - wanted[i]));
                }
            }
            bool dropped = false;
            std::vector<int> kept;
            for (Eigen::Index i = 0; i < n; ++i) {
                const int row = active_[static_cast<std::size_t>(i)];
                now[row] += share * (wanted[i] - now[row]);
                if (row >= free_ && share < 1.0 && now[row] <= 1e-14 * std::abs(wanted[i])) {
                    now[row] = 0.0;
                    dropped = true;
                } else {
                    kept.push_back(row);
                }
            }
            active_ = kept;
            if (!dropped) {
                return;
            }
        }
    }

    const MatrixXd& gram_;
    const VectorXd& asked_;
    int free_;
    std::vector<int> active_;
};

}  // namespace

Optimum minimise(const QuadraticProgram& problem) {
    const Eigen::LLT<MatrixXd> factor(problem.hessian);
    const VectorXd unbound = factor.solve(problem.right);
    const MatrixXd reached = factor.solve(problem.rows.transpose());
    MatrixXd gram = problem.rows * reached;
    if (gram.size() > 0) {
        gram.diagonal().array() += kYield * gram.diagonal().maxCoeff();
    }
    const VectorXd asked = problem.bounds - problem.rows * unbound;
    Optimum optimum;
    optimum.multipliers = Multipliers(gram, asked, problem.equations).solve();
    optimum.x = unbound + reached * optimum.multipliers;
    return optimum;
}

}  // namespace simcore::statics
