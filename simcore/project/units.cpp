#include "simcore/project/units.h"

#include <array>
#include <cctype>
#include <numbers>

#include <fmt/format.h>

#include "simcore/base/text.h"

namespace simcore::project {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// The inch is 25.4 mm and the pound 0.45359237 kg by definition (international yard and pound,
// 1959).
constexpr std::array kUnits{
    Unit{"m", Text::mark("length"), 1.0},
    Unit{"dm", Text::mark("length"), 0.1},
    Unit{"cm", Text::mark("length"), 0.01},
    Unit{"mm", Text::mark("length"), 0.001},
    Unit{"km", Text::mark("length"), 1000.0},
    Unit{"in", Text::mark("length"), 0.0254},
    Unit{"kg", Text::mark("mass"), 1.0},
    Unit{"g", Text::mark("mass"), 0.001},
    Unit{"t", Text::mark("mass"), 1000.0},
    Unit{"lb", Text::mark("mass"), 0.45359237},
    Unit{"rad", Text::mark("angle"), 1.0},
    Unit{"deg", Text::mark("angle"), kDegree},
    Unit{"s", Text::mark("time"), 1.0},
    Unit{"ms", Text::mark("time"), 0.001},
    Unit{"min", Text::mark("time"), 60.0},
    Unit{"N", Text::mark("force"), 1.0},
    Unit{"mN", Text::mark("force"), 0.001},
    Unit{"kN", Text::mark("force"), 1000.0},
    Unit{"N*m", Text::mark("torque"), 1.0},
    Unit{"N m", Text::mark("torque"), 1.0},
    Unit{"N*mm", Text::mark("torque"), 0.001},
    Unit{"mN*m", Text::mark("torque"), 0.001},
    Unit{"m/s", Text::mark("speed"), 1.0},
    Unit{"cm/s", Text::mark("speed"), 0.01},
    Unit{"mm/s", Text::mark("speed"), 0.001},
    Unit{"km/h", Text::mark("speed"), 1.0 / 3.6},
    Unit{"m/s^2", Text::mark("acceleration"), 1.0},
    Unit{"rad/s", Text::mark("angular speed"), 1.0},
    Unit{"deg/s", Text::mark("angular speed"), kDegree},
    Unit{"rpm", Text::mark("angular speed"), std::numbers::pi / 30.0},
    Unit{"N/m", Text::mark("stiffness"), 1.0},
    Unit{"N/mm", Text::mark("stiffness"), 1000.0},
    Unit{"kN/m", Text::mark("stiffness"), 1000.0},
    Unit{"N*s/m", Text::mark("damping"), 1.0},
    Unit{"N*m/rad", Text::mark("torsional stiffness"), 1.0},
    Unit{"N*m/deg", Text::mark("torsional stiffness"), 1.0 / kDegree},
    Unit{"N*m*s/rad", Text::mark("torsional damping"), 1.0},
    Unit{"kg*m^2", Text::mark("inertia"), 1.0},
    Unit{"g*cm^2", Text::mark("inertia"), 1e-7},
    Unit{"%", Text::mark("ratio"), 0.01},
    Unit{"-", Text::mark("ratio"), 1.0},
};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) {
        text.remove_prefix(1);
    }
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) {
        text.remove_suffix(1);
    }
    return text;
}

bool isPlainNumber(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789.+-eE") == std::string_view::npos &&
           text.find_first_of("0123456789") != std::string_view::npos;
}

}  // namespace

const Unit* findUnit(std::string_view symbol) {
    for (const Unit& unit : kUnits) {
        if (symbol == unit.symbol) {
            return &unit;
        }
    }
    return nullptr;
}

std::vector<const Unit*> unitsLike(std::string_view symbol) {
    std::vector<const Unit*> units;
    if (const Unit* like = findUnit(symbol)) {
        for (const Unit& unit : kUnits) {
            if (std::string_view(unit.dimension) == like->dimension) {
                units.push_back(&unit);
            }
        }
    }
    return units;
}

std::optional<ValueWithUnit> splitUnit(std::string_view text) {
    text = trimmed(text);
    const Unit* best = nullptr;
    std::string_view bestValue;
    for (const Unit& unit : kUnits) {
        const std::string_view symbol = unit.symbol;
        if (symbol == "-" || text.size() <= symbol.size() || !text.ends_with(symbol)) {
            continue;
        }
        const std::string_view before = text.substr(0, text.size() - symbol.size());
        const std::string_view value = trimmed(before);
        const bool afterBlank = before.size() > value.size();
        if (value.empty() || (!afterBlank && !isPlainNumber(value)) ||
            std::string_view("+-*/^(,").find(value.back()) != std::string_view::npos) {
            continue;
        }
        if (best == nullptr || symbol.size() > std::string_view(best->symbol).size()) {
            best = &unit;
            bestValue = value;
        }
    }
    if (best == nullptr) {
        return std::nullopt;
    }
    return ValueWithUnit{std::string(bestValue), best};
}

std::string whyWrongDimension(std::string_view text, std::string_view dimension) {
    const auto written = splitUnit(text);
    if (!written || written->unit->dimension == dimension) {
        return {};
    }
    return Text::of("'{}' is a {}, but this is a {}", text,
                    Text::translated(written->unit->dimension),
                    Text::translated(std::string(dimension).c_str()));
}

std::string formatIn(double valueSi, std::string_view unit, int digits) {
    const Unit* found = findUnit(unit);
    return fmt::format("{:.{}g}", found ? valueSi / found->factor : valueSi, digits);
}

}  // namespace simcore::project
