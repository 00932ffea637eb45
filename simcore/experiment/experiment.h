#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/experiment/terrain_sets.h"
#include "simcore/project/project.h"
#include "simcore/run/simulation.h"

namespace simcore::experiment {

/// What is tried on every ground of a set.
struct Plan {
    TerrainSet set = TerrainSet::Profiles;
    int firstSeed = 1;
    int lastSeed = 1;  ///< that, too
    std::vector<double> frictions;
    std::vector<project::ControllerKind> controllers;  ///< the first is held against the others
    project::EngineKind engine = project::EngineKind::Reduced;
    double step = 0.002;              ///< [s]
    double speed = 0.1;               ///< [m/s], paper
    double distance = 3.5;            ///< of the chassis' origin, that ends a run [m], paper
    double rollingResistance = 0.02;  ///< [-] (assumed: compact ground)
    double assumedFriction = 0.5;     ///< of the controllers' traction cap [-]; 0 = no cap
    double controlPeriod = 0.01;      ///< [s]
    double noise = 0.0;               ///< multiples of sensorsWithNoise()
    bool operator==(const Plan&) const = default;
};

/// One run of a plan.
struct Case {
    int seed = 1;
    double friction = 0.7;
    project::ControllerKind controller = project::ControllerKind::Speed;
    bool operator==(const Case&) const = default;
};

/// What it came to.
struct Outcome {
    Case ran;
    bool completed = false;
    double staticFriction = 0.0;  ///< GroundStatics::frictionRequired() of its ground [-]
    std::string stopReason;       ///< run::toString(), or why there was no run
    double slipAbs = 0.0, slipLoaded = 0.0, slipSigned = 0.0;  ///< sums of all wheels [m]
    double frictionWork = 0.0;                                 ///< at the contacts [J]
    double energy = 0.0;                                       ///< of the drives [J]
    double peakTorque = 0.0;                                   ///< largest of any wheel [N m]
    double time = 0.0;                                         ///< simulated [s]
    double endX = 0.0, endY = 0.0;                             ///< chassis origin, world [m]
    std::string stateHash;
};

/// All runs of a plan, ground by ground. Problems: no seeds, frictions or controllers, or ones that
/// cannot be driven.
Result<std::vector<Case>> casesOf(const Plan& plan);

/// The rover of `project` with the one scenario of a case.
Result<project::Project> projectOf(const project::Project& project, const Plan& plan,
                                   const Case& what);

/// Drives it, to its end. A case that cannot be prepared is an outcome, too, that did not complete.
Outcome drive(const project::Project& project, const Plan& plan, const Case& what);

/// Noise of cheap sensors, times a factor (assumed: encoders 0.1 deg, wheel rates 0.02 rad/s,
/// inclination 0.3 deg, rates 0.01 rad/s, acceleration 0.05 m/s^2, tactile force 0.5 N and angle
/// 2 deg, body speed 5 mm/s).
project::Sensors sensorsWithNoise(double factor);

/// What a run came to that stands at `end`; its case and the ground's friction are left open.
Outcome outcomeOf(const run::RunReport& report, const run::Snapshot& end,
                  const mechanism::Mechanism& mechanism);

/// Outcome of a case that has no run of its own to tell.
Outcome notRun(const Case& what, std::string why);

}  // namespace simcore::experiment
