#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/mobility/selection.h"
#include "simcore/mobility/study.h"

namespace roversim {

using namespace simcore;

namespace {

struct MobilityOptions {
    std::string file;
    std::string model;
    std::string steering;
    std::vector<std::string> set;
    std::vector<std::string> parts;
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

std::string directionText(const Vec3& d) {
    return fmt::format("({:.3g}, {:.3g}, {:.3g})", d.x() + 0.0, d.y() + 0.0, d.z() + 0.0);
}

/// "pin_a, pin_b, pin_c"
template <class List>
std::string joined(const List& list) {
    return fmt::format("{}", fmt::join(list, ", "));
}

void printMoved(const mobility::Study& study) {
    const mobility::MovedPose& moved = study.moved;
    fmt::print("  After a finite step: rank {}, mobility {}, redundant {}\n", moved.rank,
               moved.mobility, moved.redundant);
    if (const std::string text = describe(moved, study.present); !text.empty()) {
        fmt::print("  {}\n", text);
    }
    for (const mobility::FreeMotion& motion : moved.motions) {
        const char* how = motion.continuation == mobility::Continuation::Finite ? "moves on"
                          : motion.continuation == mobility::Continuation::Branch
                              ? "moves on together with others"
                              : "yields only";
        fmt::print("    {:<28} {}\n", motion.body, how);
        for (const mobility::Inconsistency& row : motion.inconsistent) {
            fmt::print("      inconsistent: {} {} {}, off by {:.3g} {}\n", row.constraint.element,
                       row.constraint.kind, directionText(row.constraint.direction),
                       row.constraint.kind == "slide" ? 1e3 * row.gap : row.gap,
                       row.constraint.kind == "slide" ? "mm" : "rad");
        }
    }
}

void printLoops(const std::vector<mobility::Loop>& loops) {
    if (loops.empty()) {
        return;
    }
    fmt::print("  {:<8}{:>10}{:>6}{:>10}{:>11}  {}\n", "Loop", "Grübler", "rank", "mobility",
               "redundant", "joints");
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const mobility::Loop& loop = loops[i];
        fmt::print("  {:<8}{:>10}{:>6}{:>10}{:>11}  {}\n", i + 1, loop.gruebler, loop.rank,
                   loop.mobility, loop.redundant, joined(loop.joints));
    }
}

void printReactions(const mobility::Study& study) {
    const auto shares = mobility::shareByElement(study.present);
    fmt::print("  {}\n", mobility::describe(study.reactions));
    fmt::print("  Reactions determined by the loads, and part of the self-stress:\n");
    for (const mobility::ReactionDeterminacy& reaction : study.reactions) {
        const auto share = std::find_if(shares.begin(), shares.end(), [&](const auto& one) {
            return one.element == reaction.element;
        });
        fmt::print("    {:<28} {} of {}{:>8.1f} %\n", reaction.element, reaction.determined.size(),
                   reaction.components, share == shares.end() ? 0.0 : 100.0 * share->part);
    }
}

void printTable(const std::string& rover, const std::vector<mobility::Study>& studies,
                const mobility::Part* part) {
    using R = mobility::Report;
    std::vector<R> reports;
    reports.reserve(studies.size());
    for (const mobility::Study& study : studies) {
        reports.push_back(study.present);
    }
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
    for (const mobility::Study& study : studies) {
        const R& report = study.present;
        fmt::print(
            "\n{}: {}\n", report.model == mobility::Model::Built ? "As built" : "Relaxed",
            part == nullptr ? mobility::describe(report) : mobility::describe(*part, report));
        if (!report.redundantSet.empty()) {
            fmt::print("  Any of {} constraints could go; for example this set of {}:\n",
                       report.removable.size(), report.redundant);
        }
        for (const mobility::ConstraintName& name : report.redundantSet) {
            fmt::print("    {:<28} {:<5} {}  share {:.2f}\n", name.element, name.kind,
                       directionText(name.direction), name.share);
        }
        for (const mobility::IdleFreedom& idle : report.idle) {
            fmt::print("    idle: {}\n", idle.body);
        }
        printMoved(study);
        printLoops(study.loops);
        printReactions(study);
    }
}

/// As built, with the steering joints freed; nothing for a rover that does not steer.
std::optional<mobility::Report> withSteeringFreed(
    const project::Project& project, const std::vector<project::Assignment>& assignments) {
    const auto mechanism = project::resolve(project, "", assignments, project::Steering::Free);
    const auto steered = [](const mechanism::Wheel& wheel) { return wheel.steering >= 0; };
    if (!mechanism || std::none_of(mechanism->wheels.begin(), mechanism->wheels.end(), steered)) {
        return std::nullopt;
    }
    return mobility::analyse(*mechanism, mobility::Model::Built);
}

std::vector<std::string> namesOf(const mobility::Part& part) {
    std::vector<std::string> names;
    for (const mechanism::Body& body : part.mechanism.bodies) {
        names.push_back(body.name);
    }
    return names;
}

std::string partTitle(const std::string& rover, const mobility::Part& part) {
    return fmt::format("{}: {}", rover, joined(namesOf(part)));
}

nlohmann::ordered_json partJson(const mobility::Part& part) {
    return {{"bodies", namesOf(part)}, {"held", part.heldBodies()}, {"pieces", part.pieces}};
}

Problem nothingJoins() {
    return {Severity::Critical, "--part", "no joint connects what is named.",
            "Name two bodies that a joint connects, a joint, or a wheel."};
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
    const auto mechanism = project::resolve(
        *project, "", *assignments,
        options.steering == "free" ? project::Steering::Free : project::Steering::Locked);
    printProblems(options.file, mechanism.problems());
    if (!mechanism) {
        return kAnswerIsNo;
    }
    std::optional<mobility::Part> part;
    if (!options.parts.empty()) {
        const auto selection = mobility::selectionOf(*project, *mechanism, options.parts);
        printProblems(options.file, selection.problems());
        if (!selection) {
            return kAnswerIsNo;
        }
        part = mobility::partOf(*mechanism, mobility::drawnStance(*mechanism), *selection);
        if (part->constraints == 0) {
            printProblems(options.file, {nothingJoins()});
            return kAnswerIsNo;
        }
    }
    const auto studyOf = [&](mobility::Model model) {
        return part ? mobility::study(part->mechanism, model, part->stance)
                    : mobility::study(*mechanism, model);
    };
    std::vector<mobility::Study> studies;
    if (options.model != "relaxed") {
        studies.push_back(studyOf(mobility::Model::Built));
    }
    if (options.model != "built") {
        studies.push_back(studyOf(mobility::Model::Relaxed));
    }
    std::optional<mobility::Report> freed;
    if (options.steering != "free" && !part) {
        freed = withSteeringFreed(*project, *assignments);
    }
    if (!options.json) {
        printTable(part ? partTitle(mechanism->name, *part) : mechanism->name, studies,
                   part ? &*part : nullptr);
        if (freed) {
            fmt::print(
                "\nWith steering freed, as built, the Grübler count is {}: --steering free "
                "tells more.\n",
                freed->gruebler);
        }
        return kGood;
    }
    auto document = io::jsonDocument("roverstudio-mobility-1");
    document["rover"] = mechanism->name;
    if (part) {
        document["part"] = partJson(*part);
    }
    if (studies.size() == 1) {
        document.update(io::toJson(studies.front()));
    } else {
        document["models"] = {io::toJson(studies[0]), io::toJson(studies[1])};
    }
    if (freed) {
        document["gruebler_steering_free"] = freed->gruebler;
    }
    fmt::print("{}", io::formatJson(document));
    return kGood;
}

}  // namespace

void addMobilityCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<MobilityOptions>();
    CLI::App* command = app.add_subcommand(
        "mobility",
        "Count and true mobility, redundant constraints, idle freedoms, moved pose, loops");
    command->add_option("FILE", options->file, "Project file (.rover)")->required();
    command->add_option("--model", options->model, "built or relaxed; both when not given")
        ->check(CLI::IsMember({"built", "relaxed"}));
    command->add_option("--steering", options->steering, "locked (default) or free joints")
        ->check(CLI::IsMember({"locked", "free"}));
    command->add_option("--set", options->set, "NAME=VALUE, set a parameter (may be repeated)")
        ->allow_extra_args(false);
    command
        ->add_option(
            "--part", options->parts,
            "Body, joint or wheel: only these and the joints between them (may be repeated)")
        ->allow_extra_args(false);
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = mobilityOf(*options); });
}

}  // namespace roversim
