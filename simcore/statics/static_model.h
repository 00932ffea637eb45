#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "simcore/dynamics/loop_closures.h"
#include "simcore/dynamics/reduced_inertia.h"
#include "simcore/dynamics/spanning_tree.h"
#include "simcore/mechanism/mechanism.h"

/// Forces of a rover that stands or creeps: inertia plays no part (Lamon et al. 2004, section 3).
namespace simcore::statics {

using mechanism::Model;

/// Which lateral forces are unknowns.
enum class ContactSet {
    Free,  ///< only at wheels whose lateral slide is not freed in the relaxed model (paper: 14)
    All,   ///< at every wheel (18)
};

/// Where a wheel touches the ground.
struct Contact {
    int wheel = -1;
    Vec3 point = Vec3::Zero();     ///< world [m]
    Vec3 normal = Vec3::UnitZ();   ///< unit, from the ground to the wheel, world
    Vec3 forward = Vec3::UnitX();  ///< unit, rolling direction, square to the normal, world
};

/// A wheel's contact at the rim under a contact angle [rad].
Contact contactAtAngle(const mechanism::Mechanism& mechanism, int wheel,
                       const std::vector<Pose>& poses, double angle);

/// A joint that stands at one of its stops.
struct JointStop {
    int joint = -1;
    double sign = 1.0;  ///< of the moment on the second body: + at the lower stop
};

/// M U = R: balance of all internal motions of a mechanism (paper eq. 2, 3).
///
/// U holds the normal forces of all contacts, their tractions (forward), the lateral forces that
/// the contact set has, the moments of joints at their stops, and the torques of all wheels that
/// touch. Forces act on the wheels; a positive torque drives forward.
struct Equilibrium {
    Eigen::MatrixXd matrix;             ///< M: one row an independent motion
    Eigen::VectorXd right;              ///< R: weight and springs [N m] or [N]
    std::vector<int> normal, traction;  ///< columns, one a contact
    std::vector<int> lateral;           ///< columns, one a contact; -1 = no such unknown
    std::vector<int> stop;              ///< columns, one a joint at its stop: moments off it [N m]
    std::vector<int> torque;            ///< columns, one a wheel; -1 = it hangs
};

/// Mechanism of a rover with its kinematics, for many poses.
///
/// The internal reactions are eliminated by motions instead of a null space: the spanning tree's
/// rates that its loops leave independent move bodies without work of any joint (principle of
/// virtual work). What joints redundantly hold among each other never enters.
class StaticModel {
  public:
    /// Throws std::invalid_argument when no engine could run it (dynamics::whyNoEngineCanRun).
    StaticModel(const mechanism::Mechanism& mechanism, Model joints);

    StaticModel(const StaticModel&) = delete;
    StaticModel& operator=(const StaticModel&) = delete;

    const mechanism::Mechanism& mechanism() const { return mechanism_; }

    const dynamics::SpanningTree& tree() const { return tree_; }

    /// Back to the drawn pose, which becomes the one placed last.
    dynamics::TreeState reset();

    /// Takes up a pose and closes its loops, which changes dependent coordinates of `state`. False
    /// when some loop stays open.
    bool place(dynamics::TreeState& state);

    /// X_WB, at the pose placed last.
    const std::vector<Pose>& poses() const { return motion_.poses(); }

    /// How many motions the joints leave, those of the whole rover included.
    int motions() const { return loops_.independentCount(); }

    /// Change of the tree's coordinates by `amount` of one of the motions, at the pose placed last.
    std::vector<double> change(int motion, double amount) const;

    /// Moves a state on by an amount of each motion, as they are at the pose placed last.
    void move(dynamics::TreeState& state, const Eigen::VectorXd& amounts) const;

    /// Work of a force at a place (world) of a body per unit of each motion.
    Eigen::RowVectorXd workOf(int body, const Vec3& force, const Vec3& point) const;
    Eigen::RowVectorXd workOfMoment(int body, const Vec3& moment) const;
    /// Of a moment about a joint's axis (a pin's) on its second body, and its reaction on the
    /// first.
    Eigen::RowVectorXd workAboutJoint(const mechanism::Joint& joint) const;

    /// Work of weight and springs per unit of each motion.
    /// @param gravity  [m/s^2], along -z
    Eigen::VectorXd loads(double gravity) const;

    /// Of weight and springs at the pose placed last, 0 at the world's origin and where springs are
    /// as drawn [J].
    double potential(double gravity) const;

    /// Counts how often the motions were chosen anew: numbers by motions of an older choice mean
    /// something else.
    int choice() const { return loops_.choice(); }

    /// Of a place (world) of a body, by amounts of each motion.
    Vec3 velocityOf(int body, const Vec3& point, const Eigen::VectorXd& amounts) const;

    /// Inertia of the motions, a metric that makes turns and slides comparable [kg m^2, kg].
    Eigen::MatrixXd inertia();

    /// Of the pose placed last.
    /// @param gravity  [m/s^2], along -z
    Equilibrium equilibrium(std::span<const Contact> contacts, ContactSet set, double gravity,
                            std::span<const JointStop> stops = {});

    /// Wheel rates against their carriers per unit of forward speed of the chassis origin [rad/m],
    /// when no contact slips and the chassis moves along its forward axis, seen from above, without
    /// turning. Least squares where contacts ask for more than the joints allow. A wheel without
    /// contact: 1/R.
    /// @param speed  of the chassis origin along its forward axis [m/s]
    /// @param turn   of the chassis about the vertical [rad/s]
    Eigen::VectorXd rollingRates(std::span<const Contact> contacts, double speed, double turn);

    /// By how much contacts have to slip when the chassis moves forward without turning, per way of
    /// it: root mean square of the least slips [-].
    double rollingConflict(std::span<const Contact> contacts);

  private:
    /// What is asked of the motions for rolling: of the chassis (three rows), then that contacts
    /// neither slip forwards nor leave the ground.
    Eigen::MatrixXd rollingRows(std::span<const Contact> contacts) const;
    void renewMotions();
    Eigen::RowVectorXd torqueWork(const mechanism::Wheel& wheel) const;

    const mechanism::Mechanism mechanism_;
    dynamics::SpanningTree tree_;
    dynamics::TreeMotion motion_;
    dynamics::LoopClosures loops_;
    dynamics::ReducedInertia inertia_;
    std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> twists_;  ///< of the tree's bodies
    mutable std::vector<dynamics::Vec6> wrenches_;                  ///< on them, a workspace
};

}  // namespace simcore::statics
