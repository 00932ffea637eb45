#pragma once

#include <functional>
#include <memory>

#include "simcore/run/run_worker.h"

/// A run without an engine, for tests of what surrounds the simulation.
namespace test_support {

/// Six wheels named as SOLERO's, one chassis body, `duration` [s] at 2 ms a step.
simcore::run::ResolvedRun fakeRun(double duration = 2.0);

/// Drives forward at 0.1 m/s over an invented bump at x = 1 m; all wheel values follow from the
/// time, the seed and a chaotic map, so that any change in the order of steps changes the hash.
/// `beforeStep` is called on the worker's thread with the number of the coming step; it may throw.
simcore::run::StepperFactory fakeStepper(std::function<void(long)> beforeStep = {});

}  // namespace test_support
