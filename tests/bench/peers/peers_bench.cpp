// Our engine beside MuJoCo and Bullet: the same rover, ground, drive and measures, one after the
// other in turn, on one thread. What is timed of ours is a whole step of a run (contact search,
// sensors, controller, drives, engine, measures, state hash), of the peers their step alone.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "simcore/io/project_file.h"
#include "tests/bench/peers/measured_run.h"

namespace {

using namespace peers;
using simcore::Problem;
using simcore::Severity;
using simcore::project::EngineKind;
using simcore::run::ResolvedRun;

// As other engines' height fields are made here [m]; also the grid of the bench rover's grounds.
constexpr double kCell = 0.01;
// Ground behind the start, beyond the way and to either side [m].
constexpr double kBehind = 1.0;
constexpr double kBeyond = 1.5;
constexpr double kHalfWidth = 1.2;

struct Options {
    std::string project = std::string(ROVER_SOURCE_DIR) + "/assets/projects/bench_rover.rover";
    std::vector<std::string> terrains{"rough", "sinus"};
    std::vector<std::string> engines;
    double step = 0.002;
    double length = 3.5;
    int repetitions = 5;
    WheelShape wheel = WheelShape::Ellipsoid;
    std::string json;
};

/// One of those that are compared.
struct Contender {
    std::string key;   ///< as the command line names it
    std::string name;  ///< as the table does
    std::function<MeasuredRun()> run;
    std::vector<MeasuredRun> runs;
};

const std::map<std::string, PeerMaker>& peerMakers() {
    static const std::map<std::string, PeerMaker> makers{{"mujoco", mujocoMaker()},
                                                         {"bullet", bulletMaker()}};
    return makers;
}

/// The engines to compare when none is asked for: ours in reduced coordinates, and the peers there
/// are.
std::vector<std::string> usualEngines() {
    std::vector<std::string> engines{"reduced"};
    for (const auto* peer : {"mujoco", "bullet"}) {
        if (peerMakers().at(peer)) {
            engines.emplace_back(peer);
        } else {
            fmt::print("{} is missing: the program was built without it (Debian: lib{}-dev)\n",
                       peer, peer);
        }
    }
    return engines;
}

// -- numbers of several runs ----------------------------------------------------------------------

struct Spread {
    double median = 0.0, least = 0.0, most = 0.0;
};

template <class Number>
Spread spreadOf(const std::vector<MeasuredRun>& runs, Number&& number) {
    std::vector<double> values;
    for (const MeasuredRun& run : runs) {
        values.push_back(number(run));
    }
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
    return {median, values.front(), values.back()};
}

/// A quantity of the table: its key in the JSON, heading, digits, and value of one run.
struct Quantity {
    const char* key;
    const char* heading;
    int digits;
    double (*of)(const MeasuredRun&);
};

double perStep(const MeasuredRun& run, double time) {
    return 1e6 * time / static_cast<double>(run.steps);
}

constexpr std::array kQuantities{
    Quantity{"us_per_step", "µs/step", 1,
             [](const MeasuredRun& r) { return perStep(r, r.wallTime); }},
    Quantity{"cpu_us_per_step", "CPU µs/step", 1,
             [](const MeasuredRun& r) { return perStep(r, r.cpuTime); }},
    Quantity{"rtf", "RTF", 1, [](const MeasuredRun& r) { return r.simTime / r.wallTime; }},
    Quantity{"steps", "steps", 0,
             [](const MeasuredRun& r) { return static_cast<double>(r.steps); }},
    Quantity{"penetration_max_mm", "penetration [mm]", 3,
             [](const MeasuredRun& r) { return 1e3 * r.penetration; }},
    Quantity{"loop_error_max_mm", "loop error [mm]", 6,
             [](const MeasuredRun& r) { return 1e3 * r.loopError; }},
    Quantity{"slip_abs_m", "slip_abs [m]", 4, [](const MeasuredRun& r) { return r.slipAbs; }},
    Quantity{"x_end_m", "x_end [m]", 3, [](const MeasuredRun& r) { return r.distance; }},
};

std::string cell(const Spread& spread, int digits) {
    const std::string median = fmt::format("{:.{}f}", spread.median, digits);
    // A run repeats to the last digit; only times spread.
    return spread.least == spread.most ? median
                                       : fmt::format("{} ({:.{}f}–{:.{}f})", median, spread.least,
                                                     digits, spread.most, digits);
}

bool completed(const Contender& contender) {
    return std::all_of(contender.runs.begin(), contender.runs.end(),
                       [](const MeasuredRun& run) { return run.completed; });
}

void printTable(const std::vector<Contender>& contenders) {
    fmt::print("\n| engine |");
    for (const Quantity& quantity : kQuantities) {
        fmt::print(" {} |", quantity.heading);
    }
    fmt::print(" completed |\n|{}\n", [] {
        std::string rule;
        for (std::size_t i = 0; i < kQuantities.size() + 2; ++i) {
            rule += " --- |";
        }
        return rule;
    }());
    for (const Contender& contender : contenders) {
        fmt::print("| {} |", contender.name);
        for (const Quantity& quantity : kQuantities) {
            fmt::print(" {} |", cell(spreadOf(contender.runs, quantity.of), quantity.digits));
        }
        fmt::print(" {} |\n", completed(contender) ? "yes" : "no");
    }
    fmt::print("\n");
}

/// How much longer another engine takes than ours for the same simulated time: by the clock, and by
/// the time that the thread had a core.
void printRatios(const std::vector<Contender>& contenders) {
    const Contender& ours = contenders.front();
    const auto wall = [](const MeasuredRun& r) { return r.wallTime / r.simTime; };
    const auto cpu = [](const MeasuredRun& r) { return r.cpuTime / r.simTime; };
    for (std::size_t i = 1; i < contenders.size(); ++i) {
        fmt::print("time per simulated second, {} / {}: {:.2f} by the clock, {:.2f} of CPU\n",
                   contenders[i].name, ours.name,
                   spreadOf(contenders[i].runs, wall).median / spreadOf(ours.runs, wall).median,
                   spreadOf(contenders[i].runs, cpu).median / spreadOf(ours.runs, cpu).median);
    }
}

nlohmann::ordered_json toJson(const Contender& contender) {
    nlohmann::ordered_json json;
    json["engine"] = contender.name;
    for (const Quantity& quantity : kQuantities) {
        const Spread spread = spreadOf(contender.runs, quantity.of);
        json[quantity.key] = {
            {"median", spread.median}, {"min", spread.least}, {"max", spread.most}};
    }
    json["completed"] = completed(contender);
    return json;
}

// -- a terrain ------------------------------------------------------------------------------------

simcore::Result<ResolvedRun> prepare(const Options& options,
                                     const simcore::project::Project& project,
                                     const std::string& terrain) {
    simcore::run::RunRequest request;
    request.scenario = terrain;
    request.files.folder = std::filesystem::path(options.project).parent_path();
    request.engine = EngineKind::Reduced;
    request.controller = simcore::project::ControllerKind::Speed;
    request.step = options.step;
    request.distance = options.length;
    return prepareRun(project, request);
}

/// What of a scenario the peers are not given.
simcore::Problems whyNotComparable(const ResolvedRun& run) {
    simcore::Problems problems;
    const auto refuse = [&](const char* element, const char* reason) {
        problems.push_back({Severity::Critical,
                            std::string("scenario ") + run.scenario + ", " + element, reason,
                            "Compare the engines on a scenario without it."});
    };
    if (!run.regions.empty()) {
        refuse("regions", "the peers' ground has one friction.");
    }
    if (run.rollingResistance != 0.0) {
        refuse("rolling resistance", "the peers' wheels have none.");
    }
    if (run.turn != 0.0 || !(run.speed > 0.0)) {
        refuse("controller", "the peers only drive straight on.");
    }
    return problems;
}

simcore::Result<PeerWorld> makeWorld(const ResolvedRun& run, WheelShape wheel) {
    simcore::Problems problems = whyNotComparable(run);
    auto tree = peerTreeOf(run.mechanism, run.joints);
    appendNew(problems, tree.problems());
    auto ground = sampleGround(*run.terrain, kCell,
                               {-kBehind, -kHalfWidth, run.distance + kBeyond, kHalfWidth});
    appendNew(problems, ground.problems());
    if (ground && ground->x1() < run.distance + run.mechanism.wheelbase()) {
        problems.push_back({Severity::Critical, "terrain",
                            fmt::format("it ends at x = {:.2f} m, before the rover's way of {:.2f} "
                                        "m does.",
                                        ground->x1(), run.distance),
                            "Give a shorter --length."});
    }
    if (!problems.empty()) {
        return problems;
    }
    return PeerWorld{run, std::move(tree).value(), std::move(ground).value(), wheel};
}

std::vector<Contender> makeContenders(const std::vector<std::string>& engines,
                                      const PeerWorld& world) {
    std::vector<Contender> contenders;
    for (const std::string& key : engines) {
        const auto maker = peerMakers().find(key);
        if (maker == peerMakers().end()) {
            const EngineKind kind = key == "ode" ? EngineKind::Ode : EngineKind::Reduced;
            contenders.push_back({key,
                                  fmt::format("RoverStudio, {}", key),
                                  [&world, kind] { return runOurs(world.run, kind); },
                                  {}});
            continue;
        }
        contenders.push_back(
            {key,
             maker->second(world)->name(),
             [&world, make = maker->second] { return runPeer(*make(world), world.run); },
             {}});
    }
    return contenders;
}

double load() {
    double average = std::numeric_limits<double>::quiet_NaN();
    return getloadavg(&average, 1) == 1 ? average : std::numeric_limits<double>::quiet_NaN();
}

nlohmann::ordered_json compare(const Options& options, const PeerWorld& world) {
    std::vector<Contender> contenders = makeContenders(options.engines, world);
    const double loadBefore = load();
    for (int i = 0; i < options.repetitions; ++i) {
        for (Contender& contender : contenders) {
            contender.runs.push_back(contender.run());
        }
    }
    fmt::print(
        "\n{}: {} m at {} m/s, step {} ms, friction {}; {} runs of each in turn, median "
        "(least–most); load average {:.2f} before, {:.2f} after\n",
        world.run.scenario, world.run.distance, world.run.speed, 1e3 * world.run.step,
        world.run.friction, options.repetitions, loadBefore, load());
    printTable(contenders);
    printRatios(contenders);
    std::fflush(stdout);  // a terrain takes minutes
    nlohmann::ordered_json json{{"terrain", world.run.scenario},
                                {"step_s", world.run.step},
                                {"length_m", world.run.distance},
                                {"repetitions", options.repetitions},
                                {"load_average", {loadBefore, load()}}};
    for (const Contender& contender : contenders) {
        json["engines"].push_back(toJson(contender));
    }
    return json;
}

int complain(const simcore::Problems& problems) {
    fmt::print(stderr, "peers_bench: {}\n", toString(problems));
    return 1;
}

int compareAll(Options options) {
    const auto project = simcore::io::loadProject(options.project);
    if (!project) {
        return complain(project.problems());
    }
    if (options.engines.empty()) {
        options.engines = usualEngines();
    }
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::string& terrain : options.terrains) {
        const auto run = prepare(options, *project, terrain);
        if (!run) {
            return complain(run.problems());
        }
        const auto world = makeWorld(*run, options.wheel);
        if (!world) {
            return complain(world.problems());
        }
        all.push_back(compare(options, *world));
    }
    if (!options.json.empty() && !(std::ofstream(options.json) << all.dump(2) << '\n')) {
        return complain({Problem{Severity::Critical, options.json, "cannot be written.",
                                 "Name a file in a folder that exists."}});
    }
    return 0;
}

void addOptions(CLI::App& app, Options& options) {
    app.add_option("--terrain", options.terrains,
                   "Scenarios of the project, or all (flat step sinus rough)")
        ->capture_default_str();
    app.add_option(
           "--engine", options.engines,
           "Engines to compare, the first one with each other one (default: reduced and the "
           "peers there are)")
        ->check([](const std::string& name) {
            const auto maker = peerMakers().find(name);
            if (maker != peerMakers().end()) {
                return maker->second ? std::string()
                                     : fmt::format(
                                           "this program was built without {0}; install "
                                           "lib{0}-dev and build it again",
                                           name);
            }
            return name == "reduced" || name == "ode"
                       ? std::string()
                       : name + " is none of: reduced, ode, mujoco, bullet";
        });
    app.add_option("--step", options.step, "Engine step [s]")
        ->check(CLI::Range(1e-5, 0.02))
        ->capture_default_str();
    app.add_option("--length", options.length, "Way that completes a run [m]")
        ->check(CLI::Range(0.01, 1000.0))
        ->capture_default_str();
    app.add_option("--repetitions", options.repetitions, "Runs of each engine")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--project", options.project, "Project file (.rover)")->check(CLI::ExistingFile);
    app.add_option("--wheel", options.wheel,
                   "Shape of the peers' wheels; Bullet has spheres for ellipsoids")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, WheelShape>{{"ellipsoid", WheelShape::Ellipsoid},
                                              {"cylinder", WheelShape::Cylinder},
                                              {"sphere", WheelShape::Sphere}}));
    app.add_option("--json", options.json, "Write the numbers to this file");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Our engine beside MuJoCo and Bullet on the same rover and ground.",
                 "peers_bench"};
    Options options;
    addOptions(app, options);
    try {
        app.parse(argc, argv);
        if (options.terrains == std::vector<std::string>{"all"}) {
            options.terrains = {"flat", "step", "sinus", "rough"};
        }
        return compareAll(options);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "peers_bench: {}\n", error.what());
        return 1;
    }
}
