#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simcore/project/project.h"

/// The words used for enumerators in files and on the command line: of ShapeKind, TerrainKind,
/// Sides, UpAxis, ControllerKind, SteeringMode and EngineKind.
namespace simcore::project {

/// E.g. "random-profile", "equal-torque", "bar".
template <class Enum>
std::string nameOf(Enum value);

/// The enumerator with that name, or nothing.
template <class Enum>
std::optional<Enum> fromName(std::string_view name);

/// All names of an enumeration, for messages and choosers.
template <class Enum>
std::vector<std::string> allNames();

}  // namespace simcore::project
