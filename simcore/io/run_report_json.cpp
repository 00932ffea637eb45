#include "simcore/io/run_report_json.h"

#include <cmath>

namespace simcore::io {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json toJson(const run::WheelReport& wheel) {
    Json json;
    json["name"] = wheel.name;
    json["slip_abs_m"] = number(wheel.slipAbs);
    json["slip_signed_m"] = number(wheel.slipSigned);
    json["slip_lateral_m"] = number(wheel.slipLateral);
    json["mean_normal_force_N"] = number(wheel.meanNormalForce);
    json["max_torque_Nm"] = number(wheel.maxTorque);
    json["energy_J"] = number(wheel.energy);
    json["air_time_s"] = number(wheel.airTime);
    return json;
}

}  // namespace

Json toJson(const run::RunReport& report) {
    Json json;
    json["engine"] = report.engine;
    json["scenario"] = report.scenario;
    json["dt"] = number(report.step);
    json["steps"] = report.steps;
    json["sim_time_s"] = number(report.simTime);
    json["wall_s"] = number(report.wallTime);
    json["rtf"] = number(report.rtf);
    json["completed"] = report.completed;
    json["stop_reason"] = toString(report.stopReason);
    json["stop_detail"] = report.stopDetail;
    json["distance_m"] = number(report.distance);
    json["slip_abs_m"] = number(report.slipAbs);
    json["slip_signed_m"] = number(report.slipSigned);
    json["wheels"] = Json::array();
    for (const run::WheelReport& wheel : report.wheels) {
        json["wheels"].push_back(toJson(wheel));
    }
    json["energy_J"] = number(report.energy);
    json["state_hash"] = report.stateHash;
    json["friction_violation_pct"] = number(report.frictionViolationPercent);
    json["friction_worst_pct"] = number(report.frictionWorstPercent);
    json["loop_error_max_mm"] = number(1e3 * report.loopErrorMax);
    json["penetration_max_mm"] = number(1e3 * report.penetrationMax);
    json["solves_per_step"] = number(report.solvesPerStep);
    json["solver_messages"] = report.solverMessages;
    return json;
}

}  // namespace simcore::io
