#include "simcore/dynamics/loop_energy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace simcore::dynamics {
namespace {

/// From this turn of a loop's motion in time on, what projection costs is given back [1/s]. Slower
/// ones lose less than the square of it times the step of their energy in a second.
constexpr double kTurnThatCosts = 0.5;
/// Share of the kinetic energy that a passage of a singular pose may cost.
constexpr double kEnergyTolerance = 0.01;

}  // namespace

LoopEnergy::LoopEnergy(const LoopClosures& loops, ReducedInertia& inertia)
    : loops_(loops),
      inertia_(inertia) {}

void LoopEnergy::reset() {
    passing_ = false;
}

double LoopEnergy::arrive(std::span<const double> rates) {
    turn_ = loops_.turnOf(rates, change_);
    return turn_;
}

void LoopEnergy::giveBack(const SolvedTerms& solved, double step, const RowMajor& mass,
                          const PatternedLu& lu, Eigen::VectorXd& momentum) {
    if (solved.choice != loops_.choice() || turn_ < kTurnThatCosts * step) {
        return;
    }
    inertia_.project(inertia_.times(change_), 1.0, along_);
    factored_ = mass;
    lu.factor(factored_);
    lu.solve(factored_, along_);
    across_ = change_;
    for (std::size_t j = 0; j < across_.size(); ++j) {
        for (const RateTerm& term : loops_.terms(static_cast<int>(j))) {
            across_[j] -= term.factor * along_[term.index];
        }
    }
    const std::vector<double>& forces = inertia_.times(across_);
    for (std::size_t j = 0; j < forces.size(); ++j) {
        const std::size_t first = loops_.firstTerm(static_cast<int>(j));
        const std::span<const RateTerm> terms = loops_.terms(static_cast<int>(j));
        for (std::size_t k = 0; k < terms.size(); ++k) {
            momentum[terms[k].index] +=
                0.5 * (terms[k].factor - solved.terms[first + k].factor) * forces[j];
        }
    }
}

bool LoopEnergy::passSingular(std::span<const double> rates, const SolvedTerms& solved, double step,
                              const PatternedLu& lu) {
    const std::vector<double>& forces = inertia_.times(rates);
    const double before =
        0.5 * std::inner_product(forces.begin(), forces.end(), rates.begin(), 0.0);
    inertia_.project(forces, 1.0, momentum_);
    lu.shape(mass_);
    inertia_.assemble(mass_);
    giveBack(solved, step, mass_, lu, momentum_);
    rates_ = momentum_;
    lu.factor(mass_);
    lu.solve(mass_, rates_);
    const double after = 0.5 * rates_.dot(momentum_);
    if (!passing_) {
        passing_ = true;
        lost_ = 0.0;
        entered_ = before;
    }
    lost_ += before - after;
    return std::abs(lost_) <= kEnergyTolerance * std::max(entered_, before);
}

}  // namespace simcore::dynamics
