#include "simcore/dynamics/loop_closures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include <Eigen/LU>
#include <Eigen/QR>
#include "simcore/base/text.h"

#include "simcore/base/groups.h"

namespace simcore::dynamics {
namespace {

using mechanism::FreedomKind;

/// Pivots below this share of the first one are no rank.
constexpr double kRank = 1e-8;
/// A better choice of dependent rates is looked for when the pivots get this far apart: a small
/// error of an independent coordinate is that much larger in a dependent one (assumed).
constexpr double kPoorChoice = 0.1;
/// It is looked for again when they got further apart by this factor.
constexpr double kMuchBetter = 0.5;
/// Below this share the pose counts as singular: what is divided by such pivots is noise.
constexpr double kSingular = 1e-7;
/// Gaps that are left [rad, or wheelbases].
constexpr double kClosed = 1e-11;
/// From gaps below this one correction leaves only their square, and turns no term by more than
/// about as much: terms are then not worked out again.
constexpr double kNearlyClosed = 1e-7;
/// Gap of a redundant row that inexact drawing does not explain, and the least pivot that such a
/// row is then asked for: off a singular pose by an angle, gaps are of its square, pivots of
/// itself.
constexpr double kOpen = 1e-6;
constexpr double kNewRank = 1e-5;
constexpr int kMaxCorrections = 12;

/// The turn that a rotation makes, as a vector [rad].
Vec3 turnVector(const Eigen::Quaterniond& rotation) {
    const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
    const Vec3 v = sign * rotation.vec();
    const double sine = v.norm();
    if (sine < 1e-12) {
        return 2.0 * v;
    }
    return 2.0 * std::atan2(sine, sign * rotation.w()) / sine * v;
}

}  // namespace

LoopClosures::LoopClosures(const mechanism::Mechanism& mechanism, const SpanningTree& tree,
                           mechanism::Model model)
    : mechanism_(mechanism),
      tree_(tree),
      length_(mechanism.wheelbase()),
      spans_(static_cast<std::size_t>(tree.rateCount())),
      change_(static_cast<std::size_t>(tree.rateCount()), 0.0) {
    makeClusters(model);
}

void LoopClosures::makeClusters(mechanism::Model model) {
    // Rates that occur in one demand are in one cluster.
    Groups groups(static_cast<std::size_t>(tree_.rateCount()));
    const auto join = [&groups](const std::vector<SignedRate>& a,
                                const std::vector<SignedRate>& b) {
        for (const auto* rates : {&a, &b}) {
            for (const SignedRate& signed_ : *rates) {
                groups.join(a.front().rate, signed_.rate);
            }
        }
    };
    std::vector<Closure> closures;
    for (int index : tree_.closures()) {
        const mechanism::Joint& joint = mechanism_.joints[static_cast<std::size_t>(index)];
        const auto& freedoms = freedomsOf(joint, model);
        Closure closure;
        closure.joint = index;
        closure.body = tree_.positionOf(joint.second) >= 0 ? joint.second : joint.first;
        closure.arm = {
            joint.first, joint.second, relativeRates(tree_, joint.first, joint.second), {}};
        closure.heldSlides =
            mechanism::orthogonalComplement(directionsOf(freedoms, FreedomKind::Slide));
        closure.turns = directionsOf(freedoms, FreedomKind::Turn);
        if (closure.turns.size() == 1) {
            closure.heldTurns = mechanism::orthogonalComplement(closure.turns);
        }
        if (closure.arm.rates.empty()) {
            continue;  // both bodies are fixed
        }
        join(closure.arm.rates, closure.arm.rates);
        closures.push_back(std::move(closure));
    }
    std::vector<Geared> gears;
    for (std::size_t i = 0; i < mechanism_.gears.size(); ++i) {
        Geared geared;
        geared.gear = static_cast<int>(i);
        const int joints[2] = {mechanism_.gears[i].firstJoint, mechanism_.gears[i].secondJoint};
        for (int side = 0; side < 2; ++side) {
            const mechanism::Joint& joint =
                mechanism_.joints[static_cast<std::size_t>(joints[side])];
            geared.arms[side] = {
                joint.first, joint.second, relativeRates(tree_, joint.first, joint.second), {}};
        }
        // A pin between fixed bodies stands still: the gear holds the other one.
        if (geared.arms[0].rates.empty() && geared.arms[1].rates.empty()) {
            continue;
        }
        join(geared.movingArm().rates, geared.arms[1].rates);
        join(geared.movingArm().rates, geared.arms[0].rates);
        gears.push_back(std::move(geared));
    }
    std::vector<int> clusterOf(static_cast<std::size_t>(tree_.rateCount()), -1);
    const auto clusterFor = [&](int rate) -> Cluster& {
        int& cluster = clusterOf[static_cast<std::size_t>(groups.of(rate))];
        if (cluster < 0) {
            cluster = static_cast<int>(clusters_.size());
            clusters_.emplace_back();
        }
        return clusters_[static_cast<std::size_t>(cluster)];
    };
    const auto enter = [](Cluster& cluster, Arm& arm) {
        for (const SignedRate& signed_ : arm.rates) {
            const auto at = std::find(cluster.rates.begin(), cluster.rates.end(), signed_.rate);
            arm.columns.push_back(static_cast<int>(at - cluster.rates.begin()));
            if (at == cluster.rates.end()) {
                cluster.rates.push_back(signed_.rate);
            }
        }
    };
    std::vector<int> rowCounts;
    const auto rows = [&](Cluster& cluster) -> int& {
        rowCounts.resize(clusters_.size(), 0);
        return rowCounts[static_cast<std::size_t>(&cluster - clusters_.data())];
    };
    for (Closure& closure : closures) {
        Cluster& cluster = clusterFor(closure.arm.rates.front().rate);
        enter(cluster, closure.arm);
        closure.row = rows(cluster);
        rows(cluster) += static_cast<int>(closure.heldSlides.size() + 3 - closure.turns.size());
        cluster.closures.push_back(std::move(closure));
    }
    for (Geared& geared : gears) {
        Cluster& cluster = clusterFor(geared.movingArm().rates.front().rate);
        enter(cluster, geared.arms[0]);
        enter(cluster, geared.arms[1]);
        geared.row = rows(cluster)++;
        cluster.gears.push_back(std::move(geared));
    }
    for (Cluster& cluster : clusters_) {
        const int rowCount = rows(cluster);
        cluster.jacobian.setZero(rowCount, static_cast<int>(cluster.rates.size()));
        cluster.gaps.setZero(rowCount);
    }
}

void LoopClosures::evaluateClosure(const Closure& closure, const TreeMotion& motion,
                                   std::vector<Vec6>& wrenches, std::vector<double>& gaps) const {
    const mechanism::Joint& joint = mechanism_.joints[static_cast<std::size_t>(closure.joint)];
    const std::vector<Pose>& poses = motion.poses();
    const Mat3& first = motion.turn(joint.first);
    const Mat3& second = motion.turn(joint.second);
    const Vec3 point =
        second * joint.point + poses[static_cast<std::size_t>(joint.second)].position;
    const Vec3 gap =
        point - first * joint.point - poses[static_cast<std::size_t>(joint.first)].position;
    wrenches.clear();
    gaps.clear();
    for (const Vec3& direction : closure.heldSlides) {
        const Vec3 n = first * direction / length_;
        wrenches.push_back(forceAt(n, point - motion.origin(closure.body)));
        gaps.push_back(n.dot(gap));
    }
    const auto addTurn = [&](const Vec3& axis, double turn) {
        wrenches.push_back(spatial(axis, Vec3::Zero()));
        gaps.push_back(turn);
    };
    switch (closure.turns.size()) {
        case 0: {
            const Vec3 turn =
                turnVector(poses[static_cast<std::size_t>(joint.first)].rotation.conjugate() *
                           poses[static_cast<std::size_t>(joint.second)].rotation);
            for (int axis = 0; axis < 3; ++axis) {
                addTurn(first.col(axis), turn[axis]);
            }
            break;
        }
        case 1: {
            const Vec3 carried = second * closure.turns[0];
            for (const Vec3& across : closure.heldTurns) {
                const Vec3 fixed = first * across;
                addTurn(carried.cross(fixed), fixed.dot(carried));
            }
            break;
        }
        case 2: {
            const Vec3 carried = second * closure.turns[1];
            const Vec3 fixed = first * closure.turns[0];
            addTurn(carried.cross(fixed),
                    fixed.dot(carried) - closure.turns[0].dot(closure.turns[1]));
            break;
        }
        default:
            break;
    }
}

void LoopClosures::evaluate(Cluster& cluster, const TreeMotion& motion) const {
    cluster.jacobian.setZero();
    for (const Closure& closure : cluster.closures) {
        evaluateClosure(closure, motion, rowWrenches_, rowGaps_);
        for (std::size_t r = 0; r < rowWrenches_.size(); ++r) {
            const int row = closure.row + static_cast<int>(r);
            cluster.gaps[row] = rowGaps_[r];
            for (std::size_t i = 0; i < closure.arm.rates.size(); ++i) {
                const SignedRate& signed_ = closure.arm.rates[i];
                cluster.jacobian(row, closure.arm.columns[i]) =
                    signed_.sign *
                    rowWrenches_[r].dot(motion.screws()[static_cast<std::size_t>(signed_.rate)]);
            }
        }
    }
    for (Geared& geared : cluster.gears) {
        const mechanism::Gear& gear = mechanism_.gears[static_cast<std::size_t>(geared.gear)];
        const int joints[2] = {gear.firstJoint, gear.secondJoint};
        const double factors[2] = {-gear.ratio, 1.0};
        cluster.gaps[geared.row] = 0.0;
        for (int side = 0; side < 2; ++side) {
            const Arm& arm = geared.arms[side];
            const mechanism::Joint& joint =
                mechanism_.joints[static_cast<std::size_t>(joints[side])];
            const double angle = jointAngle(joint, motion.poses());
            geared.anglesNow[side] =
                geared.angles[side] +
                std::remainder(angle - geared.angles[side], 2.0 * std::numbers::pi);
            cluster.gaps[geared.row] += factors[side] * geared.anglesNow[side];
            const Vec3 axis = motion.turn(arm.first) * joint.axis;
            for (std::size_t i = 0; i < arm.rates.size(); ++i) {
                const Vec6& screw = motion.screws()[static_cast<std::size_t>(arm.rates[i].rate)];
                cluster.jacobian(geared.row, arm.columns[i]) +=
                    factors[side] * arm.rates[i].sign * axis.dot(screw.head<3>());
            }
        }
    }
}

bool LoopClosures::choose(Cluster& cluster, RankRange ranks, double leastPivot) const {
    Eigen::MatrixXd rest = cluster.jacobian;
    std::vector<int> rows(static_cast<std::size_t>(rest.rows()));
    std::vector<int> columns(static_cast<std::size_t>(rest.cols()));
    std::iota(rows.begin(), rows.end(), 0);
    std::iota(columns.begin(), columns.end(), 0);
    int rank = 0;
    double first = 0.0;
    const auto size =
        static_cast<int>(std::min({static_cast<std::size_t>(rest.rows()),
                                   static_cast<std::size_t>(rest.cols()), ranks.most}));
    while (rank < size) {
        int row = 0;
        int column = 0;
        const double pivot = rest.bottomRightCorner(rest.rows() - rank, rest.cols() - rank)
                                 .cwiseAbs()
                                 .maxCoeff(&row, &column);
        first = rank == 0 ? pivot : first;
        if (pivot <= leastPivot * first || pivot == 0.0) {
            break;
        }
        row += rank;
        column += rank;
        rest.row(rank).swap(rest.row(row));
        rest.col(rank).swap(rest.col(column));
        std::swap(rows[static_cast<std::size_t>(rank)], rows[static_cast<std::size_t>(row)]);
        std::swap(columns[static_cast<std::size_t>(rank)],
                  columns[static_cast<std::size_t>(column)]);
        for (Eigen::Index i = rank + 1; i < rest.rows(); ++i) {
            const double factor = rest(i, rank) / rest(rank, rank);
            rest.row(i).tail(rest.cols() - rank) -=
                factor * rest.row(rank).tail(rest.cols() - rank);
        }
        ++rank;
    }
    if (static_cast<std::size_t>(rank) < ranks.least) {
        return false;
    }
    cluster.used.assign(rows.begin(), rows.begin() + rank);
    if (static_cast<std::size_t>(rank) == cluster.dependent.size() &&
        std::is_permutation(columns.begin(), columns.begin() + rank, cluster.dependent.begin())) {
        return false;
    }
    cluster.dependent.assign(columns.begin(), columns.begin() + rank);
    cluster.independent.assign(columns.begin() + rank, columns.end());
    resize(cluster);
    return true;
}

void LoopClosures::resize(Cluster& cluster) {
    const auto rank = static_cast<Eigen::Index>(cluster.dependent.size());
    cluster.held.resize(rank, rank);
    cluster.solved.setZero(rank, static_cast<Eigen::Index>(cluster.independent.size()) + 1);
    cluster.work = cluster.solved;
}

double LoopClosures::eliminate(Cluster& cluster) const {
    const auto rank = static_cast<Eigen::Index>(cluster.dependent.size());
    const auto others = static_cast<Eigen::Index>(cluster.independent.size());
    for (Eigen::Index r = 0; r < rank; ++r) {
        const int row = cluster.used[static_cast<std::size_t>(r)];
        for (Eigen::Index c = 0; c < rank; ++c) {
            cluster.held(r, c) =
                cluster.jacobian(row, cluster.dependent[static_cast<std::size_t>(c)]);
        }
        for (Eigen::Index c = 0; c < others; ++c) {
            cluster.work(r, c) =
                -cluster.jacobian(row, cluster.independent[static_cast<std::size_t>(c)]);
        }
        cluster.work(r, others) = -cluster.gaps[row];
    }
    // Gauss-Jordan with row pivoting, in place: matrices here are 2 x 2 to about 10 x 10.
    double smallest = 1e300;
    double largest = 0.0;
    for (Eigen::Index k = 0; k < rank; ++k) {
        Eigen::Index pivotRow = k;
        cluster.held.col(k).tail(rank - k).cwiseAbs().maxCoeff(&pivotRow);
        pivotRow += k;
        if (pivotRow != k) {
            cluster.held.row(k).swap(cluster.held.row(pivotRow));
            cluster.work.row(k).swap(cluster.work.row(pivotRow));
        }
        const double pivot = cluster.held(k, k);
        smallest = std::min(smallest, std::abs(pivot));
        largest = std::max(largest, std::abs(pivot));
        if (std::abs(pivot) <= kSingular * largest) {
            cluster.solved.col(others).setZero();
            return 0.0;
        }
        for (Eigen::Index i = 0; i < rank; ++i) {
            const double factor = cluster.held(i, k) / pivot;
            if (i == k || factor == 0.0) {
                continue;
            }
            for (Eigen::Index c = k; c < rank; ++c) {
                cluster.held(i, c) -= factor * cluster.held(k, c);
            }
            for (Eigen::Index c = 0; c <= others; ++c) {
                cluster.work(i, c) -= factor * cluster.work(k, c);
            }
        }
    }
    for (Eigen::Index k = 0; k < rank; ++k) {
        cluster.solved.row(k) = cluster.work.row(k) / cluster.held(k, k);
    }
    return rank == 0 ? 1.0 : smallest / largest;
}

bool LoopClosures::redundantRowOpens(const Cluster& cluster) const {
    return cluster.gaps.size() > 0 && cluster.gaps.cwiseAbs().maxCoeff() > kOpen;
}

void LoopClosures::reset(TreeState& state, TreeMotion& motion) {
    motion.place(state);
    for (Cluster& cluster : clusters_) {
        for (Geared& geared : cluster.gears) {
            geared.angles[0] = geared.angles[1] = 0.0;
        }
        evaluate(cluster, motion);
        cluster.triedAt = 1.0;
        cluster.used.clear();
        cluster.dependent.clear();
        cluster.independent.assign(cluster.rates.size(), 0);
        std::iota(cluster.independent.begin(), cluster.independent.end(), 0);
        cluster.solved.setZero(0, cluster.jacobian.cols() + 1);
        choose(cluster, {}, kRank);
        cluster.drawnRank = cluster.used.size();
    }
    number();
    close(state, motion);
}

bool LoopClosures::close(TreeState& state, TreeMotion& motion) {
    motion.place(state);
    const auto correct = [&] {
        advance(tree_, state, change_);
        motion.placeChanged(state, change_);
    };
    bool chosen = false;
    bool closed = false;
    for (int correction = 0; !closed && correction <= kMaxCorrections; ++correction) {
        if (correction > 0) {
            correct();
        }
        closed = true;
        bool nearlyClosed = true;
        gap_ = 0.0;
        pivotRatio_ = 1.0;
        std::fill(change_.begin(), change_.end(), 0.0);
        for (std::size_t c = 0; c < clusters_.size(); ++c) {
            Cluster& cluster = clusters_[c];
            evaluate(cluster, motion);
            double ratio = eliminate(cluster);
            const auto usedRowsClose = [&cluster](double gap = kClosed) {
                return std::all_of(cluster.used.begin(), cluster.used.end(),
                                   [&](int row) { return std::abs(cluster.gaps[row]) < gap; });
            };
            const std::size_t rank = cluster.used.size();
            if (ratio < kPoorChoice && ratio < kMuchBetter * cluster.triedAt) {
                cluster.triedAt = ratio;
                if (choose(cluster, {rank, rank}, kRank)) {
                    chosen = true;
                    ratio = eliminate(cluster);
                }
            } else if (ratio > kPoorChoice) {
                cluster.triedAt = 1.0;
            }
            if (usedRowsClose(kNearlyClosed) && redundantRowOpens(cluster) &&
                choose(cluster, {rank + 1}, kNewRank)) {
                ratio = eliminate(cluster);
                chosen = true;
            }
            if (ratio < pivotRatio_) {
                pivotRatio_ = ratio;
                poorest_ = c;
            }
            if (ratio < kSingular) {
                continue;  // closed again at the next pose
            }
            const Eigen::Index last = cluster.solved.cols() - 1;
            for (std::size_t i = 0; i < cluster.dependent.size(); ++i) {
                const int rate = cluster.rates[static_cast<std::size_t>(cluster.dependent[i])];
                change_[static_cast<std::size_t>(rate)] =
                    cluster.solved(static_cast<Eigen::Index>(i), last);
            }
            if (!usedRowsClose()) {
                closed = false;
                broken_ = c;
                nearlyClosed = nearlyClosed && ratio > kPoorChoice && usedRowsClose(kNearlyClosed);
            }
            gap_ =
                std::max(gap_, cluster.gaps.size() > 0 ? cluster.gaps.cwiseAbs().maxCoeff() : 0.0);
        }
        if (!closed && nearlyClosed) {
            correct();
            closed = true;
        }
    }
    for (Cluster& cluster : clusters_) {
        for (Geared& geared : cluster.gears) {
            geared.angles[0] = geared.anglesNow[0];
            geared.angles[1] = geared.anglesNow[1];
        }
    }
    if (chosen) {
        number();
    }
    renewTerms();
    return closed;
}

void LoopClosures::resume(const TreeState& state, TreeMotion& motion) {
    motion.place(state);
    renewTerms();
}

double LoopClosures::turnOf(std::span<const double> rates, std::vector<double>& change) const {
    constexpr double kRest = 1e-3;  // [rad/s]
    change.assign(rates.size(), 0.0);
    double turn = 0.0;
    for (const Cluster& cluster : clusters_) {
        double largest = kRest;
        for (const int rate : cluster.rates) {
            largest = std::max(largest, std::abs(rates[static_cast<std::size_t>(rate)]));
        }
        for (const int column : cluster.dependent) {
            const int rate = cluster.rates[static_cast<std::size_t>(column)];
            double& changed = change[static_cast<std::size_t>(rate)];
            changed = -rates[static_cast<std::size_t>(rate)];
            for (const RateTerm& term : terms(rate)) {
                changed += term.factor * rates[static_cast<std::size_t>(rateOf(term.index))];
            }
            turn = std::max(turn, std::abs(changed) / largest);
        }
    }
    return turn;
}

std::string LoopClosures::nameOf(const Cluster& cluster) const {
    std::vector<int> joints;
    const auto add = [&joints](int joint) {
        if (joint >= 0 && std::find(joints.begin(), joints.end(), joint) == joints.end()) {
            joints.push_back(joint);
        }
    };
    for (const TreeBody& at : tree_.bodies()) {
        for (const TreeElement& element : at.elements) {
            if (std::find(cluster.rates.begin(), cluster.rates.end(), element.rate) !=
                cluster.rates.end()) {
                add(at.joint);
            }
        }
    }
    for (const Closure& closure : cluster.closures) {
        add(closure.joint);
    }
    std::sort(joints.begin(), joints.end());
    std::string names;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        names += (i == 0 ? "" : ", ") + mechanism_.joints[static_cast<std::size_t>(joints[i])].name;
    }
    return Text::of("the loop of joints {}", names);
}

std::string LoopClosures::poorestLoop() const {
    return clusters_.empty() ? std::string() : nameOf(clusters_[poorest_]);
}

std::string LoopClosures::brokenLoop() const {
    return clusters_.empty() ? std::string() : nameOf(clusters_[broken_]);
}

std::vector<std::string> LoopClosures::rigidLoops() const {
    std::vector<std::string> names;
    for (const Cluster& cluster : clusters_) {
        if (cluster.independent.empty()) {
            names.push_back(nameOf(cluster));
        }
    }
    return names;
}

std::vector<std::string> LoopClosures::loopsDrawnSingular() const {
    std::vector<std::string> names;
    for (const Cluster& cluster : clusters_) {
        if (cluster.used.size() > cluster.drawnRank) {
            names.push_back(nameOf(cluster));
        }
    }
    return names;
}

void LoopClosures::number() {
    std::vector<bool> depends(static_cast<std::size_t>(tree_.rateCount()), false);
    std::size_t termCount = 0;
    for (const Cluster& cluster : clusters_) {
        for (int column : cluster.dependent) {
            depends[static_cast<std::size_t>(cluster.rates[static_cast<std::size_t>(column)])] =
                true;
        }
        termCount += cluster.dependent.size() * cluster.independent.size();
    }
    rates_.clear();
    for (int rate = tree_.rateCount() - 1; rate >= 0; --rate) {
        if (!depends[static_cast<std::size_t>(rate)]) {
            rates_.push_back(rate);
        }
    }
    terms_.assign(rates_.size() + termCount, {});
    std::vector<int> indexOf(depends.size(), -1);
    for (std::size_t index = 0; index < rates_.size(); ++index) {
        const auto rate = static_cast<std::size_t>(rates_[index]);
        indexOf[rate] = static_cast<int>(index);
        terms_[index] = {static_cast<int>(index), 1.0};
        spans_[rate] = {static_cast<int>(index), static_cast<int>(index) + 1};
    }
    auto next = static_cast<int>(rates_.size());
    for (const Cluster& cluster : clusters_) {
        for (int column : cluster.dependent) {
            const int rate = cluster.rates[static_cast<std::size_t>(column)];
            spans_[static_cast<std::size_t>(rate)].first = next;
            for (int other : cluster.independent) {
                const int otherRate = cluster.rates[static_cast<std::size_t>(other)];
                terms_[static_cast<std::size_t>(next++)].index =
                    indexOf[static_cast<std::size_t>(otherRate)];
            }
            spans_[static_cast<std::size_t>(rate)].end = next;
        }
    }
    findRoots();
    ++choice_;
}

void LoopClosures::findRoots() {
    roots_.clear();
    rootOf_.assign(tree_.bodies().size(), -1);
    for (std::size_t k = 0; k < rootOf_.size(); ++k) {
        const TreeBody& at = tree_.bodies()[k];
        if (at.parent >= 0) {
            rootOf_[k] = rootOf_[static_cast<std::size_t>(at.parent)];
            continue;
        }
        // Three slides along the world's axes, then a ball at its centre of mass, which is O.
        FloatingRoot root{{}, at.lastRate};
        bool free = at.joint < 0;
        for (int i = 0; free && i < 6; ++i) {
            const int rate = at.lastRate - 5 + i;
            const auto own = std::find(rates_.begin(), rates_.end(), rate);
            free = own != rates_.end();
            root.indices[static_cast<std::size_t>((i + 3) % 6)] =
                static_cast<int>(own - rates_.begin());
        }
        if (free) {
            rootOf_[k] = static_cast<int>(roots_.size());
            roots_.push_back(root);
        }
    }
}

void LoopClosures::renewTerms() {
    std::size_t next = rates_.size();
    for (const Cluster& cluster : clusters_) {
        for (std::size_t i = 0; i < cluster.dependent.size(); ++i) {
            for (std::size_t j = 0; j < cluster.independent.size(); ++j) {
                terms_[next++].factor =
                    cluster.solved(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            }
        }
    }
}

void LoopClosures::apply(const Cluster& cluster, const Eigen::VectorXd& rows,
                         const TreeMotion& motion, std::vector<Vec6>& wrenches,
                         std::vector<Vec6>& joints) const {
    for (const Closure& closure : cluster.closures) {
        evaluateClosure(closure, motion, rowWrenches_, rowGaps_);
        Vec6 wrench = Vec6::Zero();
        for (std::size_t r = 0; r < rowWrenches_.size(); ++r) {
            wrench += rows[closure.row + static_cast<Eigen::Index>(r)] * rowWrenches_[r];
        }
        pushBetween(tree_, closure.arm.first, closure.arm.second, wrench, wrenches);
        joints[static_cast<std::size_t>(closure.joint)] += wrench;
    }
    for (const Geared& geared : cluster.gears) {
        const mechanism::Gear& gear = mechanism_.gears[static_cast<std::size_t>(geared.gear)];
        const int gearJoints[2] = {gear.firstJoint, gear.secondJoint};
        const double factors[2] = {-gear.ratio, 1.0};
        for (int side = 0; side < 2; ++side) {
            const Arm& arm = geared.arms[side];
            const Vec3 axis = motion.poses()[static_cast<std::size_t>(arm.first)].rotation *
                              mechanism_.joints[static_cast<std::size_t>(gearJoints[side])].axis;
            pushBetween(tree_, arm.first, arm.second,
                        spatial(factors[side] * rows[geared.row] * axis, Vec3::Zero()), wrenches);
        }
    }
}

void LoopClosures::react(const TreeMotion& motion, const std::vector<double>& forces,
                         std::vector<Vec6>& wrenches, std::vector<Vec6>& joints) {
    for (Cluster& cluster : clusters_) {
        evaluate(cluster, motion);
        Eigen::VectorXd wanted(static_cast<Eigen::Index>(cluster.rates.size()));
        for (Eigen::Index i = 0; i < wanted.size(); ++i) {
            wanted[i] =
                forces[static_cast<std::size_t>(cluster.rates[static_cast<std::size_t>(i)])];
        }
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> split;
        split.setThreshold(kRank);
        split.compute(cluster.jacobian.transpose());
        apply(cluster, split.solve(wanted), motion, wrenches, joints);
    }
}

std::vector<bool> LoopClosures::determinedJoints(const TreeMotion& motion) {
    // Self-stress below this share of the largest is rounding.
    constexpr double kNone = 1e-6;
    std::vector<bool> determined(mechanism_.joints.size(), true);
    for (Cluster& cluster : clusters_) {
        evaluate(cluster, motion);
        Eigen::FullPivHouseholderQR<Eigen::MatrixXd> rank;
        rank.setThreshold(kRank);
        rank.compute(cluster.jacobian);
        const Eigen::MatrixXd basis = rank.matrixQ();
        for (Eigen::Index stress = rank.rank(); stress < basis.cols(); ++stress) {
            std::vector<Vec6> wrenches(tree_.bodies().size(), Vec6::Zero());
            std::vector<Vec6> joints(determined.size(), Vec6::Zero());
            apply(cluster, basis.col(stress), motion, wrenches, joints);
            // The tree bears what acts on all that hangs from a joint.
            for (std::size_t k = tree_.bodies().size(); k-- > 0;) {
                const TreeBody& at = tree_.bodies()[k];
                if (at.joint >= 0) {
                    joints[static_cast<std::size_t>(at.joint)] = wrenches[k];
                }
                if (at.parent >= 0) {
                    wrenches[static_cast<std::size_t>(at.parent)] += wrenches[k];
                }
            }
            double largest = 0.0;
            for (const Vec6& wrench : joints) {
                largest = std::max(largest, wrench.cwiseAbs().maxCoeff());
            }
            for (std::size_t i = 0; i < joints.size(); ++i) {
                if (joints[i].cwiseAbs().maxCoeff() > kNone * largest) {
                    determined[i] = false;
                }
            }
        }
    }
    return determined;
}

void LoopClosures::save(std::vector<double>& numbers) const {
    const auto addAll = [&numbers](const std::vector<int>& values) {
        numbers.push_back(static_cast<double>(values.size()));
        numbers.insert(numbers.end(), values.begin(), values.end());
    };
    for (const Cluster& cluster : clusters_) {
        addAll(cluster.dependent);
        addAll(cluster.independent);
        addAll(cluster.used);
        numbers.push_back(cluster.triedAt);
        // A singular pose does not tell them again.
        numbers.insert(numbers.end(), cluster.solved.data(),
                       cluster.solved.data() + cluster.solved.size());
        for (const Geared& geared : cluster.gears) {
            numbers.insert(numbers.end(), {geared.angles[0], geared.angles[1]});
        }
    }
}

void LoopClosures::restore(std::span<const double>& numbers) {
    const auto take = [&numbers] {
        if (numbers.empty()) {
            throw std::invalid_argument("the state belongs to another mechanism");
        }
        const double number = numbers.front();
        numbers = numbers.subspan(1);
        return number;
    };
    const auto takeAll = [&](std::vector<int>& values) {
        values.resize(static_cast<std::size_t>(take()));
        for (int& value : values) {
            value = static_cast<int>(take());
        }
    };
    for (Cluster& cluster : clusters_) {
        takeAll(cluster.dependent);
        takeAll(cluster.independent);
        takeAll(cluster.used);
        cluster.triedAt = take();
        resize(cluster);
        for (Eigen::Index i = 0; i < cluster.solved.size(); ++i) {
            cluster.solved.data()[i] = take();
        }
        for (Geared& geared : cluster.gears) {
            geared.angles[0] = take();
            geared.angles[1] = take();
        }
    }
    number();
}

std::vector<bool> determinedJoints(const mechanism::Mechanism& mechanism, mechanism::Model model) {
    const SpanningTree tree(mechanism, model);
    TreeMotion motion(mechanism, tree);
    LoopClosures loops(mechanism, tree, model);
    TreeState state = tree.drawnState();
    loops.reset(state, motion);
    return loops.determinedJoints(motion);
}

}  // namespace simcore::dynamics
