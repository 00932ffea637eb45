#pragma once

#include <nlohmann/json.hpp>

#include "simcore/run/simulation.h"

namespace simcore::io {

/// The report of a run as programs read it: keys `engine dt steps sim_time_s wall_s rtf completed
/// stop_reason ... penetration_max_mm`, `wheels` in file order. docs/run-report.md defines them.
/// Numbers that are not finite become null.
nlohmann::ordered_json toJson(const run::RunReport& report);

}  // namespace simcore::io
