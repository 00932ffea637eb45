#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/io/project_file.h"
#include "simcore/mobility/advisor.h"
#include "simcore/project/names.h"

namespace roversim {

using namespace simcore;

namespace {

struct RelaxOptions {
    std::string file;
    mobility::AdvisorOptions advisor;
    bool withoutContacts = false;
    int apply = 0;
    std::string output;
    bool json = false;
};

void printCounts(const char* label, const mobility::Report& report) {
    fmt::print("  {:<18}{:>10}{:>8}{:>6}{:>10}{:>11}{:>6}   {} {} {} {} {}\n", label,
               report.gruebler, report.rows, report.rank, report.mobility, report.redundant,
               report.idle.size(), report.jointsByFreedom[0], report.jointsByFreedom[1],
               report.jointsByFreedom[2], report.jointsByFreedom[3], report.jointsByFreedom[4]);
}

void printAdvice(const std::string& rover, const mobility::Advice& advice) {
    fmt::print("{}\n{}\n", rover, mobility::describe(advice));
    for (const std::string& note : advice.notes) {
        fmt::print("{}\n", note);
    }
    fmt::print("\n  {:<18}{:>10}{:>8}{:>6}{:>10}{:>11}{:>6}   {}\n", "", "Grübler", "rows", "rank",
               "mobility", "redundant", "idle", "f1..f5");
    printCounts("as built", advice.built);
    printCounts("relaxed in file", advice.fileRelaxed);
    for (std::size_t i = 0; i < advice.proposals.size(); ++i) {
        printCounts(fmt::format("proposal {}", i + 1).c_str(), advice.proposals[i].report);
    }
    for (std::size_t i = 0; i < advice.proposals.size(); ++i) {
        const mobility::Proposal& proposal = advice.proposals[i];
        fmt::print("\nProposal {}: {}; margin {:.2g}\n", i + 1, proposal.why, proposal.margin);
        for (const mobility::JointChange& change : proposal.changes) {
            fmt::print("  {:<34} {} -> {}{}\n", change.element, change.from, change.to,
                       change.sides == project::Sides::Both
                           ? ""
                           : fmt::format(" ({} only)", project::nameOf(change.sides)));
        }
    }
}

int applyProposal(const RelaxOptions& options, const project::Project& project,
                  const mobility::Advice& advice) {
    const auto count = static_cast<int>(advice.proposals.size());
    if (options.apply > count) {
        fmt::print(stderr, "roversim: --apply {}: there {} {} proposal{} for {}{}\n", options.apply,
                   count == 1 ? "is" : "are", count, count == 1 ? "" : "s", options.file,
                   advice.alreadyExact ? ", it is exact as built" : "");
        return kAnswerIsNo;
    }
    const auto changed = mobility::withRelaxation(
        project, advice.proposals[static_cast<std::size_t>(options.apply - 1)]);
    printProblems(options.file, changed.problems());
    if (!changed) {
        return kAnswerIsNo;
    }
    const auto saved = io::saveProject(*changed, options.output);
    printProblems(options.output, saved.problems());
    return saved ? kGood : kAnswerIsNo;
}

int relax(RelaxOptions options) {
    if ((options.apply > 0) != !options.output.empty()) {
        fmt::print(stderr, "roversim: --apply K and --output OUT.rover go together\n");
        return kWrongUse;
    }
    options.advisor.contacts = !options.withoutContacts;
    options.advisor.proposals = std::max(options.advisor.proposals, options.apply);
    const auto project = loadOrComplain(options.file);
    if (!project) {
        return kAnswerIsNo;
    }
    const auto advice = mobility::advise(*project, options.advisor);
    printProblems(options.file, advice.problems());
    if (!advice) {
        return kAnswerIsNo;
    }
    if (options.json) {
        auto document = io::jsonDocument("roverstudio-relax-1");
        document["rover"] = project->rover.name;
        document.update(io::toJson(*advice));
        fmt::print("{}", io::formatJson(document));
    } else {
        printAdvice(project->rover.name, *advice);
    }
    if (options.apply > 0) {
        return applyProposal(options, *project, *advice);
    }
    return advice->alreadyExact || !advice->proposals.empty() ? kGood : kAnswerIsNo;
}

}  // namespace

void addRelaxCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<RelaxOptions>();
    CLI::App* command = app.add_subcommand(
        "relax", "Which joints to change so that every reaction follows from the loads");
    command->add_option("FILE", options->file, "Project file (.rover)")->required();
    command->add_option("--max", options->advisor.proposals, "Proposals at most")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--alike", options->advisor.alike,
                     "At most so many that differ only in where the joints go")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--time", options->advisor.seconds, "Limit of the search [s]")
        ->check(CLI::Range(0.0, 86400.0))
        ->capture_default_str();
    command->add_flag("--keep-contacts", options->withoutContacts,
                      "Wheels hold sideways in the relaxed model, too");
    command->add_flag("--axles", options->advisor.axles, "Axles of wheels may be changed, too");
    command->add_option("--apply", options->apply, "Write proposal K, the first is 1")
        ->check(CLI::Range(1, 1000));
    command->add_option("--output", options->output, "Project file for --apply");
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = relax(*options); });
}

}  // namespace roversim
