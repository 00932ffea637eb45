#include "simcore/io/statics_tables.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "simcore/io/json_format.h"

namespace simcore::io {
namespace {

using Json = nlohmann::ordered_json;
using statics::TraverseSample;

constexpr double kPerDegree = std::numbers::pi / 180.0;

/// The first wheel that limits; "" where nothing holds the rover.
std::string limitingWheel(const statics::Study& study) {
    const std::vector<int> wheels = limitingWheels(study);
    return wheels.empty() ? "" : study.wheels[static_cast<std::size_t>(wheels.front())].name;
}

Json toJson(const TraverseSample& sample) {
    return {{"way_m", sample.way},
            {"x_m", sample.distance},
            {"mu_required",
             sample.study.feasible ? numberOrNull(sample.study.frictionRequired) : Json()},
            {"wheel", limitingWheel(sample.study)}};
}

}  // namespace

Json toJson(const statics::Study& study) {
    Json json;
    json["equations"] = study.equations;
    json["internal_reactions"] = study.internalReactions;
    json["rows"] = study.rows;
    json["unknowns"] = study.unknowns;
    json["solution_dimension"] = study.dimension;
    json["feasible"] = study.feasible;
    json["flags"] = study.flags;
    json["equal_torque"] = nullptr;
    if (study.equalTorque) {
        json["equal_torque"] = {{"torque", *study.equalTorque},
                                {"max_ratio", numberOrNull(study.equalMaxRatio)}};
    }
    json["optimal"] = nullptr;
    if (study.feasible) {
        json["optimal"] = {{"mu_required", study.frictionRequired},
                           {"min_torque", study.minimumTorque},
                           {"min_energy",
                            {{"torque_squares", study.leastSquares},
                             {"max_ratio", numberOrNull(study.leastSquaresRatio)}}}};
    }
    json["tip_over_deg"] = study.tipOver / kPerDegree;
    json["rolling_conflict"] = study.rollingConflict;
    json["wheels"] = Json::array();
    for (const statics::WheelStudy& wheel : study.wheels) {
        json["wheels"].push_back({{"name", wheel.name},
                                  {"touches", wheel.touches},
                                  {"normal_force", wheel.normal},
                                  {"traction_force", wheel.traction},
                                  {"lateral_force", wheel.lateral},
                                  {"torque", wheel.torque},
                                  {"ratio", numberOrNull(wheel.ratio)},
                                  {"contact_angle_deg", wheel.contactAngle / kPerDegree}});
    }
    return json;
}

Json toJson(const mechanism::Mechanism& mechanism, const statics::StandingPose& pose) {
    Json json;
    json["standing"] = toString(pose.standing);
    if (pose.standing != statics::Standing::Stands) {
        return json;
    }
    const Pose& chassis = pose.bodies[static_cast<std::size_t>(mechanism.chassis)];
    json["x_m"] = chassis.position.x();
    json["y_m"] = chassis.position.y();
    json["z_m"] = chassis.position.z();
    json["roll_deg"] = roll(chassis) / kPerDegree;
    json["pitch_deg"] = pitch(chassis) / kPerDegree;
    json["joints"] = Json::array();
    for (const int joint : mechanism.encoderJoints()) {
        const mechanism::Joint& at = mechanism.joints[static_cast<std::size_t>(joint)];
        json["joints"].push_back(
            {{"name", at.name},
             {"angle_deg", mechanism::jointAngle(at, pose.bodies) / kPerDegree}});
    }
    json["footholds"] = Json::array();
    for (const statics::Foothold& foothold : pose.footholds) {
        const Vec3& point = foothold.contact.point;
        json["footholds"].push_back(
            {{"wheel", mechanism.wheels[static_cast<std::size_t>(foothold.contact.wheel)].name},
             {"point_m", {point.x(), point.y(), point.z()}},
             {"contact_angle_deg", foothold.angle / kPerDegree}});
    }
    return json;
}

Json toJson(const statics::Traverse& traverse) {
    Json json;
    json["end"] = toString(traverse.end);
    json["why"] = toString(traverse.why);
    json["samples"] = traverse.samples.size();
    json["mu_required"] = numberOrNull(traverse.frictionRequired());
    json["hardest"] =
        traverse.samples.empty() ? Json() : toJson(traverse.samples[traverse.hardest()]);
    json["events"] = Json::array();
    for (const TraverseSample& sample : traverse.samples) {
        if (!sample.events.empty()) {
            Json event = toJson(sample);
            event["events"] = sample.events;
            json["events"].push_back(std::move(event));
        }
    }
    return json;
}

Json toJson(const statics::Capability& capability) {
    return {{"step_m", capability.step},
            {"step_is_limit", capability.stepLimited},
            {"stair_m", capability.stair},
            {"stair_is_limit", capability.stairLimited},
            {"slope_deg", capability.slope / kPerDegree}};
}

std::string traverseTable(const mechanism::Mechanism& mechanism,
                          const statics::Traverse& traverse) {
    constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
    std::string text =
        "way [m],x [m],z [m],roll [rad],pitch [rad],climbs,feasible,mu_required [-],"
        "equal_torque [N m],equal_ratio [-],tip_over [rad],clearance [m],rolling_conflict [-],"
        "limiting_wheel";
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        text += fmt::format(
            ",contact_angle_{0} [rad],normal_{0} [N],traction_{0} [N],lateral_{0} [N],torque_{0} "
            "[N "
            "m],ratio_{0} [-]",
            wheel.name);
    }
    text += ",events\n";
    const auto cell = [](double value) {
        return std::isfinite(value) ? fmt::format("{}", value) : std::string();
    };
    for (const TraverseSample& sample : traverse.samples) {
        const statics::Study& study = sample.study;
        const Pose& chassis = sample.pose.bodies[static_cast<std::size_t>(mechanism.chassis)];
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}", sample.way,
                            sample.distance, chassis.position.z(), roll(chassis), pitch(chassis),
                            sample.climbs ? 1 : 0, study.feasible ? 1 : 0,
                            cell(study.feasible ? study.frictionRequired : kMissing),
                            cell(study.equalTorque.value_or(kMissing)),
                            cell(study.equalTorque ? study.equalMaxRatio : kMissing), study.tipOver,
                            sample.pose.clearance, study.rollingConflict, limitingWheel(study));
        for (const statics::WheelStudy& wheel : study.wheels) {
            const bool known = study.feasible && wheel.touches;
            const auto of = [&](double value) { return cell(known ? value : kMissing); };
            text += fmt::format(",{},{},{},{},{},{}",
                                cell(wheel.touches ? wheel.contactAngle : kMissing),
                                of(wheel.normal), of(wheel.traction), of(wheel.lateral),
                                of(wheel.torque), of(wheel.ratio));
        }
        text += fmt::format(",{}\n", fmt::join(sample.events, "; "));
    }
    return text;
}

}  // namespace simcore::io
