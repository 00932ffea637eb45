#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "app/roversim/run_options.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/run/critical_friction.h"

namespace roversim {

using namespace simcore;

namespace {

struct Options : RunOptions {
    double low = 0.1;
    double high = 1.2;
    double tolerance = 0.005;
    bool json = false;
};

int searchFriction(const Options& options) {
    const auto request = requestOf(options);
    if (!request) {
        return kWrongUse;
    }
    const auto project = loadOrComplain(options.file);
    if (!project) {
        return kAnswerIsNo;
    }
    const auto found = run::findCriticalFriction(
        *project, *request, options.low, options.high, options.tolerance,
        [](double friction, bool completed) {
            fmt::print(stderr, "  {:.4f} {}\n", friction, completed ? "completes" : "fails");
        });
    printProblems(options.file, found.problems());
    if (!found) {
        return kAnswerIsNo;
    }
    if (options.json) {
        auto document = io::jsonDocument("roverstudio-critical-friction-1");
        document["scenario"] = options.scenario;
        document["fails"] = found->fails;
        document["completes"] = found->completes;
        document["runs"] = found->runs;
        fmt::print("{}", io::formatJson(document));
    } else {
        fmt::print("{} completes from a friction between {:.4f} and {:.4f} on ({} runs)\n",
                   options.scenario, found->fails, found->completes, found->runs);
    }
    return kGood;
}

}  // namespace

void addCriticalFrictionCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("critical-friction",
                                           "Find by bisection the friction that a scenario needs");
    addRunOptions(*command, *options);
    command->add_option("--low", options->low, "Friction at which it fails")->capture_default_str();
    command->add_option("--high", options->high, "Friction at which it completes")
        ->capture_default_str();
    command->add_option("--tolerance", options->tolerance, "Width of the answer")
        ->capture_default_str();
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = searchFriction(*options); });
}

}  // namespace roversim
