#pragma once

#include <vector>

#include <Eigen/Core>

#include "simcore/mobility/constraint_jacobian.h"
#include "simcore/mobility/stance.h"

namespace simcore::mobility {

/// The constraints of a mechanism as rows, at the level of velocities and of positions.
///
/// What a joint holds: its slides are held along directions of the first body, at the point of the
/// second; its turns as in a real joint of so many turns. With one free turn the axis stays
/// parallel in both bodies; with two it is a universal joint, whose first axis lies in the first
/// body and second in the second body, at an unchanging angle.
class ConstraintSystem {
  public:
    /// `start`: the stance that the residual of contacts counts from; it also says which wheels
    /// touch. Throws std::invalid_argument when it does not fit the mechanism.
    ConstraintSystem(const mechanism::Mechanism& mechanism, Model model, Stance start);

    const Stance& start() const { return start_; }

    double length() const { return length_; }

    int columns() const { return columns_; }

    const std::vector<int>& firstColumn() const { return firstColumn_; }

    /// Rows and columns as ConstraintJacobian has them, at any stance.
    Eigen::MatrixXd matrix(const Stance& stance) const;

    /// Names with directions at the start stance.
    ConstraintJacobian jacobian() const;

    /// By how much each row is violated; its derivative along a motion is the matrix times that
    /// motion, exactly where the constraints hold. Lengths over length(), angles in rad.
    ///
    /// A joint's rows and a contact's distance from the ground follow from the pose. A contact's
    /// rolling and lateral rows are constraints on velocities only: here they are the slip between
    /// start and `stance`, by the midpoint rule: way of the wheel's centre plus the wheel's turn
    /// times the mean arm.
    Eigen::VectorXd residual(const Stance& stance) const;

    /// The stance after `motion`, a small displacement in the units of the columns.
    Stance moved(const Stance& stance, const Eigen::VectorXd& motion) const;

  private:
    enum class Kind { JointSlide, JointTurn, ContactNormal, ContactRolling, ContactLateral, Gear };

    struct Row {
        Kind kind;
        int index;       ///< of the joint, wheel or gear
        Vec3 direction;  ///< held direction in the first body (joints)
        Vec3 first;      ///< JointTurn: free axis in the first body, if there are one or two
        Vec3 second;     ///< JointTurn: free axis in the second body, if there are one or two
        int freeTurns;   ///< JointTurn
    };

    void addJoint(int index, Model model);
    void addContact(int index, Model model);
    /// Adds direction . (velocity of the second body - velocity of the first) at a point.
    void putSlide(Eigen::MatrixXd& matrix, Eigen::Index row, int first, int second,
                  const Vec3& point, const Vec3& direction) const;
    void putTurn(Eigen::MatrixXd& matrix, Eigen::Index row, int first, int second,
                 const Vec3& direction) const;
    Vec3 heldTurn(const Row& row, const Stance& stance) const;
    Vec3 contactDirection(const Row& row, const Stance& stance) const;
    double turnResidual(const Row& row, const Stance& stance) const;
    double contactResidual(const Row& row, const Stance& stance) const;
    const Pose& pose(const Stance& stance, int body) const;

    const mechanism::Mechanism& mechanism_;
    Stance start_;
    double length_;
    Vec3 reference_;  ///< point whose velocity stands in the columns: the chassis' origin
    int columns_ = 0;
    std::vector<int> firstColumn_;
    std::vector<Row> rows_;
};

}  // namespace simcore::mobility
