#include "simcore/dynamics/impulse_solver.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace simcore::dynamics {
namespace {

// Masses of the projections that tell touching from open and sticking from sliding, over
// ImpulseProblem::contactMass. Near what contacts move along their normal and sideways: with 3 to 4
// sideways rough ground takes fewest iterations, with 8 up to a tenth more (seeds 301 to 306 of
// rough-3d, three projects), with masses of 0.02 and 0.3 kg one step in eight cycled.
constexpr double kOpeningMass = 1.0;
constexpr double kSlidingMass = 4.0;
// Of the quick way, and again of the slow one that is gone where the quick one cycles. Few steps
// need more than nine, but what comes after Newton's method costs as much as some 200.
constexpr int kMaxIterations = 16;
// Where neither gets there: the quick way with the masses above multiplied by these. More than half
// of such steps on bench_rover's rough ground end so.
constexpr std::array<double, 2> kOtherMasses{0.1, 3.0};
// Shares of a Newton step to choose from. States of contacts change all at once in a whole one.
constexpr std::array<double, 6> kShares{1.0, 0.6, 0.3, 0.12, 0.05, 0.02};
constexpr int kMaxLimitChanges = 6;
constexpr int kMaxSweeps = 2000;
// Of the gradients before Newton's method is tried again, for the first time.
constexpr int kSweepsBeforeNewton = 32;
// Debug builds stop at a contact that is further than this many tolerances from its law.
[[maybe_unused]] constexpr double kToleratedResidual = 100.0;

double along(const ScalarRow& row, const Eigen::VectorXd& u) {
    double velocity = 0.0;
    for (std::size_t i = 0; i < row.indices.size(); ++i) {
        velocity += row.factors[i] * u[row.indices[i]];
    }
    return velocity;
}

Vec6 twistOf(const RateMap& body, const Eigen::VectorXd& u) {
    Vec6 twist = Vec6::Zero();
    if (body.root) {
        for (std::size_t i = 0; i < 6; ++i) {
            twist[static_cast<Eigen::Index>(i)] = u[(*body.root)[i]];
        }
    }
    for (std::size_t k = 0; k < body.indices.size(); ++k) {
        twist += u[body.indices[k]] * body.twists[k];
    }
    return twist;
}

/// Calls visit(c, v) with the velocity of every contact.
template <class Visit>
void visitVelocities(const ImpulseProblem& problem, const Eigen::VectorXd& u, Visit&& visit) {
    Vec6 twist = Vec6::Zero();
    int body = -1;
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        const ContactRow& contact = problem.contacts[c];
        if (contact.body != body) {
            body = contact.body;
            twist = twistOf(problem.bodies[static_cast<std::size_t>(body)], u);
        }
        visit(c, Vec3(contact.wrenches.transpose() * twist));
    }
}

/// The impulse nearest to `p` within the cone.
Vec3 projected(const Vec3& p, double friction) {
    const double normal = std::max(0.0, p[0]);
    const double tangential = std::sqrt(p[1] * p[1] + p[2] * p[2]);
    const double limit = friction * normal;
    const double scale = tangential > limit ? limit / tangential : 1.0;
    return {normal, scale * p[1], scale * p[2]};
}

/// By how much an impulse changes that is projected onto the law [N s].
/// @param opening, sliding  masses of the projection, normal and tangential [kg]
Vec3 naturalMap(const ContactRow& contact, const Vec3& p, const Vec3& v,
                const ImpulseProblem& problem, double opening, double sliding) {
    const Vec3 trial(p[0] - opening * (v[0] + problem.normalCompliance * p[0] - contact.bound),
                     p[1] - sliding * (v[1] + problem.tangentialCompliance * p[1]),
                     p[2] - sliding * (v[2] + problem.tangentialCompliance * p[2]));
    return p - projected(trial, contact.friction);
}

/// How far a contact is from its law [N s].
double residualOf(const ContactRow& contact, const Vec3& p, const Vec3& v,
                  const ImpulseProblem& problem) {
    return naturalMap(contact, p, v, problem, kProjectionMass, kProjectionMass)
        .cwiseAbs()
        .maxCoeff();
}

/// What a contact pushes: p = push - stiffness v, in the state that impulse and velocity tell.
ContactLaw lawOf(const ContactRow& contact, const ImpulseProblem& problem) {
    const double en = problem.normalCompliance;
    const double et = problem.tangentialCompliance;
    const Vec3& p = contact.impulse;
    const Vec3& v = contact.velocity;
    ContactLaw law;
    const double opening = kOpeningMass * problem.contactMass;
    const double z = p[0] - opening * (v[0] + en * p[0] - contact.bound);
    if (!(z > 0.0)) {
        return law;
    }
    law.touches = true;
    law.push[0] = contact.bound / en;
    law.stiffness(0, 0) = 1.0 / en;
    const double sliding = kSlidingMass * problem.contactMass;
    const Eigen::Vector2d t = p.tail<2>() - sliding * (v.tail<2>() + et * p.tail<2>());
    const double size = t.norm();
    const double limit = contact.friction * z;
    if (size <= limit) {
        law.stiffness(1, 1) = law.stiffness(2, 2) = 1.0 / et;
        return law;
    }
    const Eigen::Vector2d direction = t / size;
    const double kappa = limit / size;
    const double s = kappa * sliding / (1.0 - kappa + kappa * sliding * et);
    law.push.tail<2>() = contact.friction * law.push[0] * direction;
    law.stiffness.block<2, 1>(1, 0) = contact.friction / en * direction;
    law.stiffness.block<2, 2>(1, 1) =
        s * (Eigen::Matrix2d::Identity() - direction * direction.transpose());
    return law;
}

}  // namespace

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
    blocks_.assign(n, {});
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = k + 1; i < n; ++i) {
            if (pattern_[k][i]) {
                after_[k].push_back(static_cast<int>(i));
            }
        }
        couple(after_[k]);
        const auto cover = [&blocks = blocks_[k]](int column) {
            if (blocks.empty() || column >= blocks.back() + kBlock) {
                blocks.push_back(column);
            }
        };
        std::for_each(after_[k].begin(), after_[k].end(), cover);
        cover(size_);
    }
}

void PatternedLu::shape(RowMajor& matrix) const {
    matrix.setZero(size_, size_ + kBlock);
}

void PatternedLu::factor(RowMajor& matrix) const {
    using Block = Eigen::Array<double, kBlock, 1>;
    assert(matrix.cols() == size_ + kBlock);
    for (Eigen::Index k = 0; k < size_; ++k) {
        const double* const pivotRow = matrix.row(k).data();
        const double inverse = 1.0 / pivotRow[k];
        const std::vector<int>& blocks = blocks_[static_cast<std::size_t>(k)];
        for (const int i : after_[static_cast<std::size_t>(k)]) {
            double* const row = matrix.row(i).data();
            const double factor = -row[k] * inverse;
            row[k] = -factor;
            for (const int first : blocks) {
                Eigen::Map<Block>(row + first) +=
                    factor * Eigen::Map<const Block>(pivotRow + first);
            }
        }
    }
}

void PatternedLu::solve(const RowMajor& factored, Eigen::VectorXd& x) const {
    for (int k = 0; k < size_; ++k) {
        for (const int i : after_[static_cast<std::size_t>(k)]) {
            x[i] -= factored(i, k) * x[k];
        }
    }
    substituteBack(factored, x);
}

void PatternedLu::solveCarried(const RowMajor& factored, Eigen::VectorXd& x) const {
    x = factored.col(size_);
    substituteBack(factored, x);
}

void PatternedLu::substituteBack(const RowMajor& factored, Eigen::VectorXd& x) const {
    for (int k = size_ - 1; k >= 0; --k) {
        const double* const row = factored.row(k).data();
        double value = x[k];
        for (const int j : after_[static_cast<std::size_t>(k)]) {
            value -= row[j] * x[j];
        }
        x[k] = value / row[k];
    }
}

/// Adds what the contacts' laws say to the matrix and its right side, body by body.
void ImpulseSolver::addContacts(const ImpulseProblem& problem) {
    const std::vector<ContactRow>& contacts = problem.contacts;
    // Of the bodies that hang from one root, what pushes the root is added at once.
    const std::array<int, 6>* root = nullptr;
    Mat6 rootStiffness;
    Vec6 rootPush;
    const auto endRoot = [&] {
        if (root != nullptr) {
            addRoot(*root, rootStiffness, rootPush);
        }
    };
    for (std::size_t c = 0; c < contacts.size();) {
        const int index = contacts[c].body;
        bool pushes = false;
        Mat6 stiffness = Mat6::Zero();
        Vec6 push = Vec6::Zero();
        // Contacts of a body follow each other.
        for (; c < contacts.size() && contacts[c].body == index; ++c) {
            const ContactLaw& law = laws_[c];
            if (law.touches) {
                const auto& wrenches = contacts[c].wrenches;
                const Eigen::Matrix<double, 6, 3> stiffened = wrenches * law.stiffness;
                stiffness.noalias() += stiffened * wrenches.transpose();
                push.noalias() += wrenches * law.push;
                pushes = true;
            }
        }
        if (!pushes) {
            continue;
        }
        const RateMap& body = problem.bodies[static_cast<std::size_t>(index)];
        if (body.root && root != nullptr && *body.root == *root) {
            rootStiffness += stiffness;
            rootPush += push;
        } else if (body.root) {
            endRoot();
            root = &*body.root;
            rootStiffness = stiffness;
            rootPush = push;
        }
        addBody(body, stiffness, push);
    }
    endRoot();
}

/// Adds p = push - stiffness * twist of all that hangs from a root, as it acts on the root.
void ImpulseSolver::addRoot(const std::array<int, 6>& indices, const Mat6& stiffness,
                            const Vec6& push) {
    for (std::size_t i = 0; i < 6; ++i) {
        double* const row = matrix_.row(indices[i]).data();
        for (std::size_t j = 0; j < 6; ++j) {
            row[indices[j]] +=
                stiffness(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
        row[matrix_.rows()] += push[static_cast<Eigen::Index>(i)];
    }
}

/// Adds p = push - stiffness * twist of a body, as it acts on the other rates that move it.
void ImpulseSolver::addBody(const RateMap& body, const Mat6& stiffness, const Vec6& push) {
    for (std::size_t k = 0; k < body.indices.size(); ++k) {
        const Vec6& twist = body.twists[k];
        const Vec6 resisting = stiffness * twist;
        const Vec6 resisted = stiffness.transpose() * twist;
        const int index = body.indices[k];
        double* const row = matrix_.row(index).data();
        for (std::size_t i = 0; body.root && i < 6; ++i) {
            row[(*body.root)[i]] += resisted[static_cast<Eigen::Index>(i)];
            matrix_((*body.root)[i], index) += resisting[static_cast<Eigen::Index>(i)];
        }
        for (std::size_t m = 0; m < body.indices.size(); ++m) {
            row[body.indices[m]] += resisted.dot(body.twists[m]);
        }
        row[matrix_.rows()] += twist.dot(push);
    }
}

void ImpulseSolver::addRows(const ImpulseProblem& problem) {
    const Eigen::Index last = problem.momentum.size();
    for (std::size_t k = 0; k < problem.rows.size(); ++k) {
        const ScalarRow& row = problem.rows[k];
        const bool free = limits_[k] == 0;
        const double impulse =
            free ? row.bound / row.compliance : (limits_[k] > 0 ? row.most : row.least);
        for (std::size_t i = 0; i < row.indices.size(); ++i) {
            matrix_(row.indices[i], last) += row.factors[i] * impulse;
            for (std::size_t j = 0; free && j < row.indices.size(); ++j) {
                matrix_(row.indices[i], row.indices[j]) +=
                    row.factors[i] * row.factors[j] / row.compliance;
            }
        }
    }
}

Vec3 ImpulseSolver::impulseAt(std::size_t index, const ContactRow& contact, Way way,
                              double share) const {
    const Vec3 p = contact.impulse + share * (asked_[index].impulse - contact.impulse);
    return way == Way::Quick ? projected(p, contact.friction) : p;
}

/// Square sum of the natural map of all contacts, that share of the way to what the last solution
/// asks for [N^2 s^2].
double ImpulseSolver::merit(const ImpulseProblem& problem, Way way, double share) const {
    const double opening = kOpeningMass * problem.contactMass;
    const double sliding = kSlidingMass * problem.contactMass;
    double sum = 0.0;
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        const ContactRow& contact = problem.contacts[c];
        const Vec3 p = impulseAt(c, contact, way, share);
        const Vec3 v = contact.velocity + share * (asked_[c].velocity - contact.velocity);
        sum += naturalMap(contact, p, v, problem, opening, sliding).squaredNorm();
    }
    return sum;
}

// A whole step changes the states of many contacts at once, and may change them back in the next.
// The share of it that comes nearest to the laws gets out of that.
double ImpulseSolver::bestShare(const ImpulseProblem& problem, Way way) const {
    double best = kShares.front();
    double least = merit(problem, way, best);
    for (std::size_t i = 1; i < kShares.size(); ++i) {
        if (const double found = merit(problem, way, kShares[i]); found < least) {
            least = found;
            best = kShares[i];
        }
    }
    return best;
}

// A law's tangent leaves the cone where the sliding turns. The quick way puts impulses back onto it
// after each step, which takes a third of the iterations but may cycle where the slow one does not.
bool ImpulseSolver::newton(ImpulseProblem& problem, const PatternedLu& lu, Way way,
                           Eigen::VectorXd& u, ImpulseCounters& counters) {
    const Eigen::Index n = problem.momentum.size();
    visitVelocities(problem, u, [&problem](std::size_t c, const Vec3& velocity) {
        problem.contacts[c].velocity = velocity;
    });
    laws_.resize(problem.contacts.size());
    asked_.resize(problem.contacts.size());
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
        ++counters.iterations;
        matrix_ = problem.mass;
        matrix_.col(n) = problem.momentum;
        for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
            laws_[c] = lawOf(problem.contacts[c], problem);
        }
        addContacts(problem);
        addRows(problem);
        lu.factor(matrix_);
        lu.solveCarried(matrix_, u);
        double residual = 0.0;
        visitVelocities(problem, u, [&](std::size_t c, const Vec3& velocity) {
            Asked& asked = asked_[c];
            asked.velocity = velocity;
            asked.impulse = laws_[c].push - laws_[c].stiffness * velocity;
            residual = std::max(
                residual, residualOf(problem.contacts[c], asked.impulse, asked.velocity, problem));
        });
        const bool solved = !(residual > problem.tolerance);
        // The guess does not move as its impulses say: the first step is a whole one.
        const bool whole = solved || iteration == 0;
        const double share = whole ? 1.0 : bestShare(problem, way);
        for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
            ContactRow& contact = problem.contacts[c];
            contact.impulse = whole ? asked_[c].impulse : impulseAt(c, contact, way, share);
            contact.velocity += share * (asked_[c].velocity - contact.velocity);
        }
        if (solved) {
            return std::isfinite(residual);
        }
    }
    return false;
}

void ImpulseSolver::reserve(std::size_t contacts, std::size_t rows, std::size_t rates) {
    laws_.reserve(contacts);
    asked_.reserve(contacts);
    limits_.reserve(rows);
    firstImpulses_.reserve(contacts);
    // Of gradients(): the largest problems seen have a quarter of this many contacts.
    const std::size_t m = 3 * contacts / 4 + rows;
    room_.reserve(2 * m * rates + m * m + 5 * m + rates);
    free_.reserve(m);
}

void ImpulseSolver::startAgain(ImpulseProblem& problem, Eigen::VectorXd& u) const {
    u = firstU_;
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        problem.contacts[c].impulse = firstImpulses_[c];
    }
}

/// Takes the rows' impulses and limits from u. False when a limit was another one.
bool ImpulseSolver::limitsHold(ImpulseProblem& problem, const Eigen::VectorXd& u) {
    bool hold = true;
    for (std::size_t k = 0; k < problem.rows.size(); ++k) {
        ScalarRow& row = problem.rows[k];
        const double asked = (row.bound - along(row, u)) / row.compliance;
        const int limit = asked > row.most ? 1 : (asked < row.least ? -1 : 0);
        row.impulse = std::clamp(asked, row.least, row.most);
        hold = hold && limit == limits_[k];
        limits_[k] = limit;
    }
    return hold;
}

/// Newton's method one way or another.
bool ImpulseSolver::oneWay(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                           ImpulseCounters& counters) {
    if (newton(problem, lu, Way::Quick, u, counters)) {
        return true;
    }
    startAgain(problem, u);
    if (newton(problem, lu, Way::Slow, u, counters)) {
        return true;
    }
    const double mass = problem.contactMass;
    bool solved = false;
    for (std::size_t i = 0; i < kOtherMasses.size() && !solved; ++i) {
        startAgain(problem, u);
        problem.contactMass = kOtherMasses[i] * mass;
        solved = newton(problem, lu, Way::Quick, u, counters);
    }
    problem.contactMass = mass;
    return solved;
}

// A stop pushes or not, a motor is at a limit or not: changed only between solves of the contacts,
// since changing both at once cycles.
bool ImpulseSolver::withinLimits(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                                 ImpulseCounters& counters) {
    for (int change = 0; change < kMaxLimitChanges; ++change) {
        if (!oneWay(problem, lu, u, counters)) {
            return false;
        }
        if (limitsHold(problem, u)) {
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
        startAgain(problem, u);
        gradients(problem, lu, u, counters);
    }
    double residual = 0.0;
    for (const ContactRow& contact : problem.contacts) {
        residual =
            std::max(residual, residualOf(contact, contact.impulse, contact.velocity, problem));
    }
    if (!(residual <= problem.tolerance)) {
        ++counters.failures;
    }
    assert(residual <= kToleratedResidual * problem.tolerance);
    counters.residual = std::max(counters.residual, residual);
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

// In the space of the impulses, with the matrix of what each does to every velocity. Newton's
// method is tried again from where they get to: near the solution it is far quicker.
void ImpulseSolver::gradients(ImpulseProblem& problem, const PatternedLu& lu, Eigen::VectorXd& u,
                              ImpulseCounters& counters) {
    using Matrix = Eigen::Map<RowMajor>;
    using Vector = Eigen::Map<Eigen::VectorXd>;
    const auto n = problem.momentum.size();
    const auto contactRows = static_cast<Eigen::Index>(3 * problem.contacts.size());
    const auto m = contactRows + static_cast<Eigen::Index>(problem.rows.size());
    size_ = m;
    room_.assign(static_cast<std::size_t>(2 * m * n + m * m + 5 * m + n), 0.0);
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
    Vector unpushed(take(n), n);  // the rates without any impulse

    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
        const ContactRow& contact = problem.contacts[c];
        const RateMap& body = problem.bodies[static_cast<std::size_t>(contact.body)];
        const auto first = static_cast<Eigen::Index>(3 * c);
        for (std::size_t i = 0; body.root && i < 6; ++i) {
            jacobian.col((*body.root)[i]).segment<3>(first) =
                contact.wrenches.row(static_cast<Eigen::Index>(i));
        }
        for (std::size_t i = 0; i < body.indices.size(); ++i) {
            jacobian.col(body.indices[i]).segment<3>(first) +=
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
    matrix_.col(n) = problem.momentum;
    lu.factor(matrix_);
    lu.solveCarried(matrix_, u);
    unpushed = u;
    free_.resize(static_cast<std::size_t>(m));
    Vector(free_.data(), m).noalias() = jacobian * unpushed;
    for (Eigen::Index row = 0; row < m; ++row) {
        u = jacobian.row(row).transpose();
        lu.solve(matrix_, u);
        answers.row(row) = u.transpose();
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
    const auto handOver = [&] {
        u = unpushed;
        u.noalias() += answers.transpose() * p;
        visitVelocities(problem, u, [&](std::size_t c, const Vec3& velocity) {
            ContactRow& contact = problem.contacts[c];
            contact.impulse = p.segment<3>(static_cast<Eigen::Index>(3 * c));
            contact.velocity = velocity;
        });
        for (std::size_t k = 0; k < problem.rows.size(); ++k) {
            problem.rows[k].impulse = p[contactRows + static_cast<Eigen::Index>(k)];
        }
    };
    before = p;
    sweep(problem, p.data());
    gradient = before - p;
    direction = -gradient;
    constexpr double kSweepTolerance = 0.1;
    int nextTry = kSweepsBeforeNewton;
    for (int k = 0; k < kMaxSweeps; ++k) {
        if (k == nextTry) {
            nextTry *= 2;
            handOver();
            limitsHold(problem, u);
            if (newton(problem, lu, Way::Quick, u, counters) && limitsHold(problem, u)) {
                return;
            }
        }
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
    handOver();
}

}  // namespace simcore::dynamics
