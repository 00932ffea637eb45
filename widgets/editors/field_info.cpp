#include "widgets/editors/field_info.h"

#include <QCoreApplication>
#include <array>
#include <cstring>

namespace widgets {
namespace {

struct Entry {
    const char* element;  ///< "" = any
    const char* key;
    const char* label;
    const char* unit;
    const char* tooltip;
};

/// First match counts.
constexpr std::array kEntries{
    Entry{"parameter", "unit", QT_TRANSLATE_NOOP("fields", "Display unit"), "",
          QT_TRANSLATE_NOOP("fields", "Unit on the screen; files hold SI")},
    Entry{"body", "mass", QT_TRANSLATE_NOOP("fields", "Mass"), "kg", ""},
    Entry{"body", "com", QT_TRANSLATE_NOOP("fields", "Centre of mass"), "mm",
          QT_TRANSLATE_NOOP("fields",
                            "In the rover frame: x forward, y left, z up from the "
                            "ground")},
    Entry{"body", "fixed", QT_TRANSLATE_NOOP("fields", "Fixed"), "",
          QT_TRANSLATE_NOOP("fields", "Held in the world: a frame, or a test stand")},
    Entry{"body", "inertia", QT_TRANSLATE_NOOP("fields", "Inertia"), "kg*m^2",
          QT_TRANSLATE_NOOP("fields", "Ixx Iyy Izz Ixy Ixz Iyz about the centre of mass")},
    Entry{"joint", "first", QT_TRANSLATE_NOOP("fields", "First body"), "",
          QT_TRANSLATE_NOOP("fields", "The free directions are fixed to this body")},
    Entry{"joint", "second", QT_TRANSLATE_NOOP("fields", "Second body"), "", ""},
    Entry{"joint", "point", QT_TRANSLATE_NOOP("fields", "Point"), "mm", ""},
    Entry{"joint", "axis", QT_TRANSLATE_NOOP("fields", "Pin axis"), "",
          QT_TRANSLATE_NOOP("fields", "Direction; its length does not matter")},
    Entry{"joint", "free", QT_TRANSLATE_NOOP("fields", "Free as built"), "",
          QT_TRANSLATE_NOOP("fields",
                            "Free directions, separated by commas: turn axis, slide "
                            "axis, turn x, slide z, slide 1 0 1")},
    Entry{"joint", "relaxed", QT_TRANSLATE_NOOP("fields", "Free, relaxed"), "",
          QT_TRANSLATE_NOOP("fields", "Free directions in the relaxed model; empty = as built")},
    Entry{
        "joint", "relaxed_sides", QT_TRANSLATE_NOOP("fields", "Relaxed on"), "",
        QT_TRANSLATE_NOOP("fields", "Which of the two mirrored joints the relaxed model changes")},
    Entry{"joint", "locked", QT_TRANSLATE_NOOP("fields", "Locked"), "",
          QT_TRANSLATE_NOOP("fields", "A locked joint welds its two bodies")},
    Entry{"joint", "stops", QT_TRANSLATE_NOOP("fields", "Stops"), "deg",
          QT_TRANSLATE_NOOP("fields", "Turn about the pin axis; the drawn pose is 0")},
    Entry{"joint", "damping", QT_TRANSLATE_NOOP("fields", "Damping"), "N*m*s/rad", ""},
    Entry{"motor", "torque_limit", QT_TRANSLATE_NOOP("fields", "Torque limit"), "N*m", ""},
    Entry{"motor", "speed_limit", QT_TRANSLATE_NOOP("fields", "Speed limit"), "rad/s", ""},
    Entry{"motor", "rotor_inertia", QT_TRANSLATE_NOOP("fields", "Rotor inertia"), "kg*m^2",
          QT_TRANSLATE_NOOP("fields", "Reflected to the wheel")},
    Entry{"wheel", "body", QT_TRANSLATE_NOOP("fields", "Wheel's body"), "", ""},
    Entry{"wheel", "axle", QT_TRANSLATE_NOOP("fields", "Axle"), "",
          QT_TRANSLATE_NOOP("fields", "The joint the wheel turns on")},
    Entry{"wheel", "grousers", QT_TRANSLATE_NOOP("fields", "Grousers"), "",
          QT_TRANSLATE_NOOP("fields", "Drawn only")},
    Entry{"wheel", "relaxed_lateral", QT_TRANSLATE_NOOP("fields", "Relaxed: free sideways"), "",
          QT_TRANSLATE_NOOP("fields", "The relaxed model lets this contact slide sideways")},
    Entry{"wheel", "relaxed_sides", QT_TRANSLATE_NOOP("fields", "Relaxed on"), "",
          QT_TRANSLATE_NOOP("fields", "Which of the two mirrored wheels the relaxed model frees")},
    Entry{"wheel", "steering_motor", QT_TRANSLATE_NOOP("fields", "Steering motor"), "", ""},
    Entry{"wheel", "steering", QT_TRANSLATE_NOOP("fields", "Steering joint"), "",
          QT_TRANSLATE_NOOP("fields", "Upright pin; welded unless the controller steers")},
    Entry{"steering_motor", "torque_limit", QT_TRANSLATE_NOOP("fields", "Steering torque"), "N*m",
          QT_TRANSLATE_NOOP("fields", "0 = that of the wheel's motor")},
    Entry{"steering_motor", "speed_limit", QT_TRANSLATE_NOOP("fields", "Steering speed"), "rad/s",
          ""},
    Entry{"spring", "joint", QT_TRANSLATE_NOOP("fields", "On joint"), "",
          QT_TRANSLATE_NOOP("fields", "A torsion spring about this joint; empty = between points")},
    Entry{"spring", "first_point", QT_TRANSLATE_NOOP("fields", "First point"), "mm", ""},
    Entry{"spring", "second_point", QT_TRANSLATE_NOOP("fields", "Second point"), "mm", ""},
    Entry{"spring", "first", QT_TRANSLATE_NOOP("fields", "First body"), "", ""},
    Entry{"spring", "second", QT_TRANSLATE_NOOP("fields", "Second body"), "", ""},
    Entry{"spring", "stiffness", QT_TRANSLATE_NOOP("fields", "Stiffness"), "N/mm", ""},
    Entry{"spring", "preload", QT_TRANSLATE_NOOP("fields", "Preload"), "N",
          QT_TRANSLATE_NOOP("fields", "At the drawn pose; positive pushes apart")},
    Entry{"spring", "damping", QT_TRANSLATE_NOOP("fields", "Damping"), "N*s/m", ""},
    Entry{"gear", "first_joint", QT_TRANSLATE_NOOP("fields", "First joint"), "", ""},
    Entry{"gear", "second_joint", QT_TRANSLATE_NOOP("fields", "Second joint"), "", ""},
    Entry{"gear", "ratio", QT_TRANSLATE_NOOP("fields", "Ratio"), "",
          QT_TRANSLATE_NOOP("fields", "turn(second) = ratio * turn(first)")},
    Entry{"payload", "mass", QT_TRANSLATE_NOOP("fields", "Mass"), "kg", ""},
    Entry{"payload", "position", QT_TRANSLATE_NOOP("fields", "Position"), "mm", ""},
    Entry{"scenario", "variant", QT_TRANSLATE_NOOP("fields", "Variant"), "", ""},
    Entry{"scenario", "terrain", QT_TRANSLATE_NOOP("fields", "Terrain"), "", ""},
    Entry{"scenario", "soil", QT_TRANSLATE_NOOP("fields", "Soil"), "", ""},
    Entry{"scenario", "controller", QT_TRANSLATE_NOOP("fields", "Controller"), "", ""},
    Entry{"scenario", "sensors", QT_TRANSLATE_NOOP("fields", "Sensors"), "", ""},
    Entry{"scenario", "run", QT_TRANSLATE_NOOP("fields", "Run"), "", ""},
    Entry{"variant", "set", QT_TRANSLATE_NOOP("fields", "Parameters set"), "", ""},
    Entry{"wheel", "motor", QT_TRANSLATE_NOOP("fields", "Motor"), "", ""},
    Entry{"terrain", "start", QT_TRANSLATE_NOOP("fields", "Start"), "m",
          QT_TRANSLATE_NOOP("fields", "x of the first feature")},
    Entry{"terrain", "length", QT_TRANSLATE_NOOP("fields", "Length"), "m",
          QT_TRANSLATE_NOOP("fields",
                            "Step: of the top; stairs: of a tread; trench: its width; sinus: of a "
                            "wave; ramp: of its run; cross slope: until it is reached; others: of "
                            "the whole")},
    Entry{"terrain", "count", QT_TRANSLATE_NOOP("fields", "Number"), "",
          QT_TRANSLATE_NOOP("fields", "Of steps, waves, bumps, features or particles")},
    Entry{"terrain", "seed", QT_TRANSLATE_NOOP("fields", "Seed"), "",
          QT_TRANSLATE_NOOP("fields", "Same seed, same terrain")},
    Entry{"terrain", "coverage", QT_TRANSLATE_NOOP("fields", "Coverage"), "",
          QT_TRANSLATE_NOOP("fields", "Share of the ground under rocks, k of Golombek and Rapp")},
    Entry{"terrain", "sides", QT_TRANSLATE_NOOP("fields", "Sides"), "",
          QT_TRANSLATE_NOOP("fields", "Under the wheels of both sides or of one")},
    Entry{"terrain", "symmetric", QT_TRANSLATE_NOOP("fields", "Symmetric"), "",
          QT_TRANSLATE_NOOP("fields", "The right half is the mirror image of the left")},
    Entry{"terrain", "cell", QT_TRANSLATE_NOOP("fields", "Cell"), "mm",
          QT_TRANSLATE_NOOP("fields", "Between two points of the grid; an image's pixel")},
    Entry{"terrain", "file", QT_TRANSLATE_NOOP("fields", "File"), "",
          QT_TRANSLATE_NOOP("fields", "Relative to the project's folder, or absolute")},
    Entry{"terrain", "units", QT_TRANSLATE_NOOP("fields", "File units"), "",
          QT_TRANSLATE_NOOP("fields", "Unit of length of the file's numbers: m, mm, in, ...")},
    Entry{"terrain", "scale", QT_TRANSLATE_NOOP("fields", "Scale"), "",
          QT_TRANSLATE_NOOP("fields", "Further factor on the file's numbers")},
    Entry{"terrain", "up", QT_TRANSLATE_NOOP("fields", "Up axis"), "",
          QT_TRANSLATE_NOOP("fields", "The file's axis that points up")},
    Entry{"terrain", "origin", QT_TRANSLATE_NOOP("fields", "Origin"), "m",
          QT_TRANSLATE_NOOP("fields", "Where the file's origin lies in the world")},
    Entry{"terrain", "terrains", QT_TRANSLATE_NOOP("fields", "Terrains added"), "", ""},
    Entry{"soil", "regions", QT_TRANSLATE_NOOP("fields", "Regions"), "",
          QT_TRANSLATE_NOOP("fields", "Rectangles of ground with values of their own")},
    Entry{"region", "x", QT_TRANSLATE_NOOP("fields", "x"), "m", ""},
    Entry{"region", "y", QT_TRANSLATE_NOOP("fields", "y"), "m", ""},
    Entry{"", "friction", QT_TRANSLATE_NOOP("fields", "Friction"), "",
          QT_TRANSLATE_NOOP("fields", "Coulomb coefficient between wheel and ground")},
    Entry{"", "rolling_resistance", QT_TRANSLATE_NOOP("fields", "Rolling resistance"), "",
          QT_TRANSLATE_NOOP("fields", "c in: moment = c N R")},
    Entry{"controller", "speed", QT_TRANSLATE_NOOP("fields", "Speed"), "m/s", ""},
    Entry{"controller", "turn", QT_TRANSLATE_NOOP("fields", "Turn"), "rad/s",
          QT_TRANSLATE_NOOP("fields", "Yaw rate of speed control, to the left")},
    Entry{"controller", "steering", QT_TRANSLATE_NOOP("fields", "Steering"), "",
          QT_TRANSLATE_NOOP("fields",
                            "skid: by wheel speeds; ackermann: by steering joints alone; "
                            "auto: both")},
    Entry{"controller", "heading_hold", QT_TRANSLATE_NOOP("fields", "Heading hold"), "",
          QT_TRANSLATE_NOOP("fields", "Keeps the heading while no turn is asked")},
    Entry{"controller", "assumed_friction", QT_TRANSLATE_NOOP("fields", "Assumed friction"), "",
          QT_TRANSLATE_NOOP("fields", "Torques are capped at this times N R; 0 = no cap")},
    Entry{"controller", "period", QT_TRANSLATE_NOOP("fields", "Period"), "ms", ""},
    Entry{"controller", "proportional", QT_TRANSLATE_NOOP("fields", "Gain P"), "",
          QT_TRANSLATE_NOOP("fields", "0 = derived from the rover")},
    Entry{"controller", "integral", QT_TRANSLATE_NOOP("fields", "Gain I"), "",
          QT_TRANSLATE_NOOP("fields", "0 = derived from the rover")},
    Entry{"controller", "derivative", QT_TRANSLATE_NOOP("fields", "Gain D"), "", ""},
    Entry{"sensors", "joint_encoder", QT_TRANSLATE_NOOP("fields", "Joint encoders [rad]"), "", ""},
    Entry{"sensors", "wheel_rate", QT_TRANSLATE_NOOP("fields", "Wheel rate [rad/s]"), "", ""},
    Entry{"sensors", "orientation", QT_TRANSLATE_NOOP("fields", "Roll and pitch [rad]"), "", ""},
    Entry{"sensors", "angular_rate", QT_TRANSLATE_NOOP("fields", "Angular rate [rad/s]"), "", ""},
    Entry{"sensors", "acceleration", QT_TRANSLATE_NOOP("fields", "Acceleration [m/s\u00b2]"), "",
          ""},
    Entry{"sensors", "tactile_force", QT_TRANSLATE_NOOP("fields", "Tactile force [N]"), "", ""},
    Entry{"sensors", "tactile_angle", QT_TRANSLATE_NOOP("fields", "Tactile angle [rad]"), "", ""},
    Entry{"sensors", "body_speed", QT_TRANSLATE_NOOP("fields", "Body speed [m/s]"), "", ""},
    Entry{"sensor", "noise", QT_TRANSLATE_NOOP("fields", "Noise"), "",
          QT_TRANSLATE_NOOP("fields", "Standard deviation of one reading")},
    Entry{"sensor", "bias", QT_TRANSLATE_NOOP("fields", "Bias"), "",
          QT_TRANSLATE_NOOP("fields", "Added to every reading")},
    Entry{"sensor", "delay", QT_TRANSLATE_NOOP("fields", "Delay"), "ms",
          QT_TRANSLATE_NOOP("fields", "Age of what is reported")},
    Entry{"sensor", "resolution", QT_TRANSLATE_NOOP("fields", "Resolution"), "",
          QT_TRANSLATE_NOOP("fields", "Readings are multiples of it; 0 = continuous")},
    Entry{"run", "engine", QT_TRANSLATE_NOOP("fields", "Engine"), "",
          QT_TRANSLATE_NOOP("fields", "ode: rows of constraints; reduced: free rates, faster")},
    Entry{"run", "step", QT_TRANSLATE_NOOP("fields", "Time step"), "ms", ""},
    Entry{"run", "distance", QT_TRANSLATE_NOOP("fields", "Distance"), "m",
          QT_TRANSLATE_NOOP("fields", "Travel that completes the run")},
    Entry{"run", "duration", QT_TRANSLATE_NOOP("fields", "Longest time"), "s",
          QT_TRANSLATE_NOOP("fields", "0 = from distance and speed")},
    Entry{"run", "settle", QT_TRANSLATE_NOOP("fields", "Settling time"), "s", ""},
    Entry{"run", "ramp", QT_TRANSLATE_NOOP("fields", "Ramp time"), "s", ""},
    Entry{"run", "relaxed_joints", QT_TRANSLATE_NOOP("fields", "Relaxed joints"), "",
          QT_TRANSLATE_NOOP("fields", "Joints with the freedoms of the relaxed model")},
    Entry{
        "run", "body_contacts", QT_TRANSLATE_NOOP("fields", "Body contacts"), "",
        QT_TRANSLATE_NOOP("fields", "Chassis, forks and links touch the ground, not only wheels")},
    Entry{"run", "seed", QT_TRANSLATE_NOOP("fields", "Seed"), "", ""},
    Entry{"", "name", QT_TRANSLATE_NOOP("fields", "Name"), "",
          QT_TRANSLATE_NOOP("fields",
                            "References follow when you rename; {side} stands for left "
                            "and right")},
    Entry{"", "mirror", QT_TRANSLATE_NOOP("fields", "Mirrored"), "",
          QT_TRANSLATE_NOOP("fields", "A second one on the other side, y to -y")},
    Entry{"", "body", QT_TRANSLATE_NOOP("fields", "Body"), "", ""},
    Entry{"", "radius", QT_TRANSLATE_NOOP("fields", "Radius"), "mm", ""},
    Entry{"", "width", QT_TRANSLATE_NOOP("fields", "Width"), "mm", ""},
    Entry{"", "height", QT_TRANSLATE_NOOP("fields", "Height"), "mm", ""},
    Entry{"", "slope", QT_TRANSLATE_NOOP("fields", "Slope"), "deg", ""},
    Entry{"", "description", QT_TRANSLATE_NOOP("fields", "Description"), "", ""},
    Entry{"", "kind", QT_TRANSLATE_NOOP("fields", "Kind"), "", ""},
    Entry{"", "value", QT_TRANSLATE_NOOP("fields", "Value"), "", ""},
    Entry{"", "minimum", QT_TRANSLATE_NOOP("fields", "Minimum"), "", ""},
    Entry{"", "maximum", QT_TRANSLATE_NOOP("fields", "Maximum"), "", ""},
    Entry{"", "meaning", QT_TRANSLATE_NOOP("fields", "Meaning"), "", ""},
    Entry{"", "source", QT_TRANSLATE_NOOP("fields", "Source"), "", ""},
    Entry{"shape", "center", QT_TRANSLATE_NOOP("fields", "Centre"), "mm", ""},
    Entry{"shape", "size", QT_TRANSLATE_NOOP("fields", "Edges"), "mm", ""},
    Entry{"shape", "from", QT_TRANSLATE_NOOP("fields", "One end"), "mm", ""},
    Entry{"shape", "to", QT_TRANSLATE_NOOP("fields", "Other end"), "mm", ""},
    Entry{"shape", "radius", QT_TRANSLATE_NOOP("fields", "Radius"), "mm", ""},
    Entry{"shape", "pitch", QT_TRANSLATE_NOOP("fields", "Pitch"), "deg",
          QT_TRANSLATE_NOOP("fields", "Turn about y through its centre")},
    Entry{"shape", "color", QT_TRANSLATE_NOOP("fields", "Colour"), "",
          QT_TRANSLATE_NOOP("fields",
                            "#rrggbb, or a name: chassis, accent, link, link_dark, "
                            "metal, solar, tyre, white")},
    Entry{"", "shapes", QT_TRANSLATE_NOOP("fields", "Shapes"), "", ""},
};

QString translated(const char* text) {
    return *text == '\0' ? QString() : QCoreApplication::translate("fields", text);
}

}  // namespace

FieldInfo fieldInfo(const QString& element, const QString& key) {
    for (const Entry& entry : kEntries) {
        if (key == entry.key && (*entry.element == '\0' || element == entry.element)) {
            return {translated(entry.label), entry.unit, translated(entry.tooltip), true};
        }
    }
    return {key, {}, {}, true};
}

QString inSentence(const QString& title) {
    //: Case of a noun in the middle of a sentence: "lower", or "keep" where nouns have capitals.
    return QCoreApplication::translate("fields", "lower") == "lower" ? title.toLower() : title;
}

bool shapeUses(simcore::project::ShapeKind kind, const QString& key) {
    using simcore::project::ShapeKind;
    if (key == "kind" || key == "color") {
        return true;
    }
    switch (kind) {
        case ShapeKind::Box:
            return key == "center" || key == "size" || key == "pitch";
        case ShapeKind::Sphere:
            return key == "center" || key == "radius";
        case ShapeKind::Cylinder:
            return key == "from" || key == "to" || key == "radius";
        case ShapeKind::Bar:
            break;
    }
    return key == "from" || key == "to" || key == "width" || key == "height";
}

bool terrainUses(simcore::project::TerrainKind kind, const QString& key) {
    using simcore::project::TerrainKind;
    const auto any = [&](std::initializer_list<const char*> keys) {
        for (const char* one : keys) {
            if (key == one) {
                return true;
            }
        }
        return false;
    };
    switch (kind) {
        case TerrainKind::Flat:
            return any({"kind"});
        case TerrainKind::Ramp:
            return any({"kind", "start", "slope", "length", "sides"});
        case TerrainKind::CrossSlope:
            return any({"kind", "start", "slope", "length", "cell"});
        case TerrainKind::Step:
        case TerrainKind::Trench:
            return any({"kind", "start", "height", "length", "sides"});
        case TerrainKind::Stairs:
        case TerrainKind::Sinus:
            return any({"kind", "start", "height", "length", "count", "sides"});
        case TerrainKind::Circle:
            return any({"kind", "start", "radius", "height", "length", "count", "sides"});
        case TerrainKind::RandomProfile:
            return any({"kind", "start", "height", "length", "count", "seed", "sides"});
        case TerrainKind::Random3d:
            return any({"kind", "start", "height", "length", "count", "seed", "symmetric", "cell"});
        case TerrainKind::Particles:
            return any({"kind", "start", "radius", "length", "count", "seed", "symmetric", "cell"});
        case TerrainKind::RockField:
            return any(
                {"kind", "start", "radius", "length", "coverage", "seed", "symmetric", "cell"});
        case TerrainKind::Sum:
            return any({"kind", "terrains"});
        case TerrainKind::Image:
            return any({"kind", "file", "cell", "height", "origin"});
        case TerrainKind::AsciiGrid:
            return any({"kind", "file", "units", "scale", "origin"});
        case TerrainKind::Mesh:
            break;
    }
    return any({"kind", "file", "units", "scale", "up", "origin"});
}

}  // namespace widgets
