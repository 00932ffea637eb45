#pragma once

#include <memory>

#include "simcore/mechanism/mass_properties.h"
#include "simcore/run/simulation.h"
#include "tests/support/mechanisms.h"

/// The plainest things that roll, as mechanisms and as runs, with closed forms for their motion.
namespace testsupport {

using simcore::mechanism::Wheel;

/// A lone wheel: one body without a joint. The drive of such a wheel turns against itself and does
/// nothing; it is moved by external torques.
inline Mechanism makeDrum(double mass, double radius, double width,
                          const Vec3& center = Vec3::Zero()) {
    Mechanism mechanism;
    mechanism.name = "drum";
    mechanism.bodies = {makeBody("drum", mass, center)};
    mechanism.bodies[0].inertia =
        simcore::mechanism::inertiaOfCylinder(mass, radius, width, Vec3::UnitY());
    Wheel wheel;
    wheel.name = "drum";
    wheel.body = wheel.carrier = 0;
    wheel.center = center;
    wheel.radius = radius;
    wheel.width = width;
    mechanism.wheels = {wheel};
    return mechanism;
}

struct CartNumbers {
    double chassisMass = 6.0;                     ///< [kg]
    double comX = 0.0, comZ = 0.1;                ///< of the chassis [m]
    double wheelMass = 0.5, radius = 0.07;        ///< [kg], [m]
    double halfBase = 0.2, halfTrack = 0.2;       ///< [m]
    double torqueLimit = 3.0, speedLimit = 10.0;  ///< [N m], [rad/s]
    double rotorInertia = 0.0;                    ///< [kg m^2]
};

/// A rigid chassis on four driven wheels: front left and right, rear left and right.
inline Mechanism makeCart(const CartNumbers& numbers = {}) {
    constexpr double kWidth = 0.05;
    Mechanism mechanism;
    mechanism.name = "cart";
    mechanism.bodies = {makeBody("chassis", numbers.chassisMass, {numbers.comX, 0.0, numbers.comZ},
                                 {0.08, 0.1, 0.12})};
    for (const double x : {numbers.halfBase, -numbers.halfBase}) {
        for (const double y : {numbers.halfTrack, -numbers.halfTrack}) {
            const std::string name =
                std::string(x > 0.0 ? "front" : "rear") + (y > 0.0 ? "_left" : "_right");
            const Vec3 center(x, y, numbers.radius);
            const int body = static_cast<int>(mechanism.bodies.size());
            mechanism.bodies.push_back(makeBody(name, numbers.wheelMass, center));
            mechanism.bodies.back().inertia = simcore::mechanism::inertiaOfCylinder(
                numbers.wheelMass, numbers.radius, kWidth, Vec3::UnitY());
            mechanism.joints.push_back(makePin(name + "_axle", 0, body, center));
            Wheel wheel;
            wheel.name = name;
            wheel.body = body;
            wheel.axle = static_cast<int>(mechanism.joints.size()) - 1;
            wheel.carrier = 0;
            wheel.center = center;
            wheel.radius = numbers.radius;
            wheel.width = kWidth;
            wheel.torqueLimit = numbers.torqueLimit;
            wheel.speedLimit = numbers.speedLimit;
            wheel.rotorInertia = numbers.rotorInertia;
            mechanism.wheels.push_back(wheel);
        }
    }
    return mechanism;
}

/// How a steered cart's wheels hang on their steering pins.
struct SteeringNumbers {
    double stop = 1.745;                         ///< [rad], to either side
    double trail = 0.0, scrub = 0.0;             ///< of the wheel, ahead and outward of its pin [m]
    bool frontOnly = false;                      ///< the rear wheels stay straight
    bool reversed = false;                       ///< pins point down, and the bracket comes first
    double bracketMass = 0.2;                    ///< [kg]
    double torqueLimit = 3.0, speedLimit = 1.0;  ///< [N m], [rad/s]
};

/// The cart with steered wheels, each on a bracket that turns on an upright pin.
inline Mechanism makeSteeredCart(const SteeringNumbers& steering = {},
                                 const CartNumbers& numbers = {}) {
    Mechanism mechanism = makeCart(numbers);
    for (Wheel& wheel : mechanism.wheels) {
        if (steering.frontOnly && wheel.center.x() < 0.0) {
            continue;
        }
        const double out = wheel.center.y() > 0.0 ? 1.0 : -1.0;
        const int bracket = static_cast<int>(mechanism.bodies.size());
        const Vec3 pin = wheel.center + Vec3(-steering.trail, -out * steering.scrub, 0.1);
        mechanism.bodies.push_back(
            makeBody(wheel.name + "_bracket", steering.bracketMass, pin, {1e-3, 1e-3, 1e-3}));
        auto& axle = mechanism.joints[static_cast<std::size_t>(wheel.axle)];
        (axle.first == wheel.body ? axle.second : axle.first) = bracket;
        Joint joint = steering.reversed ? makePin(wheel.name + "_pin", bracket, 0, pin)
                                        : makePin(wheel.name + "_pin", 0, bracket, pin);
        joint.axis = steering.reversed ? Vec3(-Vec3::UnitZ()) : Vec3::UnitZ();
        joint.built = joint.relaxed = {{FreedomKind::Turn, joint.axis}};
        joint.stops = {-steering.stop, steering.stop};
        wheel.carrier = bracket;
        wheel.steering = static_cast<int>(mechanism.joints.size());
        wheel.steeringTorqueLimit = steering.torqueLimit;
        wheel.steeringSpeedLimit = steering.speedLimit;
        mechanism.joints.push_back(joint);
    }
    return mechanism;
}

/// The mechanism drawn turned about the world's origin. Shapes have no roll: they are turned
/// exactly about y, else only in place and pitch.
inline Mechanism turned(Mechanism mechanism, const Mat3& R) {
    for (Body& body : mechanism.bodies) {
        body.com = R * body.com;
        body.inertia = R * body.inertia * R.transpose();
        for (simcore::mechanism::Shape& shape : body.shapes) {
            shape.center = R * shape.center;
            shape.from = R * shape.from;
            shape.to = R * shape.to;
            shape.pitch += simcore::turnAbout(Eigen::Quaterniond(R), Vec3::UnitY());
        }
    }
    for (Joint& joint : mechanism.joints) {
        joint.point = R * joint.point;
        joint.axis = R * joint.axis;
        for (auto* freedoms : {&joint.built, &joint.relaxed}) {
            for (Freedom& freedom : *freedoms) {
                freedom.direction = R * freedom.direction;
            }
        }
    }
    for (Wheel& wheel : mechanism.wheels) {
        wheel.center = R * wheel.center;
        wheel.axis = R * wheel.axis;
    }
    for (auto& spring : mechanism.springs) {
        spring.firstPoint = R * spring.firstPoint;
        spring.secondPoint = R * spring.secondPoint;
    }
    return mechanism;
}

/// The mechanism drawn with its nose up by `slope` [rad] about the world's y axis: so it starts on
/// the ground of slopeThroughOrigin().
inline Mechanism tilted(const Mechanism& mechanism, double slope) {
    return turned(mechanism, Eigen::AngleAxisd(-slope, Vec3::UnitY()).toRotationMatrix());
}

/// A plane that rises with `slope` [rad] along x and holds the origin.
inline simcore::terrain::Terrain slopeThroughOrigin(double slope, double reach = 5.0) {
    return simcore::terrain::Terrain::extruded(
        {{-reach, -reach * std::tan(slope)}, {reach, reach * std::tan(slope)}}, -3.0, 3.0);
}

inline simcore::terrain::Terrain levelGround() {
    return slopeThroughOrigin(0.0, 50.0);
}

/// A run of that mechanism on that ground with little settling: the rest is to be set.
inline simcore::run::ResolvedRun runOf(Mechanism mechanism, simcore::terrain::Terrain terrain) {
    simcore::run::ResolvedRun run;
    run.scenario = mechanism.name;
    run.mechanism = std::move(mechanism);
    run.terrain = std::make_shared<const simcore::terrain::Terrain>(std::move(terrain));
    run.settle = 0.2;
    run.ramp = 0.2;
    return run;
}

/// Steps until the run ends, or until `time` [s] of it has passed.
inline simcore::run::RunReport runToEnd(simcore::run::Simulation& simulation, double time = 1e9) {
    while (!simulation.finished() &&
           simulation.snapshot().time < time - 0.5 * simulation.settings().step) {
        simulation.step();
    }
    return simulation.report();
}

inline simcore::run::RunReport reportOf(const simcore::run::ResolvedRun& run) {
    simcore::run::Simulation simulation(run);
    return runToEnd(simulation);
}

}  // namespace testsupport
