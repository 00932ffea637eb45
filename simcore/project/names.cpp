#include "simcore/project/names.h"

#include <array>
#include <utility>

namespace simcore::project {
namespace {

template <class Enum>
using Table = std::pair<Enum, const char*>;

constexpr std::array<Table<ShapeKind>, 4> kShapes{{{ShapeKind::Box, "box"},
                                                   {ShapeKind::Cylinder, "cylinder"},
                                                   {ShapeKind::Sphere, "sphere"},
                                                   {ShapeKind::Bar, "bar"}}};
constexpr std::array<Table<TerrainKind>, 16> kTerrains{
    {{TerrainKind::Flat, "flat"},
     {TerrainKind::Ramp, "ramp"},
     {TerrainKind::CrossSlope, "cross-slope"},
     {TerrainKind::Step, "step"},
     {TerrainKind::Stairs, "stairs"},
     {TerrainKind::Trench, "trench"},
     {TerrainKind::Sinus, "sinus"},
     {TerrainKind::Circle, "circle"},
     {TerrainKind::RandomProfile, "random-profile"},
     {TerrainKind::Random3d, "random-3d"},
     {TerrainKind::Particles, "particles"},
     {TerrainKind::RockField, "rock-field"},
     {TerrainKind::Sum, "sum"},
     {TerrainKind::Image, "image"},
     {TerrainKind::AsciiGrid, "ascii-grid"},
     {TerrainKind::Mesh, "mesh"}}};
constexpr std::array<Table<Sides>, 3> kSides{
    {{Sides::Both, "both"}, {Sides::Left, "left"}, {Sides::Right, "right"}}};
constexpr std::array<Table<UpAxis>, 2> kUpAxes{{{UpAxis::Z, "z"}, {UpAxis::Y, "y"}}};
constexpr std::array<Table<ControllerKind>, 3> kControllers{
    {{ControllerKind::Speed, "speed"},
     {ControllerKind::EqualTorque, "equal-torque"},
     {ControllerKind::Manual, "manual"}}};

template <class Enum, std::size_t N>
std::string nameIn(const std::array<Table<Enum>, N>& table, Enum value) {
    for (const auto& [enumerator, name] : table) {
        if (enumerator == value) {
            return name;
        }
    }
    return {};
}

template <class Enum, std::size_t N>
std::optional<Enum> findIn(const std::array<Table<Enum>, N>& table, std::string_view name) {
    for (const auto& [enumerator, text] : table) {
        if (name == text) {
            return enumerator;
        }
    }
    return std::nullopt;
}

template <class Enum, std::size_t N>
std::vector<std::string> namesOf(const std::array<Table<Enum>, N>& table) {
    std::vector<std::string> names;
    names.reserve(N);
    for (const auto& entry : table) {
        names.emplace_back(entry.second);
    }
    return names;
}

}  // namespace

std::string nameOf(ShapeKind kind) {
    return nameIn(kShapes, kind);
}

std::string nameOf(TerrainKind kind) {
    return nameIn(kTerrains, kind);
}

std::string nameOf(Sides sides) {
    return nameIn(kSides, sides);
}

std::string nameOf(UpAxis axis) {
    return nameIn(kUpAxes, axis);
}

std::string nameOf(ControllerKind kind) {
    return nameIn(kControllers, kind);
}

template <>
std::optional<ShapeKind> fromName<ShapeKind>(std::string_view name) {
    return findIn(kShapes, name);
}

template <>
std::optional<TerrainKind> fromName<TerrainKind>(std::string_view name) {
    return findIn(kTerrains, name);
}

template <>
std::optional<Sides> fromName<Sides>(std::string_view name) {
    return findIn(kSides, name);
}

template <>
std::optional<UpAxis> fromName<UpAxis>(std::string_view name) {
    return findIn(kUpAxes, name);
}

template <>
std::optional<ControllerKind> fromName<ControllerKind>(std::string_view name) {
    return findIn(kControllers, name);
}

template <>
std::vector<std::string> allNames<ShapeKind>() {
    return namesOf(kShapes);
}

template <>
std::vector<std::string> allNames<TerrainKind>() {
    return namesOf(kTerrains);
}

template <>
std::vector<std::string> allNames<Sides>() {
    return namesOf(kSides);
}

template <>
std::vector<std::string> allNames<UpAxis>() {
    return namesOf(kUpAxes);
}

template <>
std::vector<std::string> allNames<ControllerKind>() {
    return namesOf(kControllers);
}

}  // namespace simcore::project
