#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/mechanism/mechanism.h"
#include "simcore/project/project.h"

namespace simcore::project {

/// Parameter values after overrides, by name [SI].
using ParameterValues = std::map<std::string, double>;

/// An override as typed: NAME and VALUE, the value being a number, an expression or "12 cm".
struct Assignment {
    std::string parameter;
    std::string value;
    bool operator==(const Assignment&) const = default;
};

/// A number when the text is one, else an expression.
Quantity quantityFrom(const std::string& text);

/// Values of all parameters: the file's, then the variant's, then `assignments`.
///
/// Problems: unknown name, circular or malformed expression, a value outside the parameter's
/// range, an assignment to a derived parameter.
Result<ParameterValues> evaluateParameters(const Rover& rover,
                                           const std::vector<Override>& variant = {},
                                           const std::vector<Assignment>& assignments = {});

/// The same with the named variant of the project ("" = none).
Result<ParameterValues> evaluateParameters(const Project& project, const std::string& variant,
                                           const std::vector<Assignment>& assignments = {});

/// The value of one quantity [SI], a finite number; problems name `element`. A unit written in the
/// text must be of the `dimension` when one is given ("length", ...).
Result<double> evaluate(const Quantity& quantity, const ParameterValues& parameters,
                        const std::string& element, std::string_view dimension = {});

/// What becomes of the joints that wheels name as their steering: welded, as analyses and
/// controllers that do not steer want them, or free to be turned by their servos. A *locked*
/// joint is welded either way, and its wheel is not steered.
enum class Steering { Locked, Free };

/// The mechanism of a rover with the given parameter values. *All* problems found are returned, not
/// only the first; a mechanism comes with warnings only.
Result<mechanism::Mechanism> resolve(const Rover& rover, const ParameterValues& parameters,
                                     Steering steering = Steering::Locked);

/// evaluateParameters() and resolve() in one, with the named variant ("" = none).
Result<mechanism::Mechanism> resolve(const Project& project, const std::string& variant = {},
                                     const std::vector<Assignment>& assignments = {},
                                     Steering steering = Steering::Locked);

/// A SensorError with numbers [SI].
struct SensorErrorValues {
    double noise = 0.0, bias = 0.0, delay = 0.0, resolution = 0.0;
};

struct SensorValues {
    SensorErrorValues jointEncoder, wheelRate, orientation, angularRate, acceleration, tactileForce,
        tactileAngle, bodySpeed;
};

/// What the ground is to a wheel.
struct GroundValues {
    double friction = 0.7;           ///< [-]
    double rollingResistance = 0.0;  ///< [-]
};

/// A rectangle of ground [m], world.
struct GroundRegion : GroundValues {
    double xMin = 0.0, xMax = 0.0, yMin = 0.0, yMax = 0.0;
};

/// The numbers of a scenario [SI].
struct ScenarioValues {
    double speed = 0.1, turn = 0.0, assumedFriction = 0.5, controlPeriod = 0.01;
    double proportional = 0.0, integral = 0.0, derivative = 0.0;  ///< 0 = derived
    double friction = 0.7, rollingResistance = 0.0;
    std::vector<GroundRegion> regions;
    double step = 0.002, distance = 3.5, duration = 0.0, settle = 0.5, ramp = 0.5;
    SensorValues sensors;
};

/// Friction and rolling resistance at a point of the ground: those of the last region that holds
/// it, borders included, else the scenario's.
GroundValues groundAt(const ScenarioValues& values, double x, double y);

/// Values a scenario's numbers and checks them against ranges that can be run, wide enough to catch
/// typing errors only. All problems; terrain is checked where it is made.
Result<ScenarioValues> evaluateScenario(const Scenario& scenario,
                                        const ParameterValues& parameters);

/// Everything wrong with a project: names, references, expressions, ranges, masses, inertias,
/// joints, wheels, scenarios. Sorted by severity, then in file order.
Problems validate(const Project& project);

}  // namespace simcore::project
