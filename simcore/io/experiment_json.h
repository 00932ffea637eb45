#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "simcore/experiment/comparison.h"
#include "simcore/experiment/experiment.h"
#include "simcore/experiment/verdict.h"

/// Experiments as text: between processes, in journals and for other programs. docs/experiments.md
/// defines every key.
namespace simcore::io {

/// A plan and the rover it is for, in one line.
std::string formatPlan(const experiment::Plan& plan, const project::Project& project);

struct ParsedPlan {
    experiment::Plan plan;
    project::Project project;
};

/// Any text may be given.
Result<ParsedPlan> parsePlan(const std::string& line);

/// One line each; nothing for text that is none.
std::string formatCase(const experiment::Case& what);
std::optional<experiment::Case> parseCase(const std::string& line);
std::string formatOutcome(const experiment::Outcome& outcome);
std::optional<experiment::Outcome> parseOutcome(const std::string& line);

/// Keys `experiment seeds engine dt_s ... runs summary`.
nlohmann::ordered_json toJson(const experiment::Plan& plan,
                              const std::vector<experiment::Outcome>& outcomes,
                              const std::vector<experiment::Comparison>& comparisons);

/// Two runs of one scenario and what came of it. Keys `runs both_completed failed ends_apart_m
/// same_way`, and `slip slip_loaded friction_work energy` with `less` (a controller, or null) and
/// `ratio` (second over first).
nlohmann::ordered_json toJson(const experiment::Outcome& first, const experiment::Outcome& second,
                              const experiment::Verdict& verdict);

/// Tables for a spreadsheet: one row a run, one row a comparison.
std::string runsTable(const std::vector<experiment::Outcome>& outcomes);
std::string summaryTable(const std::vector<experiment::Comparison>& comparisons);

}  // namespace simcore::io
