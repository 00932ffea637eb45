#include "simcore/dynamics/impulse_solver.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace simcore::dynamics {
namespace {

// The same for sticking and sliding. Where wheels that an uneven ground makes scrub slide by some
// 0.1 mm/s, a small one takes them for sticking as soon as their load grows a little: with 0.02 kg
// bench_rover's rough ground takes 6.0 iterations a step, with this one 3.5. With 1 kg and more its
// waves take more again.
constexpr double kSlidingMass = 0.3;  // [kg]
constexpr int kMaxIterations = 7;
constexpr int kMaxLimitChanges = 6;
constexpr int kMaxSweeps = 2000;
// Debug builds stop at a contact that is further than this many tolerances from its law.
[[maybe_unused]] constexpr double kToleratedResidual = 100.0;
// Creep of sticking, over what it is to be, in the stages that Newton's iteration gets when it
// cycles; each starts from where the one before it came to.
constexpr std::array<double, 5> kStages{100.0, 20.0, 5.0, 2.0, 1.0};

double along(const ScalarRow& row, const Eigen::VectorXd& u) {
    double velocity = 0.0;
    for (std::size_t i = 0; i < row.indices.size(); ++i) {
        velocity += row.factors[i] * u[row.indices[i]];
    }
    return velocity;
}

Vec6 twistOf(const RateMap& body, const Eigen::VectorXd& u) {
    Vec6 twist = Vec6::Zero();
    for (std::size_t i = 0; i < body.indices.size(); ++i) {
        twist += u[body.indices[i]] * body.twists[i];
    }
    return twist;
}

/// The impulse nearest to `p` within the cone.
Vec3 projected(const Vec3& p, double friction) {
    const double normal = std::max(0.0, p[0]);
    const double tangential = std::sqrt(p[1] * p[1] + p[2] * p[2]);
    const double limit = friction * normal;
    const double scale = tangential > limit ? limit / tangential : 1.0;
    return {normal, scale * p[1], scale * p[2]};
}

}  // namespace

double naturalResidual(const ContactRow& contact, double normalCompliance,
                       double tangentialCompliance) {
    const double r = kProjectionMass;
    const Vec3& p = contact.impulse;
    const Vec3& v = contact.velocity;
    const Vec3 trial(p[0] - r * (v[0] + normalCompliance * p[0] - contact.bound),
                     p[1] - r * (v[1] + tangentialCompliance * p[1]),
                     p[2] - r * (v[2] + tangentialCompliance * p[2]));
    return (p - projected(trial, contact.friction)).cwiseAbs().maxCoeff();
}

void PatternedLu::reset(int size) {
    size_ = size;
    const auto n = static_cast<std::size_t>(size);
    pattern_.assign(n, std::vector<bool>(n, false));
}

void PatternedLu::couple(const std::vector<int>& indices) {
    for (int i : indices) {
        for (int j : indices) {
            pattern_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = true;
        }
    }
}

void PatternedLu::close() {
    const auto n = static_cast<std::size_t>(size_);
    after_.assign(n, {});
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = k + 1; i < n; ++i) {
            if (pattern_[k][i]) {
                after_[k].push_back(static_cast<int>(i));
            }
        }
        couple(after_[k]);
    }
}

void PatternedLu::factor(RowMajor& matrix) const {
    for (int k = 0; k < size_; ++k) {
        const double* pivotRow = matrix.row(k).data();
        const double inverse = 1.0 / pivotRow[k];
        const std::vector<int>& after = after_[static_cast<std::size_t>(k)];
        for (int i : after) {
            double* row = matrix.row(i).data();
            const double factor = row[k] * inverse;
            row[k] = factor;
            for (int j : after) {
                row[j] -= factor * pivotRow[j];
            }
        }
    }
}

void PatternedLu::solve(const RowMajor& factored, Eigen::VectorXd& x) const {
    for (int k = 0; k < size_; ++k) {
        for (int i : after_[static_cast<std::size_t>(k)]) {
            x[i] -= factored(i, k) * x[k];
        }
    }
    for (int k = size_ - 1; k >= 0; --k) {
        double value = x[k];
        for (int j : after_[static_cast<std::size_t>(k)]) {
            value -= factored(k, j) * x[j];
        }
        x[k] = value / factored(k, k);
    }
}

bool ImpulseSolver::newton(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                           ImpulseCounters& counters) {
    const double en = problem.normalCompliance;
    const double et = problem.tangentialCompliance;
    const double r = kProjectionMass;
    for (ContactRow& contact : problem.contacts) {
        contact.velocity = contact.wrenches.transpose() *
                           twistOf(problem.bodies[static_cast<std::size_t>(contact.body)], u);
    }
    stiff_.resize(problem.bodies.size());
    push_.resize(problem.bodies.size());
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
        ++counters.iterations;
        matrix_ = problem.mass;
        right_ = problem.momentum;
        for (const int touched : problem.touched) {
            stiff_[static_cast<std::size_t>(touched)].setZero();
            push_[static_cast<std::size_t>(touched)].setZero();
        }
        // Every contact pushes with p = p0 - C v in the state that it is in now.
        laws_.resize(problem.contacts.size());
        for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
            const ContactRow& contact = problem.contacts[c];
            Vec3& push = laws_[c].first;
            Mat3& stiff = laws_[c].second;
            push.setZero();
            stiff.setZero();
            const Vec3& p = contact.impulse;
            const Vec3& v = contact.velocity;
            const double z = p[0] - r * (v[0] + en * p[0] - contact.bound);
            if (z > 0.0) {
                push[0] = contact.bound / en;
                stiff(0, 0) = 1.0 / en;
                const Eigen::Vector2d t =
                    p.tail<2>() - kSlidingMass * (v.tail<2>() + et * p.tail<2>());
                const double size = t.norm();
                const double limit = contact.friction * z;
                if (size <= limit) {
                    stiff(1, 1) = stiff(2, 2) = 1.0 / et;
                } else {
                    const Eigen::Vector2d direction = t / size;
                    const double kappa = limit / size;
                    const double s = std::min(kappa * kSlidingMass / (1.0 - kappa), 1.0 / et);
                    push.tail<2>() = contact.friction * push[0] * direction;
                    stiff.block<2, 1>(1, 0) = contact.friction / en * direction;
                    stiff.block<2, 2>(1, 1) =
                        s * (Eigen::Matrix2d::Identity() - direction * direction.transpose());
                }
                const auto body = static_cast<std::size_t>(contact.body);
                const Eigen::Matrix<double, 6, 3> pushed = contact.wrenches * stiff;
                stiff_[body].noalias() += pushed * contact.wrenches.transpose();
                push_[body].noalias() += contact.wrenches * push;
            }
        }
        for (const int touched : problem.touched) {
            const auto b = static_cast<std::size_t>(touched);
            const RateMap& body = problem.bodies[b];
            for (std::size_t j = 0; j < body.indices.size(); ++j) {
                const Vec6 resisted = stiff_[b] * body.twists[j];
                for (std::size_t i = 0; i < body.indices.size(); ++i) {
                    matrix_(body.indices[i], body.indices[j]) += body.twists[i].dot(resisted);
                }
                right_[body.indices[j]] += body.twists[j].dot(push_[b]);
            }
        }
        for (std::size_t k = 0; k < problem.rows.size(); ++k) {
            const ScalarRow& row = problem.rows[k];
            const bool free = limits_[k] == 0;
            const double impulse =
                free ? row.bound / row.compliance : (limits_[k] > 0 ? row.most : row.least);
            for (std::size_t i = 0; i < row.indices.size(); ++i) {
                right_[row.indices[i]] += row.factors[i] * impulse;
                for (std::size_t j = 0; free && j < row.indices.size(); ++j) {
                    matrix_(row.indices[i], row.indices[j]) +=
                        row.factors[i] * row.factors[j] / row.compliance;
                }
            }
        }
        lu.factor(matrix_);
        lu.solve(matrix_, right_);
        u = right_;
        double residual = 0.0;
        for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
            ContactRow& contact = problem.contacts[c];
            contact.velocity = contact.wrenches.transpose() *
                               twistOf(problem.bodies[static_cast<std::size_t>(contact.body)], u);
            contact.impulse = laws_[c].first - laws_[c].second * contact.velocity;
            residual = std::max(residual, naturalResidual(contact, en, et));
        }
        if (!(residual > problem.tolerance)) {
            return std::isfinite(residual);
        }
    }
    return false;
}

void ImpulseSolver::reserve(std::size_t contacts, std::size_t rows, std::size_t rates) {
    laws_.reserve(contacts);
    limits_.reserve(rows);
    firstImpulses_.reserve(contacts);
    // Of gradients(): the largest problems seen have a quarter of this many contacts.
    const std::size_t m = 3 * contacts / 4 + rows;
    room_.reserve(2 * m * rates + m * m + 5 * m);
    free_.reserve(m);
}

bool ImpulseSolver::newtonInStages(ImpulseProblem& problem, const PatternedLu& lu,
                                   Eigen::VectorXd& u, ImpulseCounters& counters) {
    const double creep = problem.tangentialCompliance;
    u = firstU_;
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        problem.contacts[c].impulse = firstImpulses_[c];
    }
    bool solved = false;
    for (const double stage : kStages) {
        problem.tangentialCompliance = stage * creep;
        solved = newton(problem, lu, u, counters);
    }
    return solved;
}

// A stop pushes or not, a motor is at a limit or not: changed only between solves of the contacts,
// since changing both at once cycles.
bool ImpulseSolver::withinLimits(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                                 ImpulseCounters& counters) {
    bool within = true;
    for (int change = 0; change < kMaxLimitChanges; ++change) {
        if (!newton(problem, lu, u, counters) && !newtonInStages(problem, lu, u, counters)) {
            return false;
        }
        within = true;
        for (std::size_t k = 0; k < problem.rows.size(); ++k) {
            ScalarRow& row = problem.rows[k];
            const double asked = (row.bound - along(row, u)) / row.compliance;
            const int limit = asked > row.most ? 1 : (asked < row.least ? -1 : 0);
            row.impulse = std::clamp(asked, row.least, row.most);
            if (limit != limits_[k]) {
                limits_[k] = limit;
                within = false;
            }
        }
        if (within) {
            return true;
        }
    }
    return false;
}

void ImpulseSolver::solve(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                          ImpulseCounters& counters) {
    limits_.resize(problem.rows.size());
    for (std::size_t k = 0; k < problem.rows.size(); ++k) {
        limits_[k] = problem.rows[k].start;
    }
    firstU_ = u;
    firstImpulses_.clear();
    for (const ContactRow& contact : problem.contacts) {
        firstImpulses_.push_back(contact.impulse);
    }
    if (!withinLimits(problem, lu, u, counters)) {
        ++counters.fallbacks;
        for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
            problem.contacts[c].impulse = firstImpulses_[c];
        }
        gradients(problem, lu, u);
    }
    const double residual = residualOf(problem);
    if (!(residual <= problem.tolerance)) {
        ++counters.failures;
    }
    assert(residual <= kToleratedResidual * problem.tolerance);
    counters.residual = std::max(counters.residual, residual);
}

double ImpulseSolver::residualOf(const ImpulseProblem& problem) {
    double residual = 0.0;
    for (const ContactRow& contact : problem.contacts) {
        residual = std::max(residual, naturalResidual(contact, problem.normalCompliance,
                                                      problem.tangentialCompliance));
    }
    return residual;
}

void ImpulseSolver::sweep(ImpulseProblem& problem, double* p) const {
    const double en = problem.normalCompliance;
    const double et = problem.tangentialCompliance;
    const auto m = static_cast<std::size_t>(size_);
    const auto velocity = [&](std::size_t row) {
        return free_[row] + Eigen::Map<const Eigen::VectorXd>(delassus_ + row * m, size_)
                                .dot(Eigen::Map<const Eigen::VectorXd>(p, size_));
    };
    const auto element = [&](std::size_t row, std::size_t column) {
        return delassus_[row * m + column];
    };
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        const std::size_t at = 3 * c;
        const ContactRow& contact = problem.contacts[c];
        p[at] = std::max(
            0.0, p[at] - (velocity(at) + en * p[at] - contact.bound) / (element(at, at) + en));
        // One scale for both directions: with a scale of its own for each, friction would no longer
        // point against the sliding.
        const double a = element(at + 1, at + 1);
        const double b = element(at + 2, at + 2);
        const double mixed = element(at + 1, at + 2);
        const double largest =
            0.5 * (a + b) + std::sqrt(0.25 * (a - b) * (a - b) + mixed * mixed) + et;
        const Vec3 trial(p[at], p[at + 1] - (velocity(at + 1) + et * p[at + 1]) / largest,
                         p[at + 2] - (velocity(at + 2) + et * p[at + 2]) / largest);
        Eigen::Map<Vec3>{p + at} = projected(trial, contact.friction);
    }
    const std::size_t first = 3 * problem.contacts.size();
    for (std::size_t k = 0; k < problem.rows.size(); ++k) {
        const ScalarRow& row = problem.rows[k];
        const std::size_t at = first + k;
        const double next = p[at] - (velocity(at) + row.compliance * p[at] - row.bound) /
                                        (element(at, at) + row.compliance);
        p[at] = std::clamp(next, row.least, row.most);
    }
}

// In the space of the impulses, with the matrix of what each does to every velocity.
void ImpulseSolver::gradients(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u) {
    using Matrix = Eigen::Map<RowMajor>;
    using Vector = Eigen::Map<Eigen::VectorXd>;
    const auto n = problem.momentum.size();
    const auto contactRows = static_cast<Eigen::Index>(3 * problem.contacts.size());
    const auto m = contactRows + static_cast<Eigen::Index>(problem.rows.size());
    size_ = m;
    room_.assign(static_cast<std::size_t>(2 * m * n + m * m + 5 * m), 0.0);
    double* next = room_.data();
    const auto take = [&next](Eigen::Index size) {
        double* taken = next;
        next += size;
        return taken;
    };
    Matrix jacobian(take(m * n), m, n);
    Matrix answers(take(m * n), m, n);  // of the rates to each row's unit impulse
    delassus_ = take(m * m);
    Vector p(take(m), m);
    Vector before(take(m), m);
    Vector gradient(take(m), m);
    Vector direction(take(m), m);
    Vector step(take(m), m);

    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        const ContactRow& contact = problem.contacts[c];
        const RateMap& body = problem.bodies[static_cast<std::size_t>(contact.body)];
        for (std::size_t i = 0; i < body.indices.size(); ++i) {
            jacobian.block<3, 1>(static_cast<Eigen::Index>(3 * c), body.indices[i]) =
                contact.wrenches.transpose() * body.twists[i];
        }
    }
    for (std::size_t k = 0; k < problem.rows.size(); ++k) {
        const ScalarRow& row = problem.rows[k];
        for (std::size_t i = 0; i < row.indices.size(); ++i) {
            jacobian(contactRows + static_cast<Eigen::Index>(k), row.indices[i]) = row.factors[i];
        }
    }
    matrix_ = problem.mass;
    lu.factor(matrix_);
    u = problem.momentum;
    lu.solve(matrix_, u);  // without any impulse
    free_.resize(static_cast<std::size_t>(m));
    Vector(free_.data(), m).noalias() = jacobian * u;
    for (Eigen::Index row = 0; row < m; ++row) {
        right_ = jacobian.row(row).transpose();
        lu.solve(matrix_, right_);
        answers.row(row) = right_.transpose();
    }
    Matrix(delassus_, m, m).noalias() = jacobian * answers.transpose();

    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        p.segment<3>(static_cast<Eigen::Index>(3 * c)) =
            projected(problem.contacts[c].impulse, problem.contacts[c].friction);
    }
    for (std::size_t k = 0; k < problem.rows.size(); ++k) {
        p[contactRows + static_cast<Eigen::Index>(k)] =
            std::clamp(problem.rows[k].impulse, problem.rows[k].least, problem.rows[k].most);
    }
    if (!p.allFinite()) {
        p.setZero();
    }
    before = p;
    sweep(problem, p.data());
    gradient = before - p;
    direction = -gradient;
    constexpr double kSweepTolerance = 0.1;
    for (int k = 0; k < kMaxSweeps; ++k) {
        before = p;
        sweep(problem, p.data());
        step = before - p;
        if (step.cwiseAbs().maxCoeff() < kSweepTolerance * problem.tolerance) {
            break;
        }
        const double old = gradient.squaredNorm();
        const double beta = old > 0.0 ? step.squaredNorm() / old : 2.0;
        if (beta > 1.0) {
            direction.setZero();
        } else {
            p += beta * direction;
            direction = beta * direction - step;
        }
        gradient = step;
    }
    u.noalias() += answers.transpose() * p;
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        ContactRow& contact = problem.contacts[c];
        contact.impulse = p.segment<3>(static_cast<Eigen::Index>(3 * c));
        contact.velocity = contact.wrenches.transpose() *
                           twistOf(problem.bodies[static_cast<std::size_t>(contact.body)], u);
    }
    for (std::size_t k = 0; k < problem.rows.size(); ++k) {
        problem.rows[k].impulse = p[contactRows + static_cast<Eigen::Index>(k)];
    }
}

}  // namespace simcore::dynamics
