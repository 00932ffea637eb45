#include "simcore/project/names.h"

#include <array>
#include <span>
#include <utility>

namespace simcore::project {
namespace {

template <class Enum>
using Entry = std::pair<Enum, const char*>;

constexpr std::array<Entry<ShapeKind>, 4> kShapes{{{ShapeKind::Box, "box"},
                                                   {ShapeKind::Cylinder, "cylinder"},
                                                   {ShapeKind::Sphere, "sphere"},
                                                   {ShapeKind::Bar, "bar"}}};
constexpr std::array<Entry<TerrainKind>, 16> kTerrains{
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
constexpr std::array<Entry<Sides>, 3> kSides{
    {{Sides::Both, "both"}, {Sides::Left, "left"}, {Sides::Right, "right"}}};
constexpr std::array<Entry<UpAxis>, 2> kUpAxes{{{UpAxis::Z, "z"}, {UpAxis::Y, "y"}}};
constexpr std::array<Entry<ControllerKind>, 7> kControllers{
    {{ControllerKind::Speed, "speed"},
     {ControllerKind::Synchronised, "synchronised"},
     {ControllerKind::CommonIntegral, "common-integral"},
     {ControllerKind::EqualTorque, "equal-torque"},
     {ControllerKind::Torque, "torque"},
     {ControllerKind::Hybrid, "hybrid"},
     {ControllerKind::Manual, "manual"}}};
constexpr std::array<Entry<SteeringMode>, 3> kSteering{{{SteeringMode::Auto, "auto"},
                                                        {SteeringMode::Skid, "skid"},
                                                        {SteeringMode::Ackermann, "ackermann"}}};
constexpr std::array<Entry<EngineKind>, 2> kEngines{
    {{EngineKind::Ode, "ode"}, {EngineKind::Reduced, "reduced"}}};

constexpr std::span<const Entry<ShapeKind>> tableOf(ShapeKind /*any*/) {
    return kShapes;
}

constexpr std::span<const Entry<TerrainKind>> tableOf(TerrainKind /*any*/) {
    return kTerrains;
}

constexpr std::span<const Entry<Sides>> tableOf(Sides /*any*/) {
    return kSides;
}

constexpr std::span<const Entry<UpAxis>> tableOf(UpAxis /*any*/) {
    return kUpAxes;
}

constexpr std::span<const Entry<ControllerKind>> tableOf(ControllerKind /*any*/) {
    return kControllers;
}

constexpr std::span<const Entry<SteeringMode>> tableOf(SteeringMode /*any*/) {
    return kSteering;
}

constexpr std::span<const Entry<EngineKind>> tableOf(EngineKind /*any*/) {
    return kEngines;
}

}  // namespace

template <class Enum>
std::string nameOf(Enum value) {
    for (const auto& [enumerator, name] : tableOf(value)) {
        if (enumerator == value) {
            return name;
        }
    }
    return {};
}

template <class Enum>
std::optional<Enum> fromName(std::string_view name) {
    for (const auto& [enumerator, text] : tableOf(Enum{})) {
        if (name == text) {
            return enumerator;
        }
    }
    return std::nullopt;
}

template <class Enum>
std::vector<std::string> allNames() {
    std::vector<std::string> names;
    for (const auto& [enumerator, text] : tableOf(Enum{})) {
        names.emplace_back(text);
    }
    return names;
}

template std::string nameOf(ShapeKind);
template std::optional<ShapeKind> fromName(std::string_view);
template std::vector<std::string> allNames<ShapeKind>();
template std::string nameOf(TerrainKind);
template std::optional<TerrainKind> fromName(std::string_view);
template std::vector<std::string> allNames<TerrainKind>();
template std::string nameOf(Sides);
template std::optional<Sides> fromName(std::string_view);
template std::vector<std::string> allNames<Sides>();
template std::string nameOf(UpAxis);
template std::optional<UpAxis> fromName(std::string_view);
template std::vector<std::string> allNames<UpAxis>();
template std::string nameOf(ControllerKind);
template std::optional<ControllerKind> fromName(std::string_view);
template std::vector<std::string> allNames<ControllerKind>();
template std::string nameOf(SteeringMode);
template std::optional<SteeringMode> fromName(std::string_view);
template std::vector<std::string> allNames<SteeringMode>();
template std::string nameOf(EngineKind);
template std::optional<EngineKind> fromName(std::string_view);
template std::vector<std::string> allNames<EngineKind>();

}  // namespace simcore::project
