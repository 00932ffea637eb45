#include "simcore/io/experiment_json.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "simcore/base/text.h"
#include "simcore/io/json_format.h"
#include "simcore/io/project_file.h"
#include "simcore/io/recording_header.h"
#include "simcore/project/names.h"

namespace simcore::io {
namespace {

using experiment::Case;
using experiment::Comparison;
using experiment::Outcome;
using experiment::Plan;
using Json = nlohmann::ordered_json;

/// The numbers of an outcome and what they are called.
constexpr std::pair<const char*, double Outcome::*> kNumbers[] = {
    {"mu_static", &Outcome::staticFriction},
    {"slip_abs_m", &Outcome::slipAbs},
    {"slip_loaded_m", &Outcome::slipLoaded},
    {"slip_signed_m", &Outcome::slipSigned},
    {"friction_work_J", &Outcome::frictionWork},
    {"energy_J", &Outcome::energy},
    {"peak_torque_Nm", &Outcome::peakTorque},
    {"time_s", &Outcome::time},
    {"end_x_m", &Outcome::endX},
    {"end_y_m", &Outcome::endY}};

constexpr std::pair<const char*, Comparison::Measure Comparison::*> kMeasures[] = {
    {"", &Comparison::slip},
    {"loaded_", &Comparison::loadedSlip},
    {"work_", &Comparison::work},
    {"energy_", &Comparison::energy}};

Json toJson(const Case& what) {
    Json json;
    json["seed"] = what.seed;
    json["mu"] = what.friction;
    json["controller"] = project::nameOf(what.controller);
    return json;
}

Json toJson(const Outcome& outcome) {
    Json json = toJson(outcome.ran);
    json["completed"] = outcome.completed;
    json["stop_reason"] = outcome.stopReason;
    for (const auto& [name, member] : kNumbers) {
        json[name] = numberOrNull(outcome.*member);
    }
    json["state_hash"] = outcome.stateHash;
    return json;
}

Json toJson(const Comparison& comparison) {
    Json json;
    json["mu"] = comparison.friction;
    json["grounds"] = toString(comparison.grounds);
    json["controller"] = project::nameOf(comparison.controller);
    json["rival"] = project::nameOf(comparison.rival);
    json["tried"] = comparison.tried;
    json["pairs"] = comparison.pairs;
    json["valid"] = comparison.valid;
    json["only_controller_completed"] = comparison.onlyOwn;
    json["only_rival_completed"] = comparison.onlyRival;
    for (const auto& [prefix, member] : kMeasures) {
        const Comparison::Measure& measure = comparison.*member;
        const std::string start = prefix;
        json[start + "wins"] = measure.wins;
        json[start + "ties"] = measure.ties;
        json[start + "mean_ratio"] = measure.meanRatio > 0.0 ? Json(measure.meanRatio) : Json();
        json[start + "ci95"] =
            measure.low > 0.0 ? Json::array({measure.low, measure.high}) : Json();
    }
    return json;
}

Json toJson(const Plan& plan) {
    Json json;
    json["set"] = toString(plan.set);
    json["seeds"] = Json::array({plan.firstSeed, plan.lastSeed});
    json["mu"] = plan.frictions;
    Json controllers = Json::array();
    for (const project::ControllerKind controller : plan.controllers) {
        controllers.push_back(project::nameOf(controller));
    }
    json["controllers"] = controllers;
    json["engine"] = project::nameOf(plan.engine);
    json["dt_s"] = plan.step;
    json["speed_m_s"] = plan.speed;
    json["distance_m"] = plan.distance;
    json["rolling_resistance"] = plan.rollingResistance;
    json["assumed_mu"] = plan.assumedFriction;
    json["control_period_s"] = plan.controlPeriod;
    json["noise"] = plan.noise;
    return json;
}

/// An object, or nothing; never throws.
std::optional<nlohmann::json> objectIn(const std::string& text) {
    if (tooDeep(text)) {
        return std::nullopt;
    }
    auto json = nlohmann::json::parse(text, nullptr, false);
    return json.is_object() ? std::optional(std::move(json)) : std::nullopt;
}

Case caseFrom(const nlohmann::json& json) {
    Case what;
    what.seed = json.at("seed").get<int>();
    what.friction = json.at("mu").get<double>();
    const auto kind =
        project::fromName<project::ControllerKind>(json.at("controller").get<std::string>());
    if (!kind) {
        throw std::invalid_argument("controller");
    }
    what.controller = *kind;
    return what;
}

Plan planFrom(const nlohmann::json& json) {
    Plan plan;
    plan.set = json.at("set").get<std::string>() == toString(experiment::TerrainSet::Profiles)
                   ? experiment::TerrainSet::Profiles
                   : experiment::TerrainSet::Terrains;
    plan.firstSeed = json.at("seeds").at(0).get<int>();
    plan.lastSeed = json.at("seeds").at(1).get<int>();
    plan.frictions = json.at("mu").get<std::vector<double>>();
    for (const auto& name : json.at("controllers")) {
        plan.controllers.push_back(
            project::fromName<project::ControllerKind>(name.get<std::string>()).value());
    }
    plan.engine =
        project::fromName<project::EngineKind>(json.at("engine").get<std::string>()).value();
    plan.step = json.at("dt_s").get<double>();
    plan.speed = json.at("speed_m_s").get<double>();
    plan.distance = json.at("distance_m").get<double>();
    plan.rollingResistance = json.at("rolling_resistance").get<double>();
    plan.assumedFriction = json.at("assumed_mu").get<double>();
    plan.controlPeriod = json.at("control_period_s").get<double>();
    plan.noise = json.at("noise").get<double>();
    return plan;
}

/// What `read` makes of an object; nothing when a key is missing or of another kind.
template <class Read>
auto readObject(const std::string& line, Read&& read)
    -> std::optional<decltype(read(nlohmann::json()))> {
    const auto json = objectIn(line);
    if (!json) {
        return std::nullopt;
    }
    try {
        return read(*json);
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

std::string cell(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

/// A text as a field of a table: quoted, as it may hold commas and lines.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
    }
    return result + "\"";
}

}  // namespace

std::string formatPlan(const Plan& plan, const project::Project& project) {
    Json json;
    json["plan"] = toJson(plan);
    json["project"] = formatProject(project);
    return json.dump();
}

Result<ParsedPlan> parsePlan(const std::string& line) {
    const auto parts = readObject(line, [](const nlohmann::json& json) {
        return std::pair(planFrom(json.at("plan")), json.at("project").get<std::string>());
    });
    if (!parts) {
        return Problem{Severity::Critical, "plan", Text::of("it is no plan of an experiment."),
                       Text::of("Let roversim reproduce start its workers.")};
    }
    auto project = parseProject(parts->second, "plan");
    if (!project) {
        return project.problems();
    }
    return ParsedPlan{parts->first, std::move(project).value()};
}

std::string formatCase(const Case& what) {
    return toJson(what).dump();
}

std::optional<Case> parseCase(const std::string& line) {
    return readObject(line, caseFrom);
}

std::string formatOutcome(const Outcome& outcome) {
    return toJson(outcome).dump();
}

std::optional<Outcome> parseOutcome(const std::string& line) {
    return readObject(line, [](const nlohmann::json& json) {
        Outcome outcome;
        outcome.ran = caseFrom(json);
        outcome.completed = json.at("completed").get<bool>();
        outcome.stopReason = json.at("stop_reason").get<std::string>();
        for (const auto& [name, member] : kNumbers) {
            outcome.*member = json.at(name).is_null() ? std::nan("") : json.at(name).get<double>();
        }
        outcome.stateHash = json.at("state_hash").get<std::string>();
        return outcome;
    });
}

Json toJson(const Plan& plan, const std::vector<Outcome>& outcomes,
            const std::vector<Comparison>& comparisons) {
    Json json = toJson(plan);
    json["runs"] = Json::array();
    for (const Outcome& outcome : outcomes) {
        json["runs"].push_back(toJson(outcome));
    }
    json["summary"] = Json::array();
    for (const Comparison& comparison : comparisons) {
        json["summary"].push_back(toJson(comparison));
    }
    return json;
}

Json toJson(const experiment::Outcome& first, const experiment::Outcome& second,
            const experiment::Verdict& verdict) {
    const auto side = [&](experiment::Less less) {
        return less == experiment::Less::Neither ? Json()
               : less == experiment::Less::First ? Json(project::nameOf(first.ran.controller))
                                                 : Json(project::nameOf(second.ran.controller));
    };
    Json json;
    json["runs"] = Json::array();
    for (const Outcome* outcome : {&first, &second}) {
        Json run = toJson(*outcome);
        run.erase("mu_static");
        json["runs"].push_back(run);
    }
    json["both_completed"] = verdict.bothCompleted;
    json["failed"] = side(verdict.failed);
    json["ends_apart_m"] = verdict.apart;
    json["same_way"] = verdict.sameWay;
    const auto measure = [&](const char* name, const experiment::Verdict::Measure& m) {
        json[name] = {{"less", side(m.less)}, {"ratio", numberOrNull(m.ratio)}};
    };
    measure("slip", verdict.slip);
    measure("slip_loaded", verdict.loadedSlip);
    measure("friction_work", verdict.work);
    measure("energy", verdict.energy);
    return json;
}

std::string runsTable(const std::vector<Outcome>& outcomes) {
    std::string text =
        "seed,mu [-],controller,completed,stop_reason,mu_static [-],slip_abs [m],slip_loaded "
        "[m],slip_signed [m],"
        "friction_work [J],energy [J],peak_torque [N m],time [s],end_x [m],end_y [m]\n";
    for (const Outcome& outcome : outcomes) {
        text += fmt::format("{},{},{},{},{}", outcome.ran.seed, cell(outcome.ran.friction),
                            project::nameOf(outcome.ran.controller), outcome.completed ? 1 : 0,
                            quoted(outcome.stopReason));
        for (const auto& [name, member] : kNumbers) {
            text += "," + cell(outcome.*member);
        }
        text += "\n";
    }
    return text;
}

std::string summaryTable(const std::vector<Comparison>& comparisons) {
    std::string text =
        "mu [-],grounds,controller,rival,tried,pairs,valid,only_controller,only_rival";
    for (const auto& [prefix, member] : kMeasures) {
        text += fmt::format(",{0}wins,{0}ties,{0}mean_ratio [-],{0}ci95_low [-],{0}ci95_high [-]",
                            prefix);
    }
    text += "\n";
    for (const Comparison& c : comparisons) {
        text += fmt::format("{},{},{},{},{},{},{},{},{}", cell(c.friction), toString(c.grounds),
                            project::nameOf(c.controller), project::nameOf(c.rival), c.tried,
                            c.pairs, c.valid, c.onlyOwn, c.onlyRival);
        for (const auto& [prefix, member] : kMeasures) {
            const Comparison::Measure& m = c.*member;
            const auto known = [](double value) { return value > 0.0 ? cell(value) : ""; };
            text += fmt::format(",{},{},{},{},{}", m.wins, m.ties, known(m.meanRatio), known(m.low),
                                known(m.high));
        }
        text += "\n";
    }
    return text;
}

}  // namespace simcore::io
