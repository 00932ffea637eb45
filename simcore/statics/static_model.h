#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "simcore/dynamics/loop_closures.h"
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

/// M U = R: balance of all internal motions of a mechanism (paper eq. 2, 3).
///
/// U holds the normal forces of all contacts, their tractions (forward), the lateral forces that
/// the contact set has, and the torques of all wheels that touch. Forces act on the wheels; a
/// positive torque drives forward.
struct Equilibrium {
    Eigen::MatrixXd matrix;             ///< M: one row an independent motion
    Eigen::VectorXd right;              ///< R: weight and springs [N m] or [N]
    std::vector<int> normal, traction;  ///< columns, one a contact
    std::vector<int> lateral;           ///< columns, one a contact; -1 = no such unknown
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

    dynamics::TreeState drawnState() const { return tree_.drawnState(); }

    /// Takes up a pose and closes its loops, which changes dependent coordinates of `state`. False
    /// when some loop stays open.
    bool place(dynamics::TreeState& state);

    /// X_WB, at the pose placed last.
    const std::vector<Pose>& poses() const { return motion_.poses(); }

    /// How many motions the joints leave, those of the whole rover included.
    int motions() const { return loops_.independentCount(); }

    /// Change of the tree's coordinates by `amount` of one of the motions, at the pose placed last.
    std::vector<double> change(int motion, double amount) const;

    /// Of the pose placed last.
    /// @param gravity  [m/s^2], along -z
    Equilibrium equilibrium(std::span<const Contact> contacts, ContactSet set, double gravity);

    /// Wheel rates against their carriers per unit of forward speed of the chassis origin [rad/m],
    /// when no contact slips and the chassis moves along its forward axis, seen from above, without
    /// turning. Least squares where contacts ask for more than the joints allow. A wheel without
    /// contact: 1/R.
    /// @param speed  of the chassis origin along its forward axis [m/s]
    /// @param turn   of the chassis about the vertical [rad/s]
    Eigen::VectorXd rollingRates(std::span<const Contact> contacts, double speed, double turn);

  private:
    void renewMotions();
    /// Work of a force at a place of a body per unit of each independent motion.
    Eigen::RowVectorXd workOf(int body, const Vec3& force, const Vec3& point) const;
    Eigen::RowVectorXd workOfMoment(int body, const Vec3& moment) const;
    Eigen::VectorXd loads(double gravity) const;
    Eigen::RowVectorXd torqueWork(const mechanism::Wheel& wheel) const;

    const mechanism::Mechanism mechanism_;
    dynamics::SpanningTree tree_;
    dynamics::TreeMotion motion_;
    dynamics::LoopClosures loops_;
    std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> twists_;  ///< of the tree's bodies
};

}  // namespace simcore::statics
