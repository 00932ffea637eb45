#pragma once

#include <nlohmann/json.hpp>

#include "simcore/base/problem.h"
#include "simcore/mobility/advisor.h"
#include "simcore/mobility/study.h"

namespace simcore::io {

/// A mobility report as programs read it: keys `model bodies joints{f1..f5} gruebler columns
/// constraint_rows rank mobility redundant removable_constraints[] redundant_set[]
/// idle_freedoms[]`. docs/mobility.md defines them.
nlohmann::ordered_json toJson(const mobility::Report& report);

/// The same with `moved reactions[] loops[]`.
nlohmann::ordered_json toJson(const mobility::Study& study);

/// What the Advisor found: keys `verdict already_exact complete ended searched_moved_pose notes[]
/// built relaxed_in_file proposals[{joints[{name from to ...}] gruebler rank redundant idle ...}]`.
/// docs/mobility.md defines them.
nlohmann::ordered_json toJson(const mobility::Advice& advice);

/// Problems as a list of `severity element reason remedy`.
nlohmann::ordered_json toJson(const Problems& problems);

/// An object with `schema` and `program_version`, the first keys of everything written.
nlohmann::ordered_json jsonDocument(const std::string& schema);

}  // namespace simcore::io
