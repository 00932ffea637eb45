#pragma once

#include <span>
#include <vector>

#include "simcore/dynamics/spatial.h"
#include "simcore/mechanism/freedoms.h"

/// A mechanism as a tree of bodies that hang from each other by single turns and slides, and the
/// joints that are left over. Tree and motion know nothing of loops, forces from outside or steps.
namespace simcore::dynamics {

/// One turn or slide, or the three turns of a ball, of all that comes after it.
///
/// Geometry is in rover axes at the drawn pose, where every frame coincides with the rover's; axis
/// and point are carried by what comes before. A joint of several freedoms is a row of them.
struct TreeElement {
    enum class Kind { Turn, Slide, Ball };
    Kind kind = Kind::Turn;
    Vec3 axis = Vec3::UnitY();  ///< of a turn or slide
    Vec3 point = Vec3::Zero();  ///< of a turn or ball [m]
    int rate = 0;               ///< its (first) rate
    int ball = -1;              ///< its rotation in the state

    int rateCount() const { return kind == Kind::Ball ? 3 : 1; }
};

/// A body of the tree and how it hangs from the one before it.
struct TreeBody {
    int body = -1;    ///< of the mechanism
    int parent = -1;  ///< position in the tree; -1 = the world
    int joint = -1;   ///< of the mechanism; -1 = floats
    std::vector<TreeElement> elements;
    int lastRate = -1;  ///< of its own or of those before it; -1 = none
};

/// What is free in a tree. A ball has a rotation and leaves its three coordinates unused.
struct TreeState {
    std::vector<double> coordinates;        ///< [rad] or [m], one a rate
    std::vector<Eigen::Quaterniond> balls;  ///< after against before
    std::vector<double> rates;  ///< [rad/s] or [m/s]; of balls in axes of what is before
};

/// Breadth first from the fixed bodies, then from the chassis and from any body not reached yet;
/// those two kinds of start float. Fixed bodies are the world: they are not in the tree.
class SpanningTree {
  public:
    SpanningTree(const mechanism::Mechanism& mechanism, mechanism::Model model);

    /// Each after the one it hangs from.
    const std::vector<TreeBody>& bodies() const { return bodies_; }

    /// Position of a mechanism's body in bodies(); -1 = the world.
    int positionOf(int body) const { return positions_[static_cast<std::size_t>(body)]; }

    /// Mechanism's joints that are not in the tree.
    const std::vector<int>& closures() const { return closures_; }

    int rateCount() const { return static_cast<int>(rateParents_.size()); }

    /// The rate before this one on the way to the world; -1 = none.
    int rateBefore(int rate) const { return rateParents_[static_cast<std::size_t>(rate)]; }

    /// At the drawn pose, at rest.
    TreeState drawnState() const;

  private:
    void grow(int position, const mechanism::Mechanism& mechanism, mechanism::Model model);
    void add(int body, int parent, int joint, std::vector<TreeElement> elements);

    std::vector<TreeBody> bodies_;
    std::vector<int> positions_;
    std::vector<bool> reached_;
    std::vector<bool> jointUsed_;
    std::vector<int> closures_;
    std::vector<int> rateParents_;
    int ballCount_ = 0;
};

/// A rate of a tree in the motion of one body against another.
struct SignedRate {
    int rate = 0;
    double sign = 1.0;
};

/// The rates that move body `second` against body `first` (of the mechanism).
std::vector<SignedRate> relativeRates(const SpanningTree& tree, int first, int second);

/// Adds a wrench that body `first` exerts on body `second` (of the mechanism) to those on the
/// tree's bodies, and its reaction. The world bears anything.
void pushBetween(const SpanningTree& tree, int first, int second, const Vec6& wrench,
                 std::vector<Vec6>& wrenches);

/// Moves the tree on: a coordinate by its number, a ball by a turn vector.
/// @param change  per rate [rad] or [m]
void advance(const SpanningTree& tree, TreeState& state, std::span<const double> change);

/// Poses, motions and forces of a tree in one state, in world axes. All that hangs from one root is
/// about one point.
class TreeMotion {
  public:
    TreeMotion(const mechanism::Mechanism& mechanism, const SpanningTree& tree);

    /// Poses and screws. O becomes the root's centre of mass, or stays the world's origin.
    void place(const TreeState& state);
    /// The same after advance() by that change, where most of it is zero: looks only at what moved.
    void placeChanged(const TreeState& state, std::span<const double> change);
    /// Inertias at the pose placed last.
    void weigh();

    /// The point O that everything of this mechanism's body is about [m]: near its root, so that
    /// rounding does not grow with the way from the world's origin.
    const Vec3& origin(int body) const {
        const int at = tree_.positionOf(body);
        return at < 0 ? drawnOrigin_ : origins_[static_cast<std::size_t>(at)];
    }

    /// X_WB, mechanism order.
    const std::vector<Pose>& poses() const { return poses_; }

    /// Rotation of one of them as a matrix: cheaper where many points are turned by it.
    const Mat3& turn(int body) const {
        const int at = tree_.positionOf(body);
        return at < 0 ? drawnTurn_ : turns_[static_cast<std::size_t>(at)];
    }

    /// Motion of all that comes after, per unit of each rate.
    const std::vector<Vec6>& screws() const { return screws_; }

    /// Of one of the tree's bodies, about O.
    const SpatialInertia& inertia(std::size_t body) const { return inertias_[body]; }

    /// Wrench of gravity on one of the tree's bodies, about O.
    Vec6 weight(std::size_t body, double gravity) const {
        const Vec3 down(0.0, 0.0, -gravity);
        return spatial(inertias_[body].moment.cross(down), inertias_[body].mass * down);
    }

    /// Twists of the tree's bodies for these rates, in `twists`, tree order.
    void twists(std::span<const double> rates, std::vector<Vec6>& twists) const;

    /// Forces that the rates need (inverse dynamics): for the given accelerations, against gravity
    /// and the wrenches from outside.
    /// @param gravity   along -z [m/s^2]
    /// @param wrenches  on each of the tree's bodies from outside
    /// @param forces    per rate [N m] or [N]
    /// @param transmitted  what each of the tree's bodies gets from the one before it; may be null
    void inverseDynamics(std::span<const double> rates, std::span<const double> accelerations,
                         double gravity, const std::vector<Vec6>& wrenches,
                         std::vector<double>& forces, std::vector<Vec6>* transmitted = nullptr);

    /// Calls visit(body, j, p) for every rate j of each of the tree's bodies, with the momentum p
    /// about O that a unit of the rate gives the body and all that hangs from it.
    template <class Visit>
    void visitMomenta(Visit&& visit) {
        composites_ = inertias_;
        for (std::size_t k = composites_.size(); k-- > 0;) {
            const TreeBody& at = tree_.bodies()[k];
            if (at.parent >= 0) {
                composites_[static_cast<std::size_t>(at.parent)] += composites_[k];
            }
            const int before =
                at.parent < 0 ? -1 : tree_.bodies()[static_cast<std::size_t>(at.parent)].lastRate;
            for (int j = at.lastRate; j != before; j = tree_.rateBefore(j)) {
                visit(k, j, composites_[k] * screws_[static_cast<std::size_t>(j)]);
            }
        }
    }

  private:
    void placeBody(std::size_t position, const TreeState& state);

    const mechanism::Mechanism& mechanism_;
    const SpanningTree& tree_;
    std::vector<Mat3> inertiasAtCom_;  ///< rover axes, rotors included
    const Vec3 drawnOrigin_ = Vec3::Zero();
    const Mat3 drawnTurn_ = Mat3::Identity();
    std::vector<Pose> poses_;
    std::vector<Mat3> turns_;    ///< rotations of the tree's bodies
    std::vector<Vec3> origins_;  ///< of the tree's bodies
    std::vector<bool> moved_;    ///< of the tree's bodies, by the last change
    std::vector<Vec6> screws_;
    std::vector<SpatialInertia> inertias_;
    std::vector<SpatialInertia> composites_;
    std::vector<Vec6> twists_;
    std::vector<Vec6> accelerations_;
    std::vector<Vec6> forces_;
};

}  // namespace simcore::dynamics
