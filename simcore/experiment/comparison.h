#pragma once

#include <string>
#include <vector>

#include "simcore/experiment/experiment.h"

namespace simcore::experiment {

/// Which grounds are compared: above the friction that statics requires, no controller can pass for
/// sure.
enum class Grounds {
    All,
    Passable,  ///< required friction at most kPassable of the ground's
    Beyond,    ///< all others
};

inline constexpr double kPassable = 0.9;

/// "all" | "passable" | "beyond".
std::string toString(Grounds grounds);

/// One controller against another at one coefficient of friction.
struct Comparison {
    double friction = 0.0;
    Grounds grounds = Grounds::All;
    project::ControllerKind controller = project::ControllerKind::Speed;
    project::ControllerKind rival = project::ControllerKind::Speed;
    int tried = 0;      ///< grounds that both were sent over
    int pairs = 0;      ///< that both completed
    int onlyOwn = 0;    ///< that the controller completed and the rival did not
    int onlyRival = 0;  ///< the other way round
    /// Pairs that count: on full terrains those whose ends are less than kSameEnd apart.
    int valid = 0;

    /// Of one measure over the valid pairs.
    struct Measure {
        int wins = 0;  ///< pairs in which the controller has less, by more than the resolution
        int ties = 0;  ///< pairs that differ by less
        /// Geometric mean of rival over controller: above 1 the controller has less [-]; 0 = none.
        /// What is less than the resolution counts as that much.
        double meanRatio = 0.0;
        /// 95 % confidence interval of the mean ratio; 0 with fewer than two pairs.
        double low = 0.0, high = 0.0;
    };

    Measure slip;        ///< Outcome::slipAbs
    Measure loadedSlip;  ///< Outcome::slipLoaded
    Measure energy;      ///< Outcome::energy
    Measure work;        ///< Outcome::frictionWork
};

/// Slip that makes no difference: 1 mm of all wheels on the whole way. Where nothing slips, what is
/// measured is the sampling of the way, some tenths of a millimetre [m].
inline constexpr double kSlipResolution = 1e-3;

/// Energy and work that make no difference [J].
inline constexpr double kEnergyResolution = 1e-6;

/// On full terrain two rovers that end further apart did not drive the same way [m] (paper).
inline constexpr double kSameEnd = 0.1;

/// Every controller of the plan against every other one, at each friction, on all grounds, then on
/// the passable ones, then on the others. The interval is the
/// percentile bootstrap of the mean logarithm (B. Efron, R. Tibshirani, An Introduction to the
/// Bootstrap, 1993, chapter 13), 2000 samples drawn by a fixed seed.
std::vector<Comparison> compare(const Plan& plan, const std::vector<Outcome>& outcomes);

}  // namespace simcore::experiment
