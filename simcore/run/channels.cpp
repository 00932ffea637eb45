#include "simcore/run/channels.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace simcore::run {
namespace {

/// A chassis or wheel channel: what it is called and where its value comes from. One table makes
/// both the list of channels and the rows, so that they cannot disagree.
template <class Source>
struct Column {
    const char* quantity;
    const char* label;
    const char* unit;
    const char* meaning;
    double (*value)(const Source&);
};

struct ChassisSource {
    const Snapshot& snapshot;
    const Pose& pose;
};

double element(const Pose& pose, int row, int column) {
    return pose.rotation.toRotationMatrix()(row, column);
}

// Yaw about z, then pitch about the turned y, then roll about the turned x: R = Rz Ry Rx.
double roll(const Pose& pose) {
    return std::atan2(element(pose, 2, 1), element(pose, 2, 2));
}

double pitch(const Pose& pose) {
    return std::atan2(-element(pose, 2, 0), std::hypot(element(pose, 0, 0), element(pose, 1, 0)));
}

double yaw(const Pose& pose) {
    return std::atan2(element(pose, 1, 0), element(pose, 0, 0));
}

constexpr std::array kChassis{
    Column<ChassisSource>{"x", "Position x", "m",
                          "World x (forward) of the rover frame's origin carried by the chassis.",
                          [](const ChassisSource& s) { return s.pose.position.x(); }},
    Column<ChassisSource>{"y", "Position y", "m", "World y (left) of the same point.",
                          [](const ChassisSource& s) { return s.pose.position.y(); }},
    Column<ChassisSource>{"z", "Position z", "m", "World z (up) of the same point.",
                          [](const ChassisSource& s) { return s.pose.position.z(); }},
    Column<ChassisSource>{"roll", "Roll", "rad",
                          "Turn of the chassis about its forward axis, positive right side down.",
                          [](const ChassisSource& s) { return roll(s.pose); }},
    Column<ChassisSource>{"pitch", "Pitch", "rad",
                          "Turn of the chassis about its left axis, positive nose down.",
                          [](const ChassisSource& s) { return pitch(s.pose); }},
    Column<ChassisSource>{"yaw", "Yaw", "rad",
                          "Turn of the chassis about the vertical, positive to the left.",
                          [](const ChassisSource& s) { return yaw(s.pose); }},
    Column<ChassisSource>{"speed", "Speed", "m/s",
                          "Speed of the chassis origin along the chassis' forward axis.",
                          [](const ChassisSource& s) { return s.snapshot.speed; }},
    Column<ChassisSource>{"distance", "Distance", "m",
                          "Way of the chassis origin along world x since the start.",
                          [](const ChassisSource& s) { return s.snapshot.distance; }},
};

constexpr std::array kWheel{
    Column<WheelState>{
        "slip_abs", "Slip (absolute)", "m",
        "Sum of the absolute slip of consecutive 20 ms windows since counting began.",
        [](const WheelState& w) { return w.slipAbs; }},
    Column<WheelState>{
        "slip_signed", "Slip (signed)", "m",
        "Sum of wheel-centre travel minus turn times effective radius; negative when "
        "the wheel spins.",
        [](const WheelState& w) { return w.slipSigned; }},
    Column<WheelState>{"slip_ratio", "Slip ratio", "-",
                       "(wR - v) / max(abs(wR), abs(v), 0.01 m/s): positive when the wheel spins.",
                       [](const WheelState& w) { return w.slipRatio; }},
    Column<WheelState>{
        "slip_lateral", "Slip (lateral)", "m",
        "Sum of the absolute motion of the wheel centre along the axle since counting began.",
        [](const WheelState& w) { return w.slipLateral; }},
    Column<WheelState>{"torque_commanded", "Torque (commanded)", "N*m",
                       "Motor torque the controller asked for, positive drives forward.",
                       [](const WheelState& w) { return w.torqueCommanded; }},
    Column<WheelState>{"torque_applied", "Torque (applied)", "N*m",
                       "Motor torque after the motor's torque and speed limits.",
                       [](const WheelState& w) { return w.torqueApplied; }},
    Column<WheelState>{"normal_force", "Normal force", "N",
                       "Force of the ground on the wheel along the contact normal.",
                       [](const WheelState& w) { return w.normalForce; }},
    Column<WheelState>{"traction_force", "Traction force", "N",
                       "Force of the ground on the wheel along the rolling direction, positive "
                       "forward.",
                       [](const WheelState& w) { return w.tractionForce; }},
    Column<WheelState>{"lateral_force", "Lateral force", "N",
                       "Force of the ground on the wheel along the axle, positive to the left.",
                       [](const WheelState& w) { return w.lateralForce; }},
    Column<WheelState>{
        "contact_angle", "Contact angle", "rad",
        "Angle in the wheel plane from world up to the contact normal, positive when "
        "the obstacle is ahead; held while the wheel is in the air.",
        [](const WheelState& w) { return w.contactAngle; }},
    Column<WheelState>{"rate", "Wheel rate", "rad/s",
                       "Absolute rotation rate of the wheel, positive forward.",
                       [](const WheelState& w) { return w.rate; }},
    Column<WheelState>{"center_speed", "Wheel speed", "m/s",
                       "Speed of the wheel centre along the contact tangent.",
                       [](const WheelState& w) { return w.centerSpeed; }},
};

template <class Source>
Channel channelOf(const Column<Source>& column, const std::string& object) {
    return {column.quantity, object, column.label, column.unit, column.meaning};
}

}  // namespace

std::string Channel::column() const {
    return quantity + (object.empty() ? "" : "_" + object) + " [" + unit + "]";
}

std::vector<Channel> makeChannels(const mechanism::Mechanism& mechanism) {
    std::vector<Channel> channels;
    channels.push_back({"time", "", "Time", "s", "Simulated time since the start of the run."});
    for (const auto& column : kChassis) {
        channels.push_back(channelOf(column, "chassis"));
    }
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        for (const auto& column : kWheel) {
            channels.push_back(channelOf(column, wheel.name));
        }
    }
    return channels;
}

void sampleChannels(const Snapshot& snapshot, std::vector<double>& row, int chassis) {
    if (chassis < 0 || static_cast<std::size_t>(chassis) >= snapshot.bodies.size()) {
        throw std::invalid_argument("sampleChannels: the snapshot has no such chassis body");
    }
    row.clear();
    row.reserve(1 + kChassis.size() + kWheel.size() * snapshot.wheels.size());
    row.push_back(snapshot.time);
    const ChassisSource source{snapshot, snapshot.bodies[static_cast<std::size_t>(chassis)]};
    for (const auto& column : kChassis) {
        row.push_back(column.value(source));
    }
    for (const WheelState& wheel : snapshot.wheels) {
        for (const auto& column : kWheel) {
            row.push_back(column.value(wheel));
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

}  // namespace simcore::run
