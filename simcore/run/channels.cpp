#include "simcore/run/channels.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "simcore/base/text.h"

namespace simcore::run {
namespace {

constexpr ChannelSource kKnown = ChannelSource::Known;
constexpr ChannelSource kMeasured = ChannelSource::Measured;
constexpr ChannelSource kOracle = ChannelSource::Oracle;

/// A channel of a kind of object: what it is called and where its value comes from. One table makes
/// both the list of channels and the rows, so that they cannot disagree.
template <class Source>
struct Column {
    const char* quantity;
    const char* label;
    const char* symbol;
    const char* unit;
    ChannelSource source;
    const char* meaning;
    double (*value)(const Source&);
};

struct ChassisSource {
    const Snapshot& snapshot;
    const Pose& pose;
};

struct WheelSource {
    const WheelState& state;
    const control::WheelSensors& measured;
    const control::Intent::Wheel& intent;
};

struct JointSource {
    const JointState& state;
    double measured;
};

constexpr std::array kChassis{
    Column<ChassisSource>{
        "x", Text::mark("Position x"), "x", "m", kOracle,
        Text::mark("World x (forward) of the rover frame's origin carried by the chassis."),
        [](const ChassisSource& s) { return s.pose.position.x(); }},
    Column<ChassisSource>{"y", Text::mark("Position y"), "y", "m", kOracle,
                          Text::mark("World y (left) of the same point."),
                          [](const ChassisSource& s) { return s.pose.position.y(); }},
    Column<ChassisSource>{"z", Text::mark("Position z"), "z", "m", kOracle,
                          Text::mark("World z (up) of the same point."),
                          [](const ChassisSource& s) { return s.pose.position.z(); }},
    Column<ChassisSource>{
        "roll", Text::mark("Roll"), "φ", "rad", kOracle,
        Text::mark("Turn of the chassis about its forward axis, positive right side down."),
        [](const ChassisSource& s) { return roll(s.pose); }},
    Column<ChassisSource>{
        "pitch", Text::mark("Pitch"), "θ", "rad", kOracle,
        Text::mark("Turn of the chassis about its left axis, positive nose down."),
        [](const ChassisSource& s) { return pitch(s.pose); }},
    Column<ChassisSource>{
        "yaw", Text::mark("Yaw"), "ψ", "rad", kOracle,
        Text::mark("Turn of the chassis about the vertical, positive to the left."),
        [](const ChassisSource& s) { return yaw(s.pose); }},
    Column<ChassisSource>{
        "speed", Text::mark("Speed"), "v", "m/s", kOracle,
        Text::mark("Speed of the chassis origin along the chassis' forward axis."),
        [](const ChassisSource& s) { return s.snapshot.speed; }},
    Column<ChassisSource>{"distance", Text::mark("Distance"), "d", "m", kOracle,
                          Text::mark("Way of the chassis origin along world x since the start."),
                          [](const ChassisSource& s) { return s.snapshot.distance; }},
    Column<ChassisSource>{"angular_rate_x", Text::mark("Angular rate x"), "ω_x", "rad/s", kOracle,
                          Text::mark("Angular velocity of the chassis about its own x axis."),
                          [](const ChassisSource& s) { return s.snapshot.angularRate.x(); }},
    Column<ChassisSource>{"angular_rate_y", Text::mark("Angular rate y"), "ω_y", "rad/s", kOracle,
                          Text::mark("Angular velocity of the chassis about its own y axis."),
                          [](const ChassisSource& s) { return s.snapshot.angularRate.y(); }},
    Column<ChassisSource>{"angular_rate_z", Text::mark("Angular rate z"), "ω_z", "rad/s", kOracle,
                          Text::mark("Angular velocity of the chassis about its own z axis."),
                          [](const ChassisSource& s) { return s.snapshot.angularRate.z(); }},
    Column<ChassisSource>{"center_of_mass_x", Text::mark("Centre of mass x"), "x_G", "m", kOracle,
                          Text::mark("World x of the centre of mass of the whole rover."),
                          [](const ChassisSource& s) { return s.snapshot.centerOfMass.x(); }},
    Column<ChassisSource>{"center_of_mass_y", Text::mark("Centre of mass y"), "y_G", "m", kOracle,
                          Text::mark("World y of the centre of mass of the whole rover."),
                          [](const ChassisSource& s) { return s.snapshot.centerOfMass.y(); }},
    Column<ChassisSource>{"center_of_mass_z", Text::mark("Centre of mass z"), "z_G", "m", kOracle,
                          Text::mark("World z of the centre of mass of the whole rover."),
                          [](const ChassisSource& s) { return s.snapshot.centerOfMass.z(); }},
    Column<ChassisSource>{"measured_speed", Text::mark("Speed (measured)"), "v", "m/s", kMeasured,
                          Text::mark("Body speed as the controller last read it."),
                          [](const ChassisSource& s) { return s.snapshot.measured.bodySpeed; }},
    Column<ChassisSource>{"measured_roll", Text::mark("Roll (measured)"), "φ", "rad", kMeasured,
                          Text::mark("Roll of the inertial unit as last read."),
                          [](const ChassisSource& s) { return s.snapshot.measured.imu.roll; }},
    Column<ChassisSource>{"measured_pitch", Text::mark("Pitch (measured)"), "θ", "rad", kMeasured,
                          Text::mark("Pitch of the inertial unit as last read."),
                          [](const ChassisSource& s) { return s.snapshot.measured.imu.pitch; }},
    Column<ChassisSource>{
        "measured_angular_rate_x", Text::mark("Angular rate x (measured)"), "ω_x", "rad/s",
        kMeasured, Text::mark("Angular rate about the chassis' x axis as last read."),
        [](const ChassisSource& s) { return s.snapshot.measured.imu.angularRate.x(); }},
    Column<ChassisSource>{
        "measured_angular_rate_y", Text::mark("Angular rate y (measured)"), "ω_y", "rad/s",
        kMeasured, Text::mark("Angular rate about the chassis' y axis as last read."),
        [](const ChassisSource& s) { return s.snapshot.measured.imu.angularRate.y(); }},
    Column<ChassisSource>{
        "measured_angular_rate_z", Text::mark("Angular rate z (measured)"), "ω_z", "rad/s",
        kMeasured, Text::mark("Angular rate about the chassis' z axis as last read."),
        [](const ChassisSource& s) { return s.snapshot.measured.imu.angularRate.z(); }},
    Column<ChassisSource>{
        "measured_acceleration_x", Text::mark("Acceleration x (measured)"), "a_x", "m/s^2",
        kMeasured, Text::mark("Acceleration less gravity along the chassis' x axis as last read."),
        [](const ChassisSource& s) { return s.snapshot.measured.imu.acceleration.x(); }},
    Column<ChassisSource>{
        "measured_acceleration_y", Text::mark("Acceleration y (measured)"), "a_y", "m/s^2",
        kMeasured, Text::mark("Acceleration less gravity along the chassis' y axis as last read."),
        [](const ChassisSource& s) { return s.snapshot.measured.imu.acceleration.y(); }},
    Column<ChassisSource>{
        "measured_acceleration_z", Text::mark("Acceleration z (measured)"), "a_z", "m/s^2",
        kMeasured, Text::mark("Acceleration less gravity along the chassis' z axis as last read."),
        [](const ChassisSource& s) { return s.snapshot.measured.imu.acceleration.z(); }},
    Column<ChassisSource>{
        "common_torque", Text::mark("Torque of the speed loop"), "M_c", "N*m", kKnown,
        Text::mark("What the loop on the body's speed asks of a wheel with the mean load; "
                   "missing where the controller has no such loop."),
        [](const ChassisSource& s) { return s.snapshot.intent.commonTorque; }},
    Column<ChassisSource>{
        "required_friction", Text::mark("Required friction (planned)"), "μ*", "-", kKnown,
        Text::mark("Largest ratio of tangential to normal force with the planned torques, by the "
                   "controller's "
                   "quasi-static model; missing where it has none."),
        [](const ChassisSource& s) { return s.snapshot.intent.requiredFriction; }},
    Column<ChassisSource>{
        "friction_cap", Text::mark("Friction trusted"), "μ_cap", "-", kKnown,
        Text::mark(
            "Friction that the controller trusts the ground with: assumed, or learned from slip; "
            "missing where it sets no such limit."),
        [](const ChassisSource& s) { return s.snapshot.intent.frictionCap; }},
};

constexpr std::array kWheel{
    Column<WheelSource>{
        "slip_abs", Text::mark("Slip (absolute)"), "s_abs", "m", kOracle,
        Text::mark("Sum of the absolute slip of consecutive 20 ms windows since counting began."),
        [](const WheelSource& w) { return w.state.slipAbs; }},
    Column<WheelSource>{
        "slip_loaded", Text::mark("Slip (loaded)"), "s_N", "m", kOracle,
        Text::mark(
            "The same of the time in which the wheel carries load: free flight is not in it."),
        [](const WheelSource& w) { return w.state.slipLoaded; }},
    Column<WheelSource>{
        "slip_signed", Text::mark("Slip (signed)"), "s", "m", kOracle,
        Text::mark("Sum of wheel-centre travel minus turn times effective radius; negative "
                   "when the wheel spins."),
        [](const WheelSource& w) { return w.state.slipSigned; }},
    Column<WheelSource>{
        "slip_ratio", Text::mark("Slip ratio"), "λ", "-", kOracle,
        Text::mark("(wR - v) / max(abs(wR), abs(v), 0.01 m/s): positive when the wheel spins."),
        [](const WheelSource& w) { return w.state.slipRatio; }},
    Column<WheelSource>{
        "slip_lateral", Text::mark("Slip (lateral)"), "s_lat", "m", kOracle,
        Text::mark(
            "Sum of the absolute motion of the wheel centre along the axle since counting began."),
        [](const WheelSource& w) { return w.state.slipLateral; }},
    Column<WheelSource>{
        "friction_work", Text::mark("Friction work"), "W_μ", "J", kOracle,
        Text::mark("Energy that friction took where the wheel slid since counting began."),
        [](const WheelSource& w) { return w.state.frictionWork; }},
    Column<WheelSource>{
        "torque_commanded", Text::mark("Torque (commanded)"), "τ_c", "N*m", kKnown,
        Text::mark("Motor torque the controller asked for, positive drives forward."),
        [](const WheelSource& w) { return w.state.torqueCommanded; }},
    Column<WheelSource>{"torque_applied", Text::mark("Torque (applied)"), "τ", "N*m", kKnown,
                        Text::mark("Motor torque after the motor's torque and speed limits."),
                        [](const WheelSource& w) { return w.state.torqueApplied; }},
    Column<WheelSource>{
        "power", Text::mark("Power"), "P", "W", kOracle,
        Text::mark("Applied torque times the wheel's rate against its carrier, negative when "
                   "the motor brakes."),
        [](const WheelSource& w) { return w.state.power; }},
    Column<WheelSource>{"normal_force", Text::mark("Normal force"), "N", "N", kOracle,
                        Text::mark("Force of the ground on the wheel along the contact normal."),
                        [](const WheelSource& w) { return w.state.normalForce; }},
    Column<WheelSource>{
        "traction_force", Text::mark("Traction force"), "T_x", "N", kOracle,
        Text::mark(
            "Force of the ground on the wheel along the rolling direction, positive forward."),
        [](const WheelSource& w) { return w.state.tractionForce; }},
    Column<WheelSource>{
        "lateral_force", Text::mark("Lateral force"), "T_y", "N", kOracle,
        Text::mark("Force of the ground on the wheel along the axle, positive to the left."),
        [](const WheelSource& w) { return w.state.lateralForce; }},
    Column<WheelSource>{
        "force_x", Text::mark("Contact force x"), "F_x", "N", kOracle,
        Text::mark("World x component of the whole force of the ground on the wheel."),
        [](const WheelSource& w) { return w.state.force.x(); }},
    Column<WheelSource>{"force_y", Text::mark("Contact force y"), "F_y", "N", kOracle,
                        Text::mark("World y component of the same force."),
                        [](const WheelSource& w) { return w.state.force.y(); }},
    Column<WheelSource>{"force_z", Text::mark("Contact force z"), "F_z", "N", kOracle,
                        Text::mark("World z component of the same force."),
                        [](const WheelSource& w) { return w.state.force.z(); }},
    Column<WheelSource>{
        "contact_angle", Text::mark("Contact angle"), "γ", "rad", kOracle,
        Text::mark("Angle in the wheel plane from world up to the contact normal, positive "
                   "when the obstacle is ahead; held while the wheel is in the air."),
        [](const WheelSource& w) { return w.state.contactAngle; }},
    Column<WheelSource>{
        "penetration", Text::mark("Penetration"), "δ", "m", kOracle,
        Text::mark("How far the wheel's deepest contact lies in the ground; 0 without contact."),
        [](const WheelSource& w) { return w.state.penetration; }},
    Column<WheelSource>{"rate", Text::mark("Wheel rate"), "ω", "rad/s", kOracle,
                        Text::mark("Absolute rotation rate of the wheel, positive forward."),
                        [](const WheelSource& w) { return w.state.rate; }},
    Column<WheelSource>{"center_speed", Text::mark("Wheel speed"), "v_w", "m/s", kOracle,
                        Text::mark("Speed of the wheel centre along the contact tangent."),
                        [](const WheelSource& w) { return w.state.centerSpeed; }},
    Column<WheelSource>{
        "measured_rate", Text::mark("Wheel rate (measured)"), "ω", "rad/s", kMeasured,
        Text::mark("Rate of the wheel against its carrier as the controller last read it."),
        [](const WheelSource& w) { return w.measured.rate; }},
    Column<WheelSource>{"measured_normal_force", Text::mark("Normal force (measured)"), "N", "N",
                        kMeasured, Text::mark("Normal force of the tactile wheel as last read."),
                        [](const WheelSource& w) { return w.measured.normalForce; }},
    Column<WheelSource>{"measured_contact_angle", Text::mark("Contact angle (measured)"), "γ",
                        "rad", kMeasured,
                        Text::mark("Contact angle of the tactile wheel as last read."),
                        [](const WheelSource& w) { return w.measured.contactAngle; }},
    Column<WheelSource>{
        "torque_planned", Text::mark("Torque (planned)"), "τ*", "N*m", kKnown,
        Text::mark("Torque of least required friction by the controller's quasi-static "
                   "model, before its speed loop and caps."),
        [](const WheelSource& w) { return w.intent.torque; }},
    Column<WheelSource>{"normal_force_planned", Text::mark("Normal force (planned)"), "N*", "N",
                        kKnown, Text::mark("Load that those torques make by the same model."),
                        [](const WheelSource& w) { return w.intent.normalForce; }},
    Column<WheelSource>{"rate_planned", Text::mark("Wheel rate (planned)"), "ω*", "rad/s", kKnown,
                        Text::mark("Rate of the wheel that the controller aims at."),
                        [](const WheelSource& w) { return w.intent.rate; }},
};

constexpr std::array kJoint{
    Column<JointSource>{
        "joint_angle", Text::mark("Joint angle"), "q", "rad", kOracle,
        Text::mark("Turn of the joint's second body against the first, 0 at the drawn pose."),
        [](const JointSource& j) { return j.state.angle; }},
    Column<JointSource>{"joint_rate", Text::mark("Joint rate"), "q'", "rad/s", kOracle,
                        Text::mark("Rate of that turn."),
                        [](const JointSource& j) { return j.state.rate; }},
    Column<JointSource>{
        "measured_joint_angle", Text::mark("Joint angle (measured)"), "q", "rad", kMeasured,
        Text::mark("Turn of the joint by its encoder as the controller last read it."),
        [](const JointSource& j) { return j.measured; }},
};

template <class Source>
Channel channelOf(const Column<Source>& column, const std::string& object, ChannelGroup group) {
    return {column.quantity, object,         column.label, column.symbol,
            column.unit,     column.meaning, group,        column.source};
}

/// Values of every column, or as many NaN where there is nothing to take them from.
template <class Source, std::size_t N>
void append(const std::array<Column<Source>, N>& columns, const Source* source,
            std::vector<double>& row) {
    for (const Column<Source>& column : columns) {
        row.push_back(source != nullptr ? column.value(*source)
                                        : std::numeric_limits<double>::quiet_NaN());
    }
}

}  // namespace

std::string toString(ChannelGroup group) {
    switch (group) {
        case ChannelGroup::Time:
            return "time";
        case ChannelGroup::Chassis:
            return "chassis";
        case ChannelGroup::Wheel:
            return "wheel";
        case ChannelGroup::Joint:
            return "joint";
    }
    return "unknown";
}

std::string toString(ChannelSource source) {
    switch (source) {
        case ChannelSource::Known:
            return "known";
        case ChannelSource::Measured:
            return "measured";
        case ChannelSource::Oracle:
            return "oracle";
    }
    return "unknown";
}

std::string Channel::id() const {
    return quantity + (object.empty() ? "" : "_" + object);
}

std::string Channel::column() const {
    return id() + " [" + unit + "]";
}

std::vector<Channel> makeChannels(const mechanism::Mechanism& mechanism) {
    std::vector<Channel> channels;
    channels.push_back({"time", "", Text::mark("Time"), "t", "s",
                        Text::mark("Simulated time since the start of the run."),
                        ChannelGroup::Time, ChannelSource::Known});
    for (const auto& column : kChassis) {
        channels.push_back(channelOf(column, "chassis", ChannelGroup::Chassis));
    }
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        for (const auto& column : kWheel) {
            channels.push_back(channelOf(column, wheel.name, ChannelGroup::Wheel));
        }
    }
    for (const int joint : mechanism.encoderJoints()) {
        for (const auto& column : kJoint) {
            const std::string& name = mechanism.joints[static_cast<std::size_t>(joint)].name;
            channels.push_back(channelOf(column, name, ChannelGroup::Joint));
        }
    }
    return channels;
}

void sampleChannels(const mechanism::Mechanism& mechanism, const Snapshot& snapshot,
                    std::vector<double>& row) {
    const auto chassis = static_cast<std::size_t>(mechanism.chassis);
    if (chassis >= snapshot.bodies.size()) {
        throw std::invalid_argument("sampleChannels: the snapshot has no such chassis body");
    }
    row.clear();
    row.push_back(snapshot.time);
    const ChassisSource body{snapshot, snapshot.bodies[chassis]};
    append(kChassis, &body, row);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        static constexpr control::WheelSensors kUnread{kNone, kNone, kNone};
        static constexpr control::Intent::Wheel kNoIntent;
        const auto& measured = snapshot.measured.wheels;
        const auto& intents = snapshot.intent.wheels;
        if (i < snapshot.wheels.size()) {
            const WheelSource wheel{snapshot.wheels[i], i < measured.size() ? measured[i] : kUnread,
                                    i < intents.size() ? intents[i] : kNoIntent};
            append(kWheel, &wheel, row);
        } else {
            append<WheelSource>(kWheel, nullptr, row);
        }
    }
    const std::size_t encoders = mechanism.encoderJoints().size();
    for (std::size_t i = 0; i < encoders; ++i) {
        const auto& measured = snapshot.measured.joints;
        if (i < snapshot.joints.size()) {
            const JointSource joint{snapshot.joints[i], i < measured.size() ? measured[i] : kNone};
            append(kJoint, &joint, row);
        } else {
            append<JointSource>(kJoint, nullptr, row);
        }
    }
}

int findChannel(const std::vector<Channel>& channels, const std::string& quantity,
                const std::string& object) {
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (channels[i].quantity == quantity && channels[i].object == object) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

std::string channelTable() {
    mechanism::Mechanism any;
    any.wheels.emplace_back().name = "WHEEL";
    mechanism::Joint& joint = any.joints.emplace_back();
    joint.name = "JOINT";
    joint.built.push_back({mechanism::FreedomKind::Turn, joint.axis});
    std::string text =
        "| column | name on screen | symbol | source | meaning |\n| --- | --- | --- | --- | --- "
        "|\n";
    for (const Channel& channel : makeChannels(any)) {
        text += "| `" + channel.column() + "` | " + channel.label + " | `" + channel.symbol +
                "` | " + toString(channel.source) + " | " + channel.meaning + " |\n";
    }
    return text;
}

}  // namespace simcore::run
