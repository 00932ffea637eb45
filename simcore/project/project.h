#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simcore/project/quantity.h"

/// The document: a plain, comparable, copyable value tree. It holds only what the user entered;
/// everything derived (numbers of expressions, mirrored elements, mass, mobility) is computed from
/// it.
///
/// Points are in the rover frame at the drawn pose: x forward, y left, z up, origin on the ground
/// [m]. `mirror` makes a second element with y -> -y; its name is the name with `{side}` replaced
/// by left/right, or with _left/_right appended. References resolve to their own side.
/// docs/project-file.md is the reference for the file format.
namespace simcore::project {

/// A named number of the rover. A parameter whose value is an expression is *derived*: it cannot be
/// set from outside.
struct Parameter {
    std::string name;
    Quantity value;                 ///< SI, or an expression of other parameters
    std::string unit;               ///< display unit only, e.g. "mm"; empty = dimensionless
    std::optional<double> minimum;  ///< allowed range [SI]
    std::optional<double> maximum;  ///< allowed range [SI]
    std::string meaning;            ///< one phrase for the editor's tooltip
    std::string source;             ///< where the number is from, or "assumed"
    bool operator==(const Parameter&) const = default;
};

enum class ShapeKind { Box, Cylinder, Sphere, Bar };

/// A drawn primitive, fixed to its body. Shapes carry no mass.
struct Shape {
    ShapeKind kind = ShapeKind::Box;
    Quantity3 center{};  ///< Box, Sphere [m]
    Quantity3 size{};    ///< Box: edge lengths along x, y, z [m]
    Quantity3 from{};    ///< Cylinder, Bar: one end of the axis [m]
    Quantity3 to{};      ///< Cylinder, Bar: other end of the axis [m]
    Quantity radius;     ///< Cylinder, Sphere [m]
    Quantity width;      ///< Bar: section across, horizontal [m]
    Quantity height;     ///< Bar: section across, vertical [m]
    Quantity pitch;      ///< Box: rotation about y through its centre [rad]
    std::string color;   ///< "#rrggbb", or a palette name (docs/project-file.md)
    bool operator==(const Shape&) const = default;
};

struct Body {
    std::string name;
    bool mirror = false;
    bool fixed = false;  ///< held in the world: a frame, a test stand
    Quantity mass;       ///< [kg]
    Quantity3 com{};     ///< centre of mass [m]
    /// Ixx Iyy Izz Ixy Ixz Iyz about the centre of mass, rover axes [kg m^2]; products of inertia
    /// with the sign of the matrix entry. Absent: that of the shapes as solids.
    std::optional<std::array<Quantity, 6>> inertia;
    std::vector<Shape> shapes;
    bool operator==(const Body&) const = default;
};

/// Both sides, y > 0 alone, y < 0 alone: under which wheels a profile lies, or to which copies of a
/// mirrored element its relaxed freedoms belong.
enum class Sides { Both, Left, Right };

/// A free direction of a joint, as text: "turn axis", "slide axis" (along the joint's axis),
/// "turn x", "slide z", ... (rover axes at the drawn pose), "slide 0.1 0 1" (any direction).
/// Directions are fixed to the joint's *first* body.
using FreedomText = std::string;

struct Joint {
    std::string name;
    bool mirror = false;
    std::string first;                             ///< body
    std::string second;                            ///< body
    Quantity3 point{};                             ///< [m]
    Quantity3 axis{0.0, 1.0, 0.0};                 ///< pin axis; any length
    std::vector<FreedomText> free{"turn axis"};    ///< as built
    std::vector<FreedomText> relaxed;              ///< relaxed model; empty = as built
    Sides relaxedSides = Sides::Both;              ///< copies that `relaxed` is for
    bool locked = false;                           ///< locked joints weld their bodies
    std::optional<std::array<Quantity, 2>> stops;  ///< turn about the axis [rad], drawn pose = 0
    Quantity damping;                              ///< about the axis [N m s/rad]
    Quantity friction;                             ///< dry, about the axis [N m]
    bool operator==(const Joint&) const = default;
};

struct Motor {
    Quantity torqueLimit{2.0};   ///< [N m]
    Quantity speedLimit{4.0};    ///< [rad/s]
    Quantity rotorInertia{0.0};  ///< reflected to the wheel [kg m^2]
    bool operator==(const Motor&) const = default;
};

/// Servo of a wheel's steering joint.
struct SteeringMotor {
    Quantity torqueLimit;      ///< [N m]; 0 = that of the wheel's motor
    Quantity speedLimit{1.0};  ///< [rad/s], assumed: 90 deg in 1.6 s
    bool operator==(const SteeringMotor&) const = default;
};

struct Wheel {
    std::string name;
    bool mirror = false;
    std::string body;   ///< the wheel's own body
    std::string axle;   ///< the pin joint it turns on
    Quantity radius;    ///< [m]
    Quantity width;     ///< [m]
    int grousers = 18;  ///< drawn only
    Motor motor;
    bool relaxedLateral = false;       ///< relaxed model: lateral slide freed
    Sides relaxedSides = Sides::Both;  ///< copies that `relaxedLateral` is for
    std::string steering;  ///< optional steering joint; welded unless a controller steers
    SteeringMotor steeringMotor;
    bool operator==(const Wheel&) const = default;
};

/// Linear spring-damper between two points, positive force pushes them apart; or, when `joint` is
/// given, a torsion spring about that joint's axis (positive torque turns the second body forward).
struct Spring {
    std::string name;
    bool mirror = false;
    std::string joint;
    std::string first;        ///< body (linear)
    std::string second;       ///< body (linear)
    Quantity3 firstPoint{};   ///< [m]
    Quantity3 secondPoint{};  ///< [m]
    Quantity stiffness;       ///< [N/m] or [N m/rad]
    Quantity preload;         ///< force or torque at the drawn pose [N], [N m]
    Quantity damping;         ///< [N s/m] or [N m s/rad]
    bool operator==(const Spring&) const = default;
};

/// One constraint row between two pin joints: turn(second) = ratio * turn(first). The gear
/// differential of a rocker-bogie is ratio -1 between the two rocker pins.
struct Gear {
    std::string name;
    std::string firstJoint;
    std::string secondJoint;
    Quantity ratio{-1.0};
    bool operator==(const Gear&) const = default;
};

/// A point mass fixed to a body.
struct Payload {
    std::string name;
    bool mirror = false;
    std::string body;
    Quantity mass;         ///< [kg]
    Quantity3 position{};  ///< [m]
    bool operator==(const Payload&) const = default;
};

struct Rover {
    std::string name;
    std::string description;
    std::vector<Parameter> parameters;
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    std::vector<Wheel> wheels;
    std::vector<Spring> springs;
    std::vector<Gear> gears;
    std::vector<Payload> payloads;
    bool operator==(const Rover&) const = default;
};

struct Override {
    std::string parameter;
    Quantity value;
    bool operator==(const Override&) const = default;
};

struct Variant {
    std::string name;
    std::string description;
    std::vector<Override> set;
    bool operator==(const Variant&) const = default;
};

enum class TerrainKind {
    Flat,
    Ramp,
    CrossSlope,
    Step,
    Stairs,
    Trench,
    Sinus,
    Circle,
    RandomProfile,
    Random3d,
    Particles,
    RockField,
    Sum,
    Image,
    AsciiGrid,
    Mesh
};

/// The axis of a mesh file that points up.
enum class UpAxis { Z, Y };

/// What the rover drives on. Fields that a kind does not use are left at their defaults and are not
/// written. Lengths may be expressions of rover parameters. docs/terrain.md defines every kind.
struct Terrain {
    TerrainKind kind = TerrainKind::Flat;
    Quantity start{1.0};  ///< x of the first feature [m]
    /// Step, Stairs (riser), Trench (depth), Sinus (peak to peak), Random* (largest), Image (of
    /// white over black) [m]
    Quantity height;
    /// Step: top; Stairs: tread; Trench: width; Sinus: wavelength; Ramp: run; CrossSlope: until it
    /// is reached; others: extent [m]
    Quantity length;
    Quantity slope;   ///< Ramp, CrossSlope [rad]
    Quantity radius;  ///< Circle, Particles (grain), RockField (largest) [m]
    /// Stairs: steps; Sinus: waves; Circle: bumps; Random*: features; Particles: grains
    int count = 1;
    int seed = 1;                   ///< Random*, Particles, RockField
    Quantity coverage{0.05};        ///< RockField: share of the ground under rocks of any size [-]
    Sides sides = Sides::Both;      ///< kinds that are profiles
    bool symmetric = false;         ///< Random3d, Particles, RockField: left half mirrored
    Quantity cell;                  ///< 3-D kinds: grid, 0 = 20 mm; Image: of a pixel [m]
    std::string file;               ///< Image, AsciiGrid, Mesh: relative to the project's folder
    std::string units = "m";        ///< AsciiGrid, Mesh: of the file's numbers
    Quantity scale{1.0};            ///< AsciiGrid, Mesh: further factor [-]
    UpAxis up = UpAxis::Z;          ///< Mesh
    Quantity3 origin{};             ///< Image, AsciiGrid, Mesh: where the file's origin lies [m]
    std::vector<Terrain> terrains;  ///< Sum: heights added; no sums, no meshes
    bool operator==(const Terrain&) const = default;
};

/// A rectangle of ground with values of its own.
struct SoilRegion {
    std::array<Quantity, 2> x{};                                     ///< from, to [m], world
    std::array<Quantity, 2> y{Quantity(-1000.0), Quantity(1000.0)};  ///< from, to [m], world
    Quantity friction{0.7};                                          ///< instead of the soil's [-]
    Quantity rollingResistance{0.0};                                 ///< instead of the soil's [-]
    bool operator==(const SoilRegion&) const = default;
};

struct Soil {
    Quantity friction{0.7};           ///< Coulomb coefficient wheel-ground [-]
    Quantity rollingResistance{0.0};  ///< moment = c N R [-]
    std::vector<SoilRegion> regions;  ///< later ones lie on top of earlier ones
    bool operator==(const Soil&) const = default;
};

enum class ControllerKind {
    Speed,
    Synchronised,
    CommonIntegral,
    EqualTorque,
    Torque,
    Hybrid,
    Manual
};

/// How a controller turns the rover: by speeds alone; by steering joints alone; or by steering
/// joints where there are any, helped by speeds where their stops are in the way.
enum class SteeringMode { Auto, Skid, Ackermann };

struct Controller {
    ControllerKind kind = ControllerKind::Speed;
    Quantity speed{0.1};                         ///< rover speed along the chassis [m/s]
    Quantity turn;                               ///< Speed: yaw rate [rad/s], + left
    SteeringMode steering = SteeringMode::Auto;  ///< Speed, Manual
    bool headingHold = false;       ///< Speed, Manual: keep the heading while no turn is asked
    Quantity assumedFriction{0.5};  ///< traction cap |tau| <= assumed_mu N R [-]; 0 = no cap
    Quantity period{0.01};          ///< [s]
    Quantity proportional;  ///< Speed: per wheel [N m s/rad]; EqualTorque: [N m s/m]; 0 = derived
    Quantity integral;      ///< 0 = derived from the rover (docs/controllers.md)
    Quantity derivative;
    bool operator==(const Controller&) const = default;
};

/// How far a kind of sensor is from the truth, in the SI unit of what it measures. All zero: ideal.
struct SensorError {
    Quantity noise;       ///< standard deviation of one reading
    Quantity bias;        ///< added to every reading
    Quantity delay;       ///< age of what is reported [s]
    Quantity resolution;  ///< readings are whole multiples of it; 0 = continuous
    bool operator==(const SensorError&) const = default;
};

/// The sensors a controller reads; docs/sensors.md says what each measures.
struct Sensors {
    SensorError jointEncoder;  ///< [rad]
    SensorError wheelRate;     ///< [rad/s]
    SensorError orientation;   ///< roll and pitch [rad]
    SensorError angularRate;   ///< [rad/s]
    SensorError acceleration;  ///< [m/s^2]
    SensorError tactileForce;  ///< [N]
    SensorError tactileAngle;  ///< [rad]
    SensorError bodySpeed;     ///< [m/s]
    bool operator==(const Sensors&) const = default;
};

/// What moves the bodies; docs/engines.md says when to use which.
enum class EngineKind { Ode, Reduced };

struct RunSettings {
    EngineKind engine = EngineKind::Ode;
    Quantity step{0.002};        ///< engine step [s]
    Quantity distance{3.5};      ///< chassis travel that completes the run [m]
    Quantity duration{0.0};      ///< simulated time that ends it [s]; 0 = 2 + 1.6 distance/speed
    Quantity settle{0.5};        ///< at rest first [s]
    Quantity ramp{0.5};          ///< then the command rises [s]
    bool relaxedJoints = false;  ///< joints with the freedoms of the relaxed model
    bool bodyContacts = true;    ///< bodies that are no wheels touch the ground, too
    int seed = 1;                ///< of the sensors' noise
    bool operator==(const RunSettings&) const = default;
};

struct Scenario {
    std::string name;
    std::string description;
    std::string variant;
    Terrain terrain;
    Soil soil;
    Controller controller;
    Sensors sensors;
    RunSettings run;
    bool operator==(const Scenario&) const = default;
};

struct Project {
    Rover rover;
    std::vector<Variant> variants;
    std::vector<Scenario> scenarios;
    bool operator==(const Project&) const = default;
};

}  // namespace simcore::project
