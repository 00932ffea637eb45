#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "simcore/dynamics/reduced_inertia.h"

namespace simcore::dynamics {

/// P of the pose that rates were solved at: with it they agree to the last digit, at the pose that
/// they lead to no longer.
struct SolvedTerms {
    std::vector<RateTerm> terms;
    int choice = -1;  ///< of dependent rates that the terms are of; -1 = none
};

/// What the projection of momenta onto the new motion of loops takes from energy, and gives it back
/// (docs/decisions/0018).
///
/// Rates q' = P u of the last pose, projected by P'^T H onto the motion P' u' of this one, lose the
/// energy of their part across it, as if the loops turned in little impacts. To third order in the
/// step that part is given back by projecting with the mean of P and P' instead, that is by adding
/// (P' - P)^T H d / 2 with d the part of (P' - P) u across the new motion.
class LoopEnergy {
  public:
    LoopEnergy(const LoopClosures& loops, ReducedInertia& inertia);

    void reset();

    /// To be called whenever loops were closed at a pose, with the rates that are right at the one
    /// before: by how much the motion of loops has turned.
    double arrive(std::span<const double> rates);

    /// Adds to the projected momentum what projection would cost, when that matters in a step.
    /// @param mass  P'^T H P'
    void giveBack(const SolvedTerms& solved, double step, const RowMajor& mass,
                  const PatternedLu& lu, Eigen::VectorXd& momentum);

    /// Next to a singular pose: adds up what projection changes of the kinetic energy all the same.
    /// False when it is more than may get lost in one passage.
    bool passSingular(std::span<const double> rates, const SolvedTerms& solved, double step,
                      const PatternedLu& lu);

    void leaveSingular() { passing_ = false; }

  private:
    const LoopClosures& loops_;
    ReducedInertia& inertia_;
    std::vector<double> change_;  ///< (P' - P) u, and by how much loops have turned in it
    double turn_ = 0.0;
    double lost_ = 0.0;     ///< in the passage of a singular pose [J]
    double entered_ = 0.0;  ///< kinetic energy where it began [J]
    bool passing_ = false;
    // room that stays
    std::vector<double> across_;
    Eigen::VectorXd along_;
    Eigen::VectorXd momentum_;
    Eigen::VectorXd rates_;
    RowMajor factored_;
    RowMajor mass_;
};

}  // namespace simcore::dynamics
