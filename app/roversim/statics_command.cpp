#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/dynamics/engine.h"
#include "simcore/io/atomic_file.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/io/statics_tables.h"
#include "simcore/run/simulation.h"
#include "simcore/statics/capability.h"
#include "simcore/statics/static_study.h"

namespace roversim {

using namespace simcore;

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct Options {
    std::string file;
    std::string scenario;
    double x = 0.0, y = 0.0, heading = 0.0;
    std::string pose;
    std::string model = "built";
    int contacts = 0;
    std::vector<std::string> angles;
    std::vector<std::string> set;
    bool along = false;
    bool backwards = false;
    double climb = 0.0;
    double tread = 0.3;
    std::string csv;
    bool json = false;

    bool settled() const { return pose == "settled" || along; }
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

void print(const statics::Study& study) {
    fmt::print(
        "{} equations, {} internal reactions left out: M is {} x {}, solutions of dimension {}\n",
        study.equations, study.internalReactions, study.rows, study.unknowns, study.dimension);
    if (study.equalTorque) {
        fmt::print("equal torques {:.4f} N m ask for a friction of {:.4f}\n", *study.equalTorque,
                   study.equalMaxRatio);
    }
    fmt::print("tips over after {:.1f} deg\n", study.tipOver / kDegree);
    if (study.feasible) {
        fmt::print("required friction {:.4f}; least largest torque {:.4f} N m\n",
                   study.frictionRequired, study.minimumTorque);
        fmt::print("least losses: squared torques {:.4f} N^2 m^2, with a friction of {:.4f}\n",
                   study.leastSquares, study.leastSquaresRatio);
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

void print(const std::string& title, const nlohmann::ordered_json& pose) {
    fmt::print("{}: {}\n", title, pose.at("standing").get<std::string>());
    if (pose.contains("x_m")) {
        fmt::print("x {:.4f} m, y {:.4f} m, z {:.4f} m, roll {:.3f} deg, pitch {:.3f} deg\n",
                   pose.at("x_m").get<double>(), pose.at("y_m").get<double>(),
                   pose.at("z_m").get<double>(), pose.at("roll_deg").get<double>(),
                   pose.at("pitch_deg").get<double>());
    }
}

void print(const statics::Traverse& traverse) {
    fmt::print("  {:>10}{:>10}{:>12}  {}\n", "way [m]", "x [m]", "friction", "");
    for (const statics::TraverseSample& sample : traverse.samples) {
        if (!sample.events.empty()) {
            fmt::print("  {:>10.4f}{:>10.4f}{:>12.4f}  {}\n", sample.way, sample.distance,
                       sample.study.frictionRequired, fmt::join(sample.events, ", "));
        }
    }
    fmt::print("{} after {} samples", toString(traverse.end), traverse.samples.size());
    if (traverse.end == statics::TraverseEnd::NoPose) {
        fmt::print(" ({})", toString(traverse.why));
    }
    if (!traverse.samples.empty()) {
        const auto& hardest = traverse.samples[traverse.hardest()];
        fmt::print("; required friction {:.4f}, hardest at x = {:.4f} m",
                   traverse.frictionRequired(), hardest.distance);
    }
    fmt::print("\n");
}

std::optional<statics::ContactSet> contactsOf(const Options& options) {
    if (options.contacts == 0) {
        return std::nullopt;
    }
    return options.contacts == 14 ? statics::ContactSet::Free : statics::ContactSet::All;
}

mechanism::Model modelOf(const Options& options) {
    return options.model == "relaxed" ? mechanism::Model::Relaxed : mechanism::Model::Built;
}

int studyDrawn(const Options& options, const mechanism::Mechanism& mechanism,
               std::vector<statics::WheelAngle> angles) {
    statics::StudyRequest request;
    request.joints = modelOf(options);
    request.angles = std::move(angles);
    request.contacts = contactsOf(options);
    const auto study = statics::studyDrawnPose(mechanism, request);
    printProblems(options.file, study.problems());
    if (!study) {
        return kAnswerIsNo;
    }
    if (options.json) {
        auto json = io::jsonDocument("roverstudio-statics-1");
        json.update(io::toJson(*study));
        fmt::print("{}", io::formatJson(json));
    } else {
        print(*study);
    }
    return study->feasible ? kGood : kAnswerIsNo;
}

int studyAlong(const Options& options, statics::PoseSolver& solver, double distance) {
    statics::TraverseRequest request;
    request.from = {options.x, options.y, options.heading * kDegree};
    request.distance = distance;
    request.backwards = options.backwards;
    request.contacts = contactsOf(options);
    const statics::Traverse traverse = statics::traverse(solver, request);
    if (!options.csv.empty()) {
        const auto saved =
            io::writeFileAtomically(options.csv, io::traverseTable(solver.mechanism(), traverse));
        printProblems(options.csv, saved.problems());
        if (!saved) {
            return kAnswerIsNo;
        }
    }
    if (options.json) {
        auto json = io::jsonDocument("roverstudio-traverse-1");
        json.update(io::toJson(traverse));
        fmt::print("{}", io::formatJson(json));
    } else {
        print(traverse);
    }
    return std::isfinite(traverse.frictionRequired()) ? kGood : kAnswerIsNo;
}

/// False after it has said why.
bool hasWheels(const Options& options, const mechanism::Mechanism& mechanism) {
    if (mechanism.wheels.empty()) {
        fmt::print(stderr, "roversim: {}: a rover without wheels stands on nothing\n",
                   options.file);
    }
    return !mechanism.wheels.empty();
}

/// On a scenario's ground.
int studySettled(const Options& options, const project::Project& project,
                 const std::vector<project::Assignment>& assignments) {
    run::RunRequest request;
    request.scenario = options.scenario;
    request.files.folder = std::filesystem::path(options.file).parent_path();
    request.assignments = assignments;
    const auto prepared = run::prepareRun(project, request);
    printProblems(options.file, prepared.problems());
    if (!prepared) {
        return kAnswerIsNo;
    }
    if (!hasWheels(options, prepared->mechanism)) {
        return kAnswerIsNo;
    }
    statics::StaticModel model(prepared->mechanism, modelOf(options));
    statics::PoseSolver solver(model, *prepared->terrain);
    if (options.along) {
        return studyAlong(options, solver, prepared->distance);
    }
    const statics::StandingPose pose =
        solver.settle({options.x, options.y, options.heading * kDegree});
    const auto standing = io::toJson(prepared->mechanism, pose);
    if (pose.standing != statics::Standing::Stands) {
        fmt::print(stderr, "roversim: {}: no pose at x = {} m: {}\n", options.file, options.x,
                   toString(pose.standing));
        return kAnswerIsNo;
    }
    const statics::Study study =
        statics::studyPose(model, pose, contactsOf(options), options.backwards);
    if (options.json) {
        auto json = io::jsonDocument("roverstudio-statics-1");
        json["pose"] = standing;
        json.update(io::toJson(study));
        fmt::print("{}", io::formatJson(json));
    } else {
        print(options.scenario, standing);
        print(study);
    }
    return study.feasible ? kGood : kAnswerIsNo;
}

int studyClimbs(const Options& options, const mechanism::Mechanism& mechanism) {
    if (const Problems problems = dynamics::whyNoEngineCanRun(mechanism); !problems.empty()) {
        printProblems(options.file, problems);
        return kAnswerIsNo;
    }
    if (!hasWheels(options, mechanism)) {
        return kAnswerIsNo;
    }
    auto json = io::jsonDocument("roverstudio-climbs-1");
    json["mu"] = options.climb;
    json["tread_m"] = options.tread;
    for (const bool backwards : {false, true}) {
        statics::ClimbRequest request;
        request.joints = modelOf(options);
        request.friction = options.climb;
        request.tread = options.tread;
        request.backwards = backwards;
        const statics::Capability can = statics::whatItClimbs(mechanism, request);
        json[backwards ? "backwards" : "forwards"] = io::toJson(can);
        if (!options.json) {
            fmt::print(
                "{:<10} step {}{:.1f} mm, stairs of {:.0f} mm tread {}{:.1f} mm, slope {:.2f} "
                "deg\n",
                backwards ? "backwards" : "forwards", can.stepLimited ? "" : "at least ",
                1e3 * can.step, 1e3 * options.tread, can.stairLimited ? "" : "at least ",
                1e3 * can.stair, can.slope / kDegree);
        }
    }
    if (options.json) {
        fmt::print("{}", io::formatJson(json));
    }
    return kGood;
}

/// What cannot be asked for together.
std::string contradictionIn(const Options& options) {
    if (options.settled() && options.scenario.empty()) {
        return "--pose settled and --along need a ground: give --scenario";
    }
    if (options.settled() && !options.angles.empty()) {
        return "--contact is for the nominal pose; on a scenario's ground contacts are found";
    }
    if (!options.settled() && !options.scenario.empty()) {
        return "--scenario is for --pose settled or --along";
    }
    if (options.climb > 0.0 && (options.settled() || !options.angles.empty())) {
        return "--climb makes its own steps and slopes: give neither a pose nor --contact";
    }
    if (!options.csv.empty() && !options.along) {
        return "--csv writes what --along finds";
    }
    return {};
}

int studyStatics(const Options& options) {
    const auto angles = anglesOf(options.angles);
    const auto assignments = parseAssignments(options.set);
    if (!angles || !assignments) {
        return kWrongUse;
    }
    if (const std::string why = contradictionIn(options); !why.empty()) {
        fmt::print(stderr, "roversim: {}\n", why);
        return kWrongUse;
    }
    const auto project = loadOrComplain(options.file);
    if (!project) {
        return kAnswerIsNo;
    }
    if (options.settled()) {
        return studySettled(options, *project, *assignments);
    }
    const auto mechanism = project::resolve(*project, {}, *assignments);
    printProblems(options.file, mechanism.problems());
    if (!mechanism) {
        return kAnswerIsNo;
    }
    return options.climb > 0.0 ? studyClimbs(options, *mechanism)
                               : studyDrawn(options, *mechanism, *angles);
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
    command->add_option("--scenario", options->scenario, "Ground to stand on");
    command->add_option("--x", options->x, "Of the chassis' origin [m]")
        ->check(CLI::Range(-1e4, 1e4));
    command->add_option("--y", options->y, "Of the chassis' origin [m]")
        ->check(CLI::Range(-1e4, 1e4));
    command->add_option("--heading", options->heading, "To the left [deg]")
        ->check(CLI::Range(-360.0, 360.0));
    command
        ->add_option("--pose", options->pose,
                     "nominal: as drawn; settled: on the scenario's ground")
        ->check(CLI::IsMember({"nominal", "settled"}));
    command->add_flag("--along", options->along,
                      "Follow the rover over the scenario's ground, as far as a run goes");
    command->add_flag("--backwards", options->backwards, "It begins to move, and goes, backwards");
    command->add_option("--csv", options->csv, "Write the curves of --along to this file");
    command
        ->add_option("--climb", options->climb,
                     "What step, stairs and slope it climbs at this friction")
        ->check(CLI::Range(0.01, 5.0));
    command->add_option("--tread", options->tread, "Of the stairs [m]")
        ->check(CLI::Range(0.01, 100.0))
        ->capture_default_str();
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
