#pragma once

#include "simcore/control/sensors.h"
#include "simcore/dynamics/engine.h"
#include "simcore/run/snapshot.h"
#include "simcore/sensors/sensor_line.h"

/// The sensors of a rover: the only way from the engine's state to a controller. docs/sensors.md.
namespace simcore::sensors {

/// Readings before the first look: all of the right number, none there (NaN).
control::Sensors noReadings(const mechanism::Mechanism& mechanism);

/// Every sensor of a rover with its errors. Each has a random stream of its own, which depends on
/// the seed and on what the sensor is on: another sensor more does not change it.
class SensorSuite {
  public:
    SensorSuite(const mechanism::Mechanism& mechanism, const project::SensorValues& errors,
                int seed);

    void reset();
    /// What the sensors say now; to be called at every look, `now` being the present instant of
    /// that engine.
    void read(const dynamics::Engine& engine, const run::Snapshot& now, control::Sensors& readings);

  private:
    void look(const dynamics::Engine& engine, const run::Snapshot& now, control::Sensors& truth);
    SensorLine line(const project::SensorErrorValues& error, const std::string& name) const;

    struct WheelLines {
        SensorLine rate, normalForce, contactAngle;
    };

    const mechanism::Mechanism& mechanism_;
    int seed_;
    SensorLine bodySpeed_, roll_, pitch_;
    std::vector<SensorLine> angularRate_, acceleration_;  ///< x, y, z
    std::vector<SensorLine> joints_;
    std::vector<WheelLines> wheels_;
    Vec3 lastVelocity_ = Vec3::Zero();  ///< of the chassis' centre of mass, world [m/s]
    double lastLook_ = 0.0;             ///< [s]
};

}  // namespace simcore::sensors
