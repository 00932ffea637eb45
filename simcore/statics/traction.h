#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "simcore/mechanism/mechanism.h"
#include "simcore/statics/quasi_convex.h"
#include "simcore/statics/static_model.h"

namespace simcore::statics {

/// Forces of an equilibrium: one solution of M U = R.
struct Forces {
    std::vector<double> normal, traction, lateral;  ///< of every contact [N]
    std::vector<double> torque;                     ///< of every wheel, 0 where it hangs [N m]
    std::vector<double> stop;  ///< moments off their stops of the joints at them, >= 0 [N m]

    /// Tangential over normal force of a contact; infinite where nothing presses and something
    /// pulls.
    double ratio(std::size_t contact) const;
    double maxRatio() const;
    double maxTorque() const;
    double minNormal() const;
};

/// What torques are looked for.
enum class Objective {
    Friction,  ///< the smallest largest ratio of tangential to normal force
    Torque,    ///< the smallest largest torque
    Energy,    ///< the smallest sum of squares of torques, which the motors' losses are like
};

enum class Way {
    None,        ///< no torques hold the rover
    Equal,       ///< all wheels alike
    FixedPoint,  ///< all ratios alike, found by iteration
    Search,      ///< a quasi-convex program, see minimise()
};

struct Solution {
    Way way = Way::None;
    Forces forces;
    /// What is asked of the ground: max ratio of `forces` [-].
    double friction = 0.0;
};

/// All solutions of an equilibrium as U = U0 + K y, with the tools to choose one.
class Traction {
  public:
    /// `contacts` are those that the equilibrium was made with.
    Traction(const Equilibrium& equilibrium, const mechanism::Mechanism& mechanism,
             std::span<const Contact> contacts);

    /// Largest part of R that nothing balances, over the largest of R [-]: above 1e-9 no forces at
    /// these contacts hold the rover.
    double imbalance() const { return imbalance_; }

    /// Dimension of the space of solutions.
    int dimension() const { return static_cast<int>(motions_.cols()); }

    /// The forces with the same torque at every wheel that touches; where the contact set leaves
    /// some open, those that ask the least friction. None when no equal torque holds the rover.
    Solution equalTorque() const;

    /// Torques proportional to load times radius, iterated with the loads they make (Lamon et al.
    /// 2004, section 3.2): all ratios alike, where it converges with all wheels pressed and within
    /// their limits.
    Solution fixedPoint() const;

    /// The best torques, to `tolerance` of the objective: equal torques first, then the fixed point
    /// for Objective::Friction, then a search (see QuasiConvexProgram), under N >= 0,
    /// |torque| <= limit and stops that push. None when there are no such torques.
    Solution best(Objective objective, double tolerance = 1e-8) const;

    /// The forces at the contacts when the wheels have these torques, one a wheel; least in norm
    /// where the contact set leaves some open, nearest to balance where these torques do not hold
    /// the rover.
    Forces under(const std::vector<double>& torques) const;

    /// Largest part of M U - R over the largest of R [-].
    double residual(const Forces& forces) const;

    /// Forces moved along one axis of the space of solutions [N].
    Forces moved(const Forces& forces, int axis, double step) const;

  private:
    void solveForTorques();
    bool withShares(const Scratch::Vector& shares, Scratch::Vector& unknowns) const;
    Eigen::VectorXd unknownsOf(const Forces& forces) const;
    Forces forcesOf(const Eigen::Ref<const Eigen::VectorXd>& unknowns) const;
    bool allowed(const Forces& forces) const;
    double heaviest() const;
    QuasiConvexProgram programOf(Scratch& room, const Eigen::VectorXd& some,
                                 const Eigen::MatrixXd& motions, Objective objective) const;
    Solution search(const Eigen::VectorXd& some, const Eigen::MatrixXd& motions, Scratch::Vector y,
                    Objective objective, double tolerance) const;

    const Equilibrium equilibrium_;
    std::vector<int> wheelOf_;          ///< of every contact
    std::vector<int> torques_;          ///< columns of the wheels that touch
    std::vector<double> torqueLimits_;  ///< of every wheel [N m]
    std::vector<double> radii_;         ///< of every wheel [m]
    double load_ = 1.0;                 ///< mean of a contact, a scale [N]
    double imbalance_ = 0.0;
    double scale_ = 1.0;  ///< largest of R
    // Forces at the contacts = withoutTorque + perTorque * torques, where conditions * torques =
    // wanted.
    Eigen::VectorXd withoutTorque_;
    Eigen::MatrixXd perTorque_;
    Eigen::MatrixXd conditions_;
    Eigen::VectorXd wanted_;
    Eigen::VectorXd some_;     ///< U0
    Eigen::MatrixXd motions_;  ///< K, orthonormal columns
};

}  // namespace simcore::statics
