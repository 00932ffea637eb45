#pragma once

#include "tests/bench/peers/peer.h"

namespace peers {

/// One run on one engine. Lengths in m, times in s.
struct MeasuredRun {
    long steps = 0;
    double simTime = 0.0;
    double wallTime = 0.0;     ///< of the steps alone, by the clock
    double cpuTime = 0.0;      ///< of this thread in the steps, without what others took from it
    double penetration = 0.0;  ///< deepest, after settling
    double loopError = 0.0;    ///< widest gap of a joint, after settling
    double slipAbs = 0.0;      ///< summed over the wheels, after settling and ramp
    double distance = 0.0;     ///< of the chassis along x
    bool completed = false;
};

/// Our own run, as `roversim run` makes it: contact search, sensors, controller, drives, engine,
/// measures and state hash are all timed.
MeasuredRun runOurs(const simcore::run::ResolvedRun& run, simcore::project::EngineKind engine);

/// The same drive on a peer: held while settling, then the run's speed by its ramp, equal for all
/// wheels; ends at the run's distance or time. Only the peer's steps are timed. Slip is measured by
/// our own observer, from the peer's poses and contact forces; the loop error by our own
/// definition.
MeasuredRun runPeer(Peer& peer, const simcore::run::ResolvedRun& run);

}  // namespace peers
