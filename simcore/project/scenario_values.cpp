// The numbers of a scenario and the ranges they must lie in.

#include "simcore/base/text.h"
#include "simcore/project/resolve.h"

namespace simcore::project {

Result<ScenarioValues> evaluateScenario(const Scenario& scenario,
                                        const ParameterValues& parameters) {
    Problems problems;
    // `what` is marked; `of` names the sensor or region that it belongs to.
    const auto number = [&](const Quantity& quantity, const char* what, const char* dimension,
                            double low, double high, const std::string& of = {}) {
        const auto element = [&] {
            return Text::of("scenario {}, {}{}", scenario.name, of, Text::translated(what));
        };
        const auto value = evaluate(quantity, parameters, {}, dimension);
        for (Problem problem : value.problems()) {
            problem.element = element();
            appendNew(problems, {problem});
        }
        if (value && !(*value >= low && *value <= high)) {
            problems.push_back(
                {Severity::Critical, element(),
                 Text::of("{:.6g} is not between {:.6g} and {:.6g}.", *value, low, high),
                 Text::of("Correct it; values are in SI unless a unit is written.")});
        }
        return value ? *value : low;
    };
    const Soil& soil = scenario.soil;
    const Controller& controller = scenario.controller;
    const RunSettings& run = scenario.run;
    ScenarioValues v;
    v.friction = number(soil.friction, Text::mark("friction"), "ratio", 0.0, 5.0);
    v.rollingResistance =
        number(soil.rollingResistance, Text::mark("rolling resistance"), "ratio", 0.0, 1.0);
    v.speed = number(controller.speed, Text::mark("speed"), "speed", -10.0, 10.0);
    v.turn = number(controller.turn, Text::mark("turn"), "angular speed", -10.0, 10.0);
    v.assumedFriction =
        number(controller.assumedFriction, Text::mark("assumed friction"), "ratio", 0.0, 5.0);
    v.controlPeriod = number(controller.period, Text::mark("controller period"), "time", 1e-4, 1.0);
    v.proportional = number(controller.proportional, Text::mark("proportional gain"), "", 0.0, 1e6);
    v.integral = number(controller.integral, Text::mark("integral gain"), "", 0.0, 1e6);
    v.derivative = number(controller.derivative, Text::mark("derivative gain"), "", 0.0, 1e6);
    v.step = number(run.step, Text::mark("step"), "time", 1e-5, 0.02);
    v.distance = number(run.distance, Text::mark("distance"), "length", 0.01, 1000.0);
    v.duration = number(run.duration, Text::mark("duration"), "time", 0.0, 1e5);
    v.settle = number(run.settle, Text::mark("settling time"), "time", 0.0, 60.0);
    v.ramp = number(run.ramp, Text::mark("ramp time"), "time", 0.0, 60.0);
    const auto errors = [&](const SensorError& error, const char* sensor, const char* dimension) {
        // Wide enough for any sensor; a delay of seconds would be a mistake.
        constexpr double kMost = 1e6;
        const std::string of = Text::of("{} ", Text::translated(sensor));
        SensorErrorValues e;
        e.noise = number(error.noise, Text::mark("noise"), dimension, 0.0, kMost, of);
        e.bias = number(error.bias, Text::mark("bias"), dimension, -kMost, kMost, of);
        e.delay = number(error.delay, Text::mark("delay"), "time", 0.0, 2.0, of);
        e.resolution =
            number(error.resolution, Text::mark("resolution"), dimension, 0.0, kMost, of);
        return e;
    };
    const Sensors& sensors = scenario.sensors;
    v.sensors.jointEncoder = errors(sensors.jointEncoder, Text::mark("joint encoder"), "angle");
    v.sensors.wheelRate = errors(sensors.wheelRate, Text::mark("wheel rate"), "angular speed");
    v.sensors.orientation = errors(sensors.orientation, Text::mark("orientation"), "angle");
    v.sensors.angularRate =
        errors(sensors.angularRate, Text::mark("angular rate"), "angular speed");
    v.sensors.acceleration =
        errors(sensors.acceleration, Text::mark("acceleration"), "acceleration");
    v.sensors.tactileForce = errors(sensors.tactileForce, Text::mark("tactile force"), "force");
    v.sensors.tactileAngle = errors(sensors.tactileAngle, Text::mark("tactile angle"), "angle");
    v.sensors.bodySpeed = errors(sensors.bodySpeed, Text::mark("body speed"), "speed");
    for (std::size_t i = 0; i < soil.regions.size(); ++i) {
        const SoilRegion& region = soil.regions[i];
        const std::string name = Text::of("region {}", i + 1) + ", ";
        const auto value = [&](const Quantity& quantity, const char* what, const char* dimension,
                               double low, double high) {
            return number(quantity, what, dimension, low, high, name);
        };
        constexpr double kFar = 1e4;
        GroundRegion ground;
        ground.xMin = value(region.x[0], Text::mark("x from"), "length", -kFar, kFar);
        ground.xMax = value(region.x[1], Text::mark("x to"), "length", ground.xMin, kFar);
        ground.yMin = value(region.y[0], Text::mark("y from"), "length", -kFar, kFar);
        ground.yMax = value(region.y[1], Text::mark("y to"), "length", ground.yMin, kFar);
        ground.friction = value(region.friction, Text::mark("friction"), "ratio", 0.0, 5.0);
        ground.rollingResistance =
            value(region.rollingResistance, Text::mark("rolling resistance"), "ratio", 0.0, 1.0);
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
