#pragma once

#include <cstdint>
#include <deque>

#include "simcore/base/random.h"
#include "simcore/project/resolve.h"

namespace simcore::sensors {

/// One number on its way from the world to the controller: late, off, noisy and in steps.
///
///     reading(t) = rounded(truth(t - delay) + bias + noise(t))
///
/// Between two looks the truth is taken to change evenly, so that a delay need not be a whole
/// number of control periods; before the first look it is taken to have been the same for ever. An
/// ideal error hands on the truth bit for bit.
class SensorLine {
  public:
    SensorLine(const project::SensorErrorValues& error, std::uint64_t seed);

    /// Back to the start: the same truths give the same readings again.
    void reset();
    /// The reading at `time`, which may not go back [s].
    double read(double time, double truth);

  private:
    struct Sample {
        double time;
        double truth;
    };

    double delayed(double time, double truth);

    project::SensorErrorValues error_;
    std::uint64_t seed_;
    Random random_;
    std::deque<Sample> history_;  ///< the first is at least `delay` old, once there is one
};

}  // namespace simcore::sensors
