#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "simcore/run/simulation.h"

namespace simcore::io {

/// The report of a run as programs read it: keys `engine dt steps sim_time_s wall_s rtf completed
/// stop_reason ... penetration_max_mm`, `wheels` in file order. docs/run-report.md defines them.
/// Numbers that are not finite become null.
nlohmann::ordered_json toJson(const run::RunReport& report);

/// The report in this text as toJson() writes it; what is missing or of another kind keeps its
/// default. Any text may be given.
run::RunReport parseReport(const std::string& text);

}  // namespace simcore::io
