#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "simcore/dynamics/spanning_tree.h"

/// What the joints left over by a spanning tree, and the gears, demand of its rates.
namespace simcore::dynamics {

/// A body that floats in the world and that no loop holds: its twist about O is six independent
/// rates.
struct FloatingRoot {
    std::array<int, 6> indices{};  ///< of the independent rates, in the order of a twist
    int lastRate = -1;             ///< of the tree; those of what hangs from it are later
};

/// A rate of the tree as a sum of independent ones.
struct RateTerm {
    int index = 0;  ///< of the independent rate
    double factor = 1.0;
};

/// Loops by coordinate partitioning (R. A. Wehage and E. J. Haug, J. Mech. Design 104, 1982), one
/// cluster of loops that share joints at a time: in each cluster as many rates as its rank depend
/// on the others. Which ones is chosen by elimination with complete pivoting, and again when the
/// choice has become a poor one. Rows that the chosen ones do not need are redundant: their gap is
/// only looked at. When it opens, the loop was in a singular pose before and is chosen anew.
///
/// In a singular pose, as that of a parallelogram with all its bars in line, no choice is good. A
/// loop passes it with the proportions of rates that it came with.
///
/// Independent rates are numbered from the leaves of the tree to its root, which keeps matrices of
/// them sparse under elimination.
class LoopClosures {
  public:
    LoopClosures(const mechanism::Mechanism& mechanism, const SpanningTree& tree,
                 mechanism::Model model);

    /// Forgets choices and turns of gears: the state is the drawn one.
    void reset(TreeState& state, TreeMotion& motion);

    /// Moves the dependent coordinates until all loops are closed, places the motion there and
    /// renews terms(). False when some loop stays open: brokenLoop() then tells which.
    bool close(TreeState& state, TreeMotion& motion);
    /// Places the motion where loops had been closed before restore().
    void resume(const TreeState& state, TreeMotion& motion);

    /// By how much the motion of loops turns from the pose where these rates were right to the pose
    /// closed last: change of a rate over the largest of its loop, where that is not next to rest.
    /// @param change  of every rate when the independent ones stay
    double turnOf(std::span<const double> rates, std::vector<double>& change) const;

    /// Of the pivots that the last close() divided by, the smallest over the largest of its loop;
    /// the least of all loops. Near 0 the pose is a singular one.
    double pivotRatio() const { return pivotRatio_; }

    /// The loop that pivotRatio() is of.
    std::string poorestLoop() const;
    std::string brokenLoop() const;
    /// Loops whose joints leave them no motion at all.
    std::vector<std::string> rigidLoops() const;
    /// Loops in which more rows turned out to be needed than at the drawn pose.
    std::vector<std::string> loopsDrawnSingular() const;

    int independentCount() const { return static_cast<int>(rates_.size()); }

    /// The tree's rate that an independent one is.
    int rateOf(int index) const { return rates_[static_cast<std::size_t>(index)]; }

    /// A rate by independent ones, at the pose closed last.
    std::span<const RateTerm> terms(int rate) const {
        const Span& at = spans_[static_cast<std::size_t>(rate)];
        return {terms_.data() + at.first, terms_.data() + at.end};
    }

    /// The floating root that one of the tree's bodies is or hangs from; null where there is none
    /// or loops hold it.
    const FloatingRoot* rootOf(std::size_t body) const {
        const int root = rootOf_[body];
        return root < 0 ? nullptr : &roots_[static_cast<std::size_t>(root)];
    }

    /// The last rate of that root; -1 where there is none. Later ones are those of a body's way.
    int lastRootRate(std::size_t body) const {
        const FloatingRoot* const root = rootOf(body);
        return root == nullptr ? -1 : root->lastRate;
    }

    /// All of them.
    const std::vector<FloatingRoot>& roots() const { return roots_; }

    /// The terms of all rates, one after the other, and where those of one begin.
    const std::vector<RateTerm>& allTerms() const { return terms_; }

    std::size_t firstTerm(int rate) const {
        return static_cast<std::size_t>(spans_[static_cast<std::size_t>(rate)].first);
    }

    /// Counts choices: patterns of matrices made for an older one are no longer right.
    int choice() const { return choice_; }

    /// Largest gap of any row, redundant ones included, that close() saw last [rad, or wheelbases].
    double gap() const { return gap_; }

    /// Wrenches in the loops that give the tree these forces, least in norm where several do; adds
    /// them to the wrenches on the tree's bodies and writes those of the left-over joints.
    /// @param forces    per rate
    /// @param wrenches  on the tree's bodies
    /// @param joints    on the second body of each mechanism's joint
    void react(const TreeMotion& motion, const std::vector<double>& forces,
               std::vector<Vec6>& wrenches, std::vector<Vec6>& joints);

    /// Of every joint of the mechanism, whether its reaction vanishes in all self-stresses of the
    /// loops, so that the loads determine it.
    std::vector<bool> determinedJoints(const TreeMotion& motion);

    void save(std::vector<double>& numbers) const;
    /// Takes its numbers off the front.
    void restore(std::span<const double>& numbers);

  private:
    /// How a wrench between two bodies acts on a cluster's rates.
    struct Arm {
        int first = -1;
        int second = -1;
        std::vector<SignedRate> rates;
        std::vector<int> columns;  ///< of the cluster, as long as `rates`
    };

    struct Closure {
        int joint = -1;
        int body = -1;  ///< one of the two that is in the tree
        Arm arm;
        std::vector<Vec3> heldSlides;  ///< first body's frame
        std::vector<Vec3> turns;       ///< free ones
        std::vector<Vec3> heldTurns;   ///< of a pin: square to its axis, first body's frame
        int row = 0;                   ///< first row in the cluster
    };

    struct Geared {
        int gear = -1;
        Arm arms[2];
        double angles[2] = {0.0, 0.0};  ///< at the pose closed last, turns counted [rad]
        double anglesNow[2] = {0.0, 0.0};
        int row = 0;

        const Arm& movingArm() const { return arms[arms[0].rates.empty() ? 1 : 0]; }
    };

    struct Cluster {
        std::vector<int> rates;
        std::vector<Closure> closures;
        std::vector<Geared> gears;
        Eigen::MatrixXd jacobian;
        Eigen::VectorXd gaps;
        std::vector<int> dependent;    ///< columns
        std::vector<int> independent;  ///< columns
        std::vector<int> used;         ///< rows
        Eigen::MatrixXd held;          ///< used rows, dependent columns; then its inverse
        Eigen::MatrixXd solved;        ///< dependent rates by independent ones, and correction
        Eigen::MatrixXd work;
        std::size_t drawnRank = 0;
        double triedAt = 1.0;  ///< ratio of pivots at which a better choice was looked for last
    };

    /// While loops are still open, a pose seems to hold more than it does: more than this many rows
    /// are not chosen.
    struct RankRange {
        std::size_t least = 0;
        std::size_t most = std::numeric_limits<std::size_t>::max();
    };

    struct Span {
        int first = 0;
        int end = 0;
    };

    void makeClusters(mechanism::Model model);
    void evaluate(Cluster& cluster, const TreeMotion& motion) const;
    /// Wrench of each of a closure's rows on its second body, with the gaps.
    void evaluateClosure(const Closure& closure, const TreeMotion& motion,
                         std::vector<Vec6>& wrenches, std::vector<double>& gaps) const;
    /// Chooses rows and dependent rates. False when the dependent rates stay the same: where they
    /// are the best, or the pose has a lower rank than asked.
    bool choose(Cluster& cluster, RankRange ranks, double leastPivot) const;
    /// Solves for the dependent rates; the smallest of the pivots over the largest. Where that is
    /// next to nothing, the solution stays as it was, without correction.
    double eliminate(Cluster& cluster) const;
    /// Some row that the chosen ones should close is open.
    bool redundantRowOpens(const Cluster& cluster) const;
    /// Room for the matrices of the present choice.
    static void resize(Cluster& cluster);
    std::string nameOf(const Cluster& cluster) const;
    /// What a combination of a cluster's rows does to bodies and to the left-over joints.
    void apply(const Cluster& cluster, const Eigen::VectorXd& rows, const TreeMotion& motion,
               std::vector<Vec6>& wrenches, std::vector<Vec6>& joints) const;
    void number();
    void findRoots();
    void renewTerms();

    const mechanism::Mechanism& mechanism_;
    const SpanningTree& tree_;
    double length_;  ///< makes gaps and turns comparable [m]
    std::vector<Cluster> clusters_;
    std::vector<int> rates_;
    std::vector<Span> spans_;
    std::vector<RateTerm> terms_;
    std::vector<FloatingRoot> roots_;
    std::vector<int> rootOf_;  ///< of each of the tree's bodies; -1 = none
    std::vector<double> change_;
    int choice_ = 0;
    double gap_ = 0.0;
    double pivotRatio_ = 1.0;
    std::size_t poorest_ = 0;
    std::size_t broken_ = 0;
    mutable std::vector<Vec6> rowWrenches_;
    mutable std::vector<double> rowGaps_;
};

/// LoopClosures::determinedJoints() at the drawn pose.
std::vector<bool> determinedJoints(const mechanism::Mechanism& mechanism, mechanism::Model model);

}  // namespace simcore::dynamics
