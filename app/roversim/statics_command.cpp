#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/statics/static_study.h"

namespace roversim {

using namespace simcore;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct Options {
    std::string file;
    std::string model = "built";
    int contacts = 0;
    std::vector<std::string> angles;
    std::vector<std::string> set;
    bool json = false;
};

/// "WHEEL=DEG"; on a malformed one prints why and returns nothing.
std::optional<std::vector<statics::WheelAngle>> anglesOf(const std::vector<std::string>& texts) {
    std::vector<statics::WheelAngle> angles;
    for (const std::string& text : texts) {
        const std::size_t sign = text.find('=');
        char* end = nullptr;
        const std::string number = sign == std::string::npos ? "" : text.substr(sign + 1);
        const double degrees = std::strtod(number.c_str(), &end);
        if (sign == 0 || number.empty() || *end != '\0' || !std::isfinite(degrees)) {
            fmt::print(stderr, "roversim: --contact {}: write WHEEL=DEG, as in front=90\n", text);
            return std::nullopt;
        }
        angles.push_back({text.substr(0, sign), degrees * kDegree});
    }
    return angles;
}

nlohmann::ordered_json toJson(const statics::Study& study) {
    auto json = io::jsonDocument("roverstudio-statics-1");
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
                                {"max_ratio", std::isfinite(study.equalMaxRatio)
                                                  ? nlohmann::ordered_json(study.equalMaxRatio)
                                                  : nlohmann::ordered_json()}};
    }
    json["optimal"] = nullptr;
    if (study.feasible) {
        json["optimal"] = {{"mu_required", study.frictionRequired},
                           {"min_torque", study.minimumTorque}};
    }
    json["wheels"] = nlohmann::ordered_json::array();
    for (const statics::WheelStudy& wheel : study.wheels) {
        json["wheels"].push_back({{"name", wheel.name},
                                  {"normal_force", wheel.normal},
                                  {"traction_force", wheel.traction},
                                  {"lateral_force", wheel.lateral},
                                  {"torque", wheel.torque},
                                  {"ratio", wheel.ratio},
                                  {"contact_angle_deg", wheel.contactAngle / kDegree}});
    }
    return json;
}

void print(const statics::Study& study) {
    fmt::print(
        "{} equations, {} internal reactions left out: M is {} x {}, solutions of dimension {}\n",
        study.equations, study.internalReactions, study.rows, study.unknowns, study.dimension);
    if (study.equalTorque) {
        fmt::print("equal torques {:.4f} N m ask for a friction of {:.4f}\n", *study.equalTorque,
                   study.equalMaxRatio);
    }
    if (study.feasible) {
        fmt::print("required friction {:.4f}; least largest torque {:.4f} N m\n",
                   study.frictionRequired, study.minimumTorque);
    }
    fmt::print("flags: {}\n", fmt::join(study.flags, ", "));
    if (!study.wheels.empty()) {
        fmt::print("\n  {:<22}{:>12}{:>12}{:>12}{:>12}{:>12}{:>10}\n", "wheel", "angle [deg]",
                   "load [N]", "traction [N]", "lateral [N]", "torque [Nm]", "ratio");
    }
    for (const statics::WheelStudy& wheel : study.wheels) {
        fmt::print("  {:<22}{:>12.1f}{:>12.3f}{:>12.3f}{:>12.3f}{:>12.4f}{:>10.4f}\n", wheel.name,
                   wheel.contactAngle / kDegree, wheel.normal, wheel.traction, wheel.lateral,
                   wheel.torque, wheel.ratio);
    }
}

int studyStatics(const Options& options) {
    const auto angles = anglesOf(options.angles);
    const auto assignments = parseAssignments(options.set);
    if (!angles || !assignments) {
        return kWrongUse;
    }
    const auto project = loadOrComplain(options.file);
    if (!project) {
        return kAnswerIsNo;
    }
    const auto mechanism = project::resolve(*project, {}, *assignments);
    printProblems(options.file, mechanism.problems());
    if (!mechanism) {
        return kAnswerIsNo;
    }
    statics::StudyRequest request;
    request.joints =
        options.model == "relaxed" ? mechanism::Model::Relaxed : mechanism::Model::Built;
    request.angles = *angles;
    if (options.contacts != 0) {
        request.contacts =
            options.contacts == 14 ? statics::ContactSet::Free : statics::ContactSet::All;
    }
    const auto study = statics::studyDrawnPose(*mechanism, request);
    printProblems(options.file, study.problems());
    if (!study) {
        return kAnswerIsNo;
    }
    if (options.json) {
        fmt::print("{}", io::formatJson(toJson(*study)));
    } else {
        print(*study);
    }
    return study->feasible ? kGood : kAnswerIsNo;
}

}  // namespace

void addStaticsCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "statics", "Forces, torques and required friction where a rover stands or creeps");
    command->add_option("FILE", options->file, "Project file (.rover)")->required();
    command
        ->add_option("--contact", options->angles,
                     "WHEEL=DEG, contact angle of a wheel (90 = a wall ahead; may be repeated)")
        ->allow_extra_args(false);
    command->add_option("--model", options->model, "Joints")
        ->check(CLI::IsMember({"built", "relaxed"}))
        ->capture_default_str();
    command
        ->add_option("--contacts", options->contacts,
                     "14: lateral forces only where none is freed; 18: at every wheel")
        ->check(CLI::IsMember({14, 18}));
    command->add_option("--set", options->set, "NAME=VALUE, set a parameter (may be repeated)")
        ->allow_extra_args(false);
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = studyStatics(*options); });
}

}  // namespace roversim
