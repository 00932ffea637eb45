#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simcore/base/pose.h"
#include "simcore/project/project.h"

/// The resolved rover: numbers instead of expressions, both sides of every mirrored element, and
/// welded or locked parts merged into one body. Made by resolve(); read by every analysis, by the
/// engines and by the picture.
///
/// All geometry is in the rover frame at the drawn pose (x forward, y left, z up, origin on the
/// ground) [SI]. The frame of a body *is* the rover frame carried along with the body, so at the
/// drawn pose every body's pose is the rover's pose.
namespace simcore::mechanism {

struct Shape {
    project::ShapeKind kind = project::ShapeKind::Box;
    Vec3 center = Vec3::Zero();
    Vec3 size = Vec3::Zero();
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    double radius = 0.0;
    double width = 0.0;
    double height = 0.0;
    double pitch = 0.0;
    std::string color;
};

struct Body {
    std::string name;                ///< of the part that came first in the file
    std::vector<std::string> parts;  ///< names of all parts merged into it
    double mass = 0.0;               ///< [kg]
    Vec3 com = Vec3::Zero();         ///< [m]
    Mat3 inertia = Mat3::Zero();     ///< about com, rover axes [kg m^2]
    std::vector<Shape> shapes;
    bool fixed = false;  ///< held in the world at its drawn pose
};

enum class FreedomKind { Turn, Slide };

struct Freedom {
    FreedomKind kind = FreedomKind::Turn;
    Vec3 direction =
        Vec3::UnitY();  ///< unit, rover axes at the drawn pose, fixed to the first body
};

struct Joint {
    std::string name;
    int first = -1;   ///< body index
    int second = -1;  ///< body index
    Vec3 point = Vec3::Zero();
    Vec3 axis = Vec3::UnitY();  ///< unit pin axis
    std::vector<Freedom> built;
    std::vector<Freedom> relaxed;
    std::optional<std::pair<double, double>> stops;  ///< [rad] about axis, drawn pose = 0
    double damping = 0.0;                            ///< [N m s/rad]
    double friction = 0.0;                           ///< dry, about axis [N m]
};

struct Wheel {
    std::string name;
    int body = -1;
    int axle = -1;      ///< joint index
    int carrier = -1;   ///< body that holds the axle
    int steering = -1;  ///< joint index of the pin that steers it; -1 = none, or welded
    double steeringTorqueLimit = 0.0;  ///< of its servo [N m]
    double steeringSpeedLimit = 0.0;   ///< of its servo [rad/s]
    Vec3 center = Vec3::Zero();
    /// Unit, points to the rover's left (y > 0): a positive turn about it rolls forward.
    Vec3 axis = Vec3::UnitY();
    double radius = 0.0;
    double width = 0.0;
    int grousers = 0;
    double torqueLimit = 0.0;   ///< [N m]
    double speedLimit = 0.0;    ///< [rad/s]
    double rotorInertia = 0.0;  ///< reflected to the axle [kg m^2]
    bool relaxedLateral = false;
};

struct Spring {
    std::string name;
    int joint = -1;  ///< >= 0: torsion spring about that joint's axis
    int first = -1;
    int second = -1;
    Vec3 firstPoint = Vec3::Zero();
    Vec3 secondPoint = Vec3::Zero();
    double stiffness = 0.0;
    double preload = 0.0;  ///< positive pushes apart, or turns the second body forward
    double damping = 0.0;
};

struct Gear {
    std::string name;
    int firstJoint = -1;
    int secondJoint = -1;
    double ratio = -1.0;  ///< turn(second) = ratio * turn(first)
};

struct Mechanism {
    std::string name;
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    std::vector<Wheel> wheels;  ///< file order; a mirrored wheel's left side comes first
    std::vector<Spring> springs;
    std::vector<Gear> gears;
    int chassis = 0;  ///< index of the body of the file's first body

    /// Total mass [kg].
    double mass() const;
    /// Centre of mass at the drawn pose [m].
    Vec3 centerOfMass() const;
    /// Centre of mass in the world for the given body poses X_WB [m].
    Vec3 centerOfMass(const std::vector<Pose>& poses) const;
    /// Of a body about its centre of mass, in rover axes [kg m^2]: of a wheel with its motor's
    /// rotor.
    Mat3 inertiaWithRotor(std::size_t body) const;
    /// Distance between the foremost and the rearmost wheel centre [m]: the length that makes
    /// translations and rotations comparable. 1 m when there are fewer than two wheels.
    double wheelbase() const;
    /// Joints that turn about their axis and are no wheel's axle: where a rover has encoders.
    std::vector<int> encoderJoints() const;
    /// Index of the named body (by any of its part names), joint or wheel; -1 when there is none.
    int findBody(const std::string& partName) const;
    int findJoint(const std::string& jointName) const;
    int findWheel(const std::string& wheelName) const;
};

}  // namespace simcore::mechanism
