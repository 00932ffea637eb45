#include "simcore/sensors/sensor_line.h"

#include <cmath>

namespace simcore::sensors {

SensorLine::SensorLine(const project::SensorErrorValues& error, std::uint64_t seed)
    : error_(error),
      seed_(seed),
      random_(seed) {}

void SensorLine::reset() {
    random_ = Random(seed_);
    history_.clear();
}

double SensorLine::delayed(double time, double truth) {
    if (error_.delay <= 0.0) {
        return truth;
    }
    const double wanted = time - error_.delay;
    history_.push_back({time, truth});
    while (history_.size() > 2 && history_[1].time <= wanted) {
        history_.pop_front();
    }
    const Sample& before = history_.front();
    if (history_.size() == 1 || before.time >= wanted) {
        return before.truth;
    }
    const Sample& after = history_[1];
    const double share = std::min(1.0, (wanted - before.time) / (after.time - before.time));
    return before.truth + share * (after.truth - before.truth);
}

double SensorLine::read(double time, double truth) {
    double reading = delayed(time, truth);
    if (error_.bias != 0.0) {
        reading += error_.bias;
    }
    if (error_.noise > 0.0) {
        reading += error_.noise * random_.normal();
    }
    if (error_.resolution > 0.0) {
        reading = error_.resolution * std::round(reading / error_.resolution);
    }
    return reading;
}

}  // namespace simcore::sensors
