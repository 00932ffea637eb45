// The numbers of a scenario and the ranges they must lie in.
#include <fmt/format.h>

#include "simcore/project/resolve.h"

namespace simcore::project {

Result<ScenarioValues> evaluateScenario(const Scenario& scenario,
                                        const ParameterValues& parameters) {
    Problems problems;
    const auto number = [&](const Quantity& quantity, const char* what, const char* dimension,
                            double low, double high) {
        const std::string element = "scenario " + scenario.name + ", " + what;
        const auto value = evaluate(quantity, parameters, element, dimension);
        appendNew(problems, value.problems());
        if (value && !(*value >= low && *value <= high)) {
            problems.push_back(
                {Severity::Critical, element,
                 fmt::format("{:.6g} is not between {:.6g} and {:.6g}.", *value, low, high),
                 "Correct it; values are in SI unless a unit is written."});
        }
        return value ? *value : low;
    };
    const Soil& soil = scenario.soil;
    const Controller& controller = scenario.controller;
    const RunSettings& run = scenario.run;
    ScenarioValues v;
    v.friction = number(soil.friction, "friction", "ratio", 0.0, 5.0);
    v.rollingResistance = number(soil.rollingResistance, "rolling resistance", "ratio", 0.0, 1.0);
    v.speed = number(controller.speed, "speed", "speed", -10.0, 10.0);
    v.assumedFriction = number(controller.assumedFriction, "assumed friction", "ratio", 0.0, 5.0);
    v.controlPeriod = number(controller.period, "controller period", "time", 1e-4, 1.0);
    v.proportional = number(controller.proportional, "proportional gain", "", 0.0, 1e6);
    v.integral = number(controller.integral, "integral gain", "", 0.0, 1e6);
    v.derivative = number(controller.derivative, "derivative gain", "", 0.0, 1e6);
    v.step = number(run.step, "step", "time", 1e-5, 0.02);
    v.distance = number(run.distance, "distance", "length", 0.01, 1000.0);
    v.duration = number(run.duration, "duration", "time", 0.0, 1e5);
    v.settle = number(run.settle, "settling time", "time", 0.0, 60.0);
    v.ramp = number(run.ramp, "ramp time", "time", 0.0, 60.0);
    const auto errors = [&](const SensorError& error, const std::string& sensor,
                            const char* dimension) {
        // Wide enough for any sensor; a delay of seconds would be a mistake.
        constexpr double kMost = 1e6;
        const auto name = [&](const char* what) { return sensor + " " + what; };
        SensorErrorValues e;
        e.noise = number(error.noise, name("noise").c_str(), dimension, 0.0, kMost);
        e.bias = number(error.bias, name("bias").c_str(), dimension, -kMost, kMost);
        e.delay = number(error.delay, name("delay").c_str(), "time", 0.0, 2.0);
        e.resolution = number(error.resolution, name("resolution").c_str(), dimension, 0.0, kMost);
        return e;
    };
    const Sensors& sensors = scenario.sensors;
    v.sensors.jointEncoder = errors(sensors.jointEncoder, "joint encoder", "angle");
    v.sensors.wheelRate = errors(sensors.wheelRate, "wheel rate", "angular speed");
    v.sensors.orientation = errors(sensors.orientation, "orientation", "angle");
    v.sensors.angularRate = errors(sensors.angularRate, "angular rate", "angular speed");
    v.sensors.acceleration = errors(sensors.acceleration, "acceleration", "acceleration");
    v.sensors.tactileForce = errors(sensors.tactileForce, "tactile force", "force");
    v.sensors.tactileAngle = errors(sensors.tactileAngle, "tactile angle", "angle");
    v.sensors.bodySpeed = errors(sensors.bodySpeed, "body speed", "speed");
    for (std::size_t i = 0; i < soil.regions.size(); ++i) {
        const SoilRegion& region = soil.regions[i];
        const std::string name = fmt::format("region {}, ", i + 1);
        const auto value = [&](const Quantity& quantity, const char* what, const char* dimension,
                               double low, double high) {
            return number(quantity, (name + what).c_str(), dimension, low, high);
        };
        constexpr double kFar = 1e4;
        GroundRegion ground;
        ground.xMin = value(region.x[0], "x from", "length", -kFar, kFar);
        ground.xMax = value(region.x[1], "x to", "length", ground.xMin, kFar);
        ground.yMin = value(region.y[0], "y from", "length", -kFar, kFar);
        ground.yMax = value(region.y[1], "y to", "length", ground.yMin, kFar);
        ground.friction = value(region.friction, "friction", "ratio", 0.0, 5.0);
        ground.rollingResistance =
            value(region.rollingResistance, "rolling resistance", "ratio", 0.0, 1.0);
        v.regions.push_back(ground);
    }
    if (hasCritical(problems)) {
        return problems;
    }
    return Result<ScenarioValues>(v, std::move(problems));
}

GroundValues groundAt(const ScenarioValues& values, double x, double y) {
    for (auto region = values.regions.rbegin(); region != values.regions.rend(); ++region) {
        if (x >= region->xMin && x <= region->xMax && y >= region->yMin && y <= region->yMax) {
            return *region;
        }
    }
    return {values.friction, values.rollingResistance};
}

}  // namespace simcore::project
