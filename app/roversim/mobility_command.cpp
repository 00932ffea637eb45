#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/mobility/mobility.h"

namespace roversim {

using namespace simcore;

namespace {

struct MobilityOptions {
    std::string file;
    std::string model;
    std::vector<std::string> set;
    bool json = false;
};

void printLine(const char* label, const std::vector<mobility::Report>& reports,
               int (*value)(const mobility::Report&)) {
    fmt::print("  {:<22}", label);
    for (const mobility::Report& report : reports) {
        fmt::print("{:>10}", value(report));
    }
    fmt::print("\n");
}

void printTable(const std::string& rover, const std::vector<mobility::Report>& reports) {
    using R = mobility::Report;
    fmt::print("{}\n  {:<22}", rover, "");
    for (const R& report : reports) {
        fmt::print("{:>10}", report.model == mobility::Model::Built ? "as built" : "relaxed");
    }
    fmt::print("\n");
    printLine("bodies", reports, [](const R& r) { return r.bodies; });
    printLine("joints, with contacts", reports, [](const R& r) { return r.joints; });
    printLine("Grübler count", reports, [](const R& r) { return r.gruebler; });
    printLine("constraint rows", reports, [](const R& r) { return r.rows; });
    printLine("rank", reports, [](const R& r) { return r.rank; });
    printLine("mobility", reports, [](const R& r) { return r.mobility; });
    printLine("redundant", reports, [](const R& r) { return r.redundant; });
    for (const R& report : reports) {
        fmt::print("\n{}: {}\n", report.model == mobility::Model::Built ? "As built" : "Relaxed",
                   mobility::describe(report));
        if (!report.redundantSet.empty()) {
            fmt::print("  Any of {} constraints could go; for example this set of {}:\n",
                       report.removable.size(), report.redundant);
        }
        for (const mobility::ConstraintName& name : report.redundantSet) {
            fmt::print("    {:<28} {:<5} ({:.3g}, {:.3g}, {:.3g})  share {:.2f}\n", name.element,
                       name.kind, name.direction.x() + 0.0, name.direction.y() + 0.0,
                       name.direction.z() + 0.0, name.share);
        }
        for (const mobility::IdleFreedom& idle : report.idle) {
            fmt::print("    idle: {}\n", idle.body);
        }
    }
}

int mobilityOf(const MobilityOptions& options) {
    const auto project = loadOrComplain(options.file);
    const auto assignments = parseAssignments(options.set);
    if (!assignments) {
        return kWrongUse;
    }
    if (!project) {
        return kAnswerIsNo;
    }
    const auto mechanism = project::resolve(*project, "", *assignments);
    printProblems(options.file, mechanism.problems());
    if (!mechanism) {
        return kAnswerIsNo;
    }
    std::vector<mobility::Report> reports;
    if (options.model != "relaxed") {
        reports.push_back(mobility::analyse(*mechanism, mobility::Model::Built));
    }
    if (options.model != "built") {
        reports.push_back(mobility::analyse(*mechanism, mobility::Model::Relaxed));
    }
    if (!options.json) {
        printTable(mechanism->name, reports);
        return kGood;
    }
    auto document = io::jsonDocument("roverstudio-mobility-1");
    document["rover"] = mechanism->name;
    if (reports.size() == 1) {
        document.update(io::toJson(reports.front()));
    } else {
        document["models"] = {io::toJson(reports[0]), io::toJson(reports[1])};
    }
    fmt::print("{}", io::formatJson(document));
    return kGood;
}

}  // namespace

void addMobilityCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<MobilityOptions>();
    CLI::App* command = app.add_subcommand(
        "mobility", "Count and true mobility, redundant constraints, idle freedoms");
    command->add_option("FILE", options->file, "Project file (.rover)")->required();
    command->add_option("--model", options->model, "built or relaxed; both when not given")
        ->check(CLI::IsMember({"built", "relaxed"}));
    command->add_option("--set", options->set, "NAME=VALUE, set a parameter (may be repeated)")
        ->allow_extra_args(false);
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = mobilityOf(*options); });
}

}  // namespace roversim
