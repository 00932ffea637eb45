#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "simcore/statics/capability.h"
#include "simcore/statics/traverse.h"

/// Studies of statics as files: docs/statics.md lists keys and columns.
namespace simcore::io {

/// Keys of a study, without `schema`.
nlohmann::ordered_json toJson(const statics::Study& study);

/// Where a rover stands: place, turns, footholds.
nlohmann::ordered_json toJson(const mechanism::Mechanism& mechanism,
                              const statics::StandingPose& pose);

/// The way over an obstacle: its end, its hardest place, its events.
nlohmann::ordered_json toJson(const statics::Traverse& traverse);

nlohmann::ordered_json toJson(const statics::Capability& capability);

/// One row a sample: UTF-8, comma, one header row.
std::string traverseTable(const mechanism::Mechanism& mechanism, const statics::Traverse& traverse);

}  // namespace simcore::io
