#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simcore/project/project.h"

/// The words used for enumerators in files and on the command line.
namespace simcore::project {

/// E.g. "random-profile", "equal-torque", "bar".
std::string nameOf(ShapeKind kind);
std::string nameOf(TerrainKind kind);
std::string nameOf(Sides sides);
std::string nameOf(UpAxis axis);
std::string nameOf(ControllerKind kind);

/// The enumerator with that name, or nothing.
template <class Enum>
std::optional<Enum> fromName(std::string_view name);
template <>
std::optional<ShapeKind> fromName<ShapeKind>(std::string_view name);
template <>
std::optional<TerrainKind> fromName<TerrainKind>(std::string_view name);
template <>
std::optional<Sides> fromName<Sides>(std::string_view name);
template <>
std::optional<UpAxis> fromName<UpAxis>(std::string_view name);
template <>
std::optional<ControllerKind> fromName<ControllerKind>(std::string_view name);

/// All names of an enumeration, for messages and choosers.
template <class Enum>
std::vector<std::string> allNames();
template <>
std::vector<std::string> allNames<ShapeKind>();
template <>
std::vector<std::string> allNames<TerrainKind>();
template <>
std::vector<std::string> allNames<Sides>();
template <>
std::vector<std::string> allNames<UpAxis>();
template <>
std::vector<std::string> allNames<ControllerKind>();

}  // namespace simcore::project
