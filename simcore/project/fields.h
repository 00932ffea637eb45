#pragma once

#include "simcore/project/project.h"

/// The fields of every element, once: the file reader, the file writer and generic editors all walk
/// this table. A visitor has `required(key, member)` and `optional(key, member)`.
namespace simcore::project {

template <class V>
void describe(V& v, const Parameter*) {
    v.required("name", &Parameter::name);
    v.required("value", &Parameter::value);
    v.optional("unit", &Parameter::unit);
    v.optional("minimum", &Parameter::minimum);
    v.optional("maximum", &Parameter::maximum);
    v.optional("meaning", &Parameter::meaning);
    v.optional("source", &Parameter::source);
}

template <class V>
void describe(V& v, const Shape*) {
    v.required("kind", &Shape::kind);
    v.optional("center", &Shape::center);
    v.optional("size", &Shape::size);
    v.optional("from", &Shape::from);
    v.optional("to", &Shape::to);
    v.optional("radius", &Shape::radius);
    v.optional("width", &Shape::width);
    v.optional("height", &Shape::height);
    v.optional("pitch", &Shape::pitch);
    v.optional("color", &Shape::color);
}

template <class V>
void describe(V& v, const Body*) {
    v.required("name", &Body::name);
    v.optional("mirror", &Body::mirror);
    v.optional("fixed", &Body::fixed);
    v.required("mass", &Body::mass);
    v.required("com", &Body::com);
    v.optional("inertia", &Body::inertia);
    v.optional("shapes", &Body::shapes);
}

template <class V>
void describe(V& v, const Joint*) {
    v.required("name", &Joint::name);
    v.optional("mirror", &Joint::mirror);
    v.required("first", &Joint::first);
    v.required("second", &Joint::second);
    v.required("point", &Joint::point);
    v.optional("axis", &Joint::axis);
    v.optional("free", &Joint::free);
    v.optional("relaxed", &Joint::relaxed);
    v.optional("relaxed_sides", &Joint::relaxedSides);
    v.optional("locked", &Joint::locked);
    v.optional("stops", &Joint::stops);
    v.optional("damping", &Joint::damping);
    v.optional("friction", &Joint::friction);
}

template <class V>
void describe(V& v, const Motor*) {
    v.optional("torque_limit", &Motor::torqueLimit);
    v.optional("speed_limit", &Motor::speedLimit);
    v.optional("rotor_inertia", &Motor::rotorInertia);
}

template <class V>
void describe(V& v, const SteeringMotor*) {
    v.optional("torque_limit", &SteeringMotor::torqueLimit);
    v.optional("speed_limit", &SteeringMotor::speedLimit);
}

template <class V>
void describe(V& v, const Wheel*) {
    v.required("name", &Wheel::name);
    v.optional("mirror", &Wheel::mirror);
    v.required("body", &Wheel::body);
    v.required("axle", &Wheel::axle);
    v.required("radius", &Wheel::radius);
    v.required("width", &Wheel::width);
    v.optional("grousers", &Wheel::grousers);
    v.optional("motor", &Wheel::motor);
    v.optional("relaxed_lateral", &Wheel::relaxedLateral);
    v.optional("relaxed_sides", &Wheel::relaxedSides);
    v.optional("steering", &Wheel::steering);
    v.optional("steering_motor", &Wheel::steeringMotor);
}

template <class V>
void describe(V& v, const Spring*) {
    v.required("name", &Spring::name);
    v.optional("mirror", &Spring::mirror);
    v.optional("joint", &Spring::joint);
    v.optional("first", &Spring::first);
    v.optional("second", &Spring::second);
    v.optional("first_point", &Spring::firstPoint);
    v.optional("second_point", &Spring::secondPoint);
    v.required("stiffness", &Spring::stiffness);
    v.optional("preload", &Spring::preload);
    v.optional("damping", &Spring::damping);
}

template <class V>
void describe(V& v, const Gear*) {
    v.required("name", &Gear::name);
    v.required("first_joint", &Gear::firstJoint);
    v.required("second_joint", &Gear::secondJoint);
    v.optional("ratio", &Gear::ratio);
}

template <class V>
void describe(V& v, const Payload*) {
    v.required("name", &Payload::name);
    v.optional("mirror", &Payload::mirror);
    v.required("body", &Payload::body);
    v.required("mass", &Payload::mass);
    v.required("position", &Payload::position);
}

template <class V>
void describe(V& v, const Rover*) {
    v.required("name", &Rover::name);
    v.optional("description", &Rover::description);
    v.optional("parameters", &Rover::parameters);
    v.required("bodies", &Rover::bodies);
    v.optional("joints", &Rover::joints);
    v.optional("wheels", &Rover::wheels);
    v.optional("springs", &Rover::springs);
    v.optional("gears", &Rover::gears);
    v.optional("payloads", &Rover::payloads);
}

template <class V>
void describe(V& v, const Override*) {
    v.required("parameter", &Override::parameter);
    v.required("value", &Override::value);
}

template <class V>
void describe(V& v, const Variant*) {
    v.required("name", &Variant::name);
    v.optional("description", &Variant::description);
    v.optional("set", &Variant::set);
}

template <class V>
void describe(V& v, const Terrain*) {
    v.required("kind", &Terrain::kind);
    v.optional("start", &Terrain::start);
    v.optional("height", &Terrain::height);
    v.optional("length", &Terrain::length);
    v.optional("slope", &Terrain::slope);
    v.optional("radius", &Terrain::radius);
    v.optional("count", &Terrain::count);
    v.optional("seed", &Terrain::seed);
    v.optional("coverage", &Terrain::coverage);
    v.optional("sides", &Terrain::sides);
    v.optional("symmetric", &Terrain::symmetric);
    v.optional("cell", &Terrain::cell);
    v.optional("file", &Terrain::file);
    v.optional("units", &Terrain::units);
    v.optional("scale", &Terrain::scale);
    v.optional("up", &Terrain::up);
    v.optional("origin", &Terrain::origin);
    v.optional("terrains", &Terrain::terrains);
}

template <class V>
void describe(V& v, const SoilRegion*) {
    v.required("x", &SoilRegion::x);
    v.optional("y", &SoilRegion::y);
    v.required("friction", &SoilRegion::friction);
    v.required("rolling_resistance", &SoilRegion::rollingResistance);
}

template <class V>
void describe(V& v, const Soil*) {
    v.optional("friction", &Soil::friction);
    v.optional("rolling_resistance", &Soil::rollingResistance);
    v.optional("regions", &Soil::regions);
}

template <class V>
void describe(V& v, const Controller*) {
    v.required("kind", &Controller::kind);
    v.optional("speed", &Controller::speed);
    v.optional("turn", &Controller::turn);
    v.optional("steering", &Controller::steering);
    v.optional("heading_hold", &Controller::headingHold);
    v.optional("assumed_friction", &Controller::assumedFriction);
    v.optional("period", &Controller::period);
    v.optional("proportional", &Controller::proportional);
    v.optional("integral", &Controller::integral);
    v.optional("derivative", &Controller::derivative);
}

template <class V>
void describe(V& v, const SensorError*) {
    v.optional("noise", &SensorError::noise);
    v.optional("bias", &SensorError::bias);
    v.optional("delay", &SensorError::delay);
    v.optional("resolution", &SensorError::resolution);
}

template <class V>
void describe(V& v, const Sensors*) {
    v.optional("joint_encoder", &Sensors::jointEncoder);
    v.optional("wheel_rate", &Sensors::wheelRate);
    v.optional("orientation", &Sensors::orientation);
    v.optional("angular_rate", &Sensors::angularRate);
    v.optional("acceleration", &Sensors::acceleration);
    v.optional("tactile_force", &Sensors::tactileForce);
    v.optional("tactile_angle", &Sensors::tactileAngle);
    v.optional("body_speed", &Sensors::bodySpeed);
}

template <class V>
void describe(V& v, const RunSettings*) {
    v.optional("engine", &RunSettings::engine);
    v.optional("step", &RunSettings::step);
    v.optional("distance", &RunSettings::distance);
    v.optional("duration", &RunSettings::duration);
    v.optional("settle", &RunSettings::settle);
    v.optional("ramp", &RunSettings::ramp);
    v.optional("relaxed_joints", &RunSettings::relaxedJoints);
    v.optional("body_contacts", &RunSettings::bodyContacts);
    v.optional("seed", &RunSettings::seed);
}

template <class V>
void describe(V& v, const Scenario*) {
    v.required("name", &Scenario::name);
    v.optional("description", &Scenario::description);
    v.optional("variant", &Scenario::variant);
    v.required("terrain", &Scenario::terrain);
    v.optional("soil", &Scenario::soil);
    v.optional("controller", &Scenario::controller);
    v.optional("sensors", &Scenario::sensors);
    v.optional("run", &Scenario::run);
}

template <class V>
void describe(V& v, const Project*) {
    v.required("rover", &Project::rover);
    v.optional("variants", &Project::variants);
    v.optional("scenarios", &Project::scenarios);
}

}  // namespace simcore::project
