#include "simcore/io/run_report_json.h"

#include <cmath>
#include <type_traits>

#include "simcore/io/json_format.h"
#include "simcore/io/recording_header.h"

namespace simcore::io {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const run::WheelReport& wheel) {
    Json json;
    json["name"] = wheel.name;
    json["slip_abs_m"] = numberOrNull(wheel.slipAbs);
    json["slip_loaded_m"] = numberOrNull(wheel.slipLoaded);
    json["slip_signed_m"] = numberOrNull(wheel.slipSigned);
    json["slip_lateral_m"] = numberOrNull(wheel.slipLateral);
    json["friction_work_J"] = numberOrNull(wheel.frictionWork);
    json["mean_normal_force_N"] = numberOrNull(wheel.meanNormalForce);
    json["max_torque_Nm"] = numberOrNull(wheel.maxTorque);
    json["energy_J"] = numberOrNull(wheel.energy);
    json["air_time_s"] = numberOrNull(wheel.airTime);
    return json;
}

Json toJson(const run::BodyReport& body) {
    Json json;
    json["name"] = body.name;
    json["contact_time_s"] = numberOrNull(body.contactTime);
    json["max_force_N"] = numberOrNull(body.maxForce);
    json["friction_work_J"] = numberOrNull(body.frictionWork);
    return json;
}

/// Takes a value when it is there and of the right kind.
template <class T>
void take(const nlohmann::json& json, const char* key, T& value) {
    const auto found = json.find(key);
    if (found == json.end()) {
        return;
    }
    if constexpr (std::is_same_v<T, std::string>) {
        value = found->is_string() ? found->template get<T>() : value;
    } else if constexpr (std::is_same_v<T, bool>) {
        value = found->is_boolean() ? found->template get<T>() : value;
    } else if constexpr (std::is_same_v<T, long>) {
        value = found->is_number_integer() ? found->template get<T>() : value;
    } else {
        value = found->is_number() ? found->template get<T>() : value;
    }
}

run::StopReason reasonFrom(const std::string& name) {
    using run::StopReason;
    for (const StopReason reason :
         {StopReason::Running, StopReason::Completed, StopReason::TimeUp, StopReason::Stuck,
          StopReason::NonFinite, StopReason::SingularPose}) {
        if (run::toString(reason) == name) {
            return reason;
        }
    }
    return StopReason::Stopped;
}

run::WheelReport wheelFrom(const nlohmann::json& json) {
    run::WheelReport wheel;
    take(json, "name", wheel.name);
    take(json, "slip_abs_m", wheel.slipAbs);
    take(json, "slip_loaded_m", wheel.slipLoaded);
    take(json, "slip_signed_m", wheel.slipSigned);
    take(json, "slip_lateral_m", wheel.slipLateral);
    take(json, "friction_work_J", wheel.frictionWork);
    take(json, "mean_normal_force_N", wheel.meanNormalForce);
    take(json, "max_torque_Nm", wheel.maxTorque);
    take(json, "energy_J", wheel.energy);
    take(json, "air_time_s", wheel.airTime);
    return wheel;
}

run::BodyReport bodyFrom(const nlohmann::json& json) {
    run::BodyReport body;
    take(json, "name", body.name);
    take(json, "contact_time_s", body.contactTime);
    take(json, "max_force_N", body.maxForce);
    take(json, "friction_work_J", body.frictionWork);
    return body;
}

/// The entries of an array, when it is there: at most as many as a recording may have.
template <class Report, class Read>
void takeAll(const nlohmann::json& json, const char* key, const Read& read,
             std::vector<Report>& reports) {
    const auto list = json.find(key);
    if (list == json.end() || !list->is_array()) {
        return;
    }
    for (const auto& entry : *list) {
        if (reports.size() >= kMostParts) {
            break;
        }
        reports.push_back(read(entry));
    }
}

}  // namespace

run::RunReport parseReport(const std::string& text) {
    run::RunReport report;
    report.stopReason = run::StopReason::Stopped;
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object()) {
        return report;
    }
    take(json, "engine", report.engine);
    take(json, "scenario", report.scenario);
    take(json, "dt", report.step);
    take(json, "steps", report.steps);
    take(json, "sim_time_s", report.simTime);
    take(json, "wall_s", report.wallTime);
    take(json, "rtf", report.rtf);
    take(json, "completed", report.completed);
    std::string reason;
    take(json, "stop_reason", reason);
    report.stopReason = reasonFrom(reason);
    take(json, "stop_detail", report.stopDetail);
    take(json, "distance_m", report.distance);
    take(json, "slip_abs_m", report.slipAbs);
    take(json, "slip_loaded_m", report.slipLoaded);
    take(json, "slip_signed_m", report.slipSigned);
    take(json, "friction_work_J", report.frictionWork);
    takeAll(json, "wheels", wheelFrom, report.wheels);
    takeAll(json, "body_contacts", bodyFrom, report.bodies);
    take(json, "energy_J", report.energy);
    take(json, "state_hash", report.stateHash);
    take(json, "friction_violation_pct", report.frictionViolationPercent);
    take(json, "friction_worst_pct", report.frictionWorstPercent);
    take(json, "loop_error_max_mm", report.loopErrorMax);
    take(json, "penetration_max_mm", report.penetrationMax);
    report.loopErrorMax *= 1e-3;
    report.penetrationMax *= 1e-3;
    take(json, "solves_per_step", report.solvesPerStep);
    take(json, "solver_messages", report.solverMessages);
    take(json, "fallbacks", report.fallbacks);
    take(json, "contact_residual_max_N", report.contactResidualMax);
    take(json, "divided_steps", report.dividedSteps);
    take(json, "joint_choices", report.jointChoices);
    take(json, "pivot_ratio_min", report.pivotRatioMin);
    if (const auto warnings = json.find("warnings");
        warnings != json.end() && warnings->is_array()) {
        for (const auto& warning : *warnings) {
            if (warning.is_string() && report.warnings.size() < kMostParts) {
                report.warnings.push_back(warning.get<std::string>());
            }
        }
    }
    return report;
}

Json toJson(const run::RunReport& report) {
    Json json;
    json["engine"] = report.engine;
    json["scenario"] = report.scenario;
    json["dt"] = numberOrNull(report.step);
    json["steps"] = report.steps;
    json["sim_time_s"] = numberOrNull(report.simTime);
    json["wall_s"] = numberOrNull(report.wallTime);
    json["rtf"] = numberOrNull(report.rtf);
    json["completed"] = report.completed;
    json["stop_reason"] = toString(report.stopReason);
    json["stop_detail"] = report.stopDetail;
    json["distance_m"] = numberOrNull(report.distance);
    json["slip_abs_m"] = numberOrNull(report.slipAbs);
    json["slip_loaded_m"] = numberOrNull(report.slipLoaded);
    json["slip_signed_m"] = numberOrNull(report.slipSigned);
    json["friction_work_J"] = numberOrNull(report.frictionWork);
    json["wheels"] = Json::array();
    for (const run::WheelReport& wheel : report.wheels) {
        json["wheels"].push_back(toJson(wheel));
    }
    json["body_contacts"] = Json::array();
    for (const run::BodyReport& body : report.bodies) {
        json["body_contacts"].push_back(toJson(body));
    }
    json["energy_J"] = numberOrNull(report.energy);
    json["state_hash"] = report.stateHash;
    json["friction_violation_pct"] = numberOrNull(report.frictionViolationPercent);
    json["friction_worst_pct"] = numberOrNull(report.frictionWorstPercent);
    json["loop_error_max_mm"] = numberOrNull(1e3 * report.loopErrorMax);
    json["penetration_max_mm"] = numberOrNull(1e3 * report.penetrationMax);
    json["solves_per_step"] = numberOrNull(report.solvesPerStep);
    json["solver_messages"] = report.solverMessages;
    json["fallbacks"] = report.fallbacks;
    json["contact_residual_max_N"] = numberOrNull(report.contactResidualMax);
    json["divided_steps"] = report.dividedSteps;
    json["joint_choices"] = report.jointChoices;
    json["pivot_ratio_min"] = numberOrNull(report.pivotRatioMin);
    json["warnings"] = report.warnings;
    return json;
}

}  // namespace simcore::io
