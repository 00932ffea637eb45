#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "simcore/project/names.h"
#include "simcore/terrain/particles.h"
#include "simcore/terrain/profiles.h"
#include "simcore/terrain/terrain.h"

namespace simcore::terrain {
namespace {

using project::TerrainKind;

// The ground reaches this far behind the start, beyond the travel, and to either side [m].
constexpr double kBehind = 2.5;
constexpr double kBeyond = 3.0;
constexpr double kHalfWidth = 3.0;
// The 3-D generator's field: cell and half width [m].
constexpr double kFieldCell = 0.02;
constexpr double kFieldHalfWidth = 1.5;

struct Numbers {
    double start, height, length, slope, radius;
};

class TerrainMaker {
  public:
    TerrainMaker(const project::Terrain& spec, const project::ParameterValues& parameters,
                 double travel)
        : spec_(spec),
          element_("terrain " + project::nameOf(spec.kind)),
          travel_(travel) {
        n_ = {number(spec.start, parameters, "start"), number(spec.height, parameters, "height"),
              number(spec.length, parameters, "length"),
              number(spec.slope, parameters, "slope", "angle"),
              number(spec.radius, parameters, "radius")};
    }

    Result<Terrain> make() {
        if (!(std::abs(travel_) <= 1000.0)) {
            complain("travel", travel_, -1000.0, 1000.0);
        }
        if (check(); hasCritical(problems_)) {
            return problems_;
        }
        return spec_.kind == TerrainKind::Particles ? makeField() : makeProfile();
    }

    const Problems& problems() {
        check();
        return problems_;
    }

  private:
    /// Where the ground begins [m].
    double begin() const { return std::min(-kBehind, travel_ - kBeyond); }

    double number(const project::Quantity& quantity, const project::ParameterValues& parameters,
                  const char* what, const char* dimension = "length") {
        const auto value =
            project::evaluate(quantity, parameters, element_ + ", " + what, dimension);
        problems_.insert(problems_.end(), value.problems().begin(), value.problems().end());
        return value ? *value : 0.0;
    }

    void complain(const char* what, double value, double low, double high) {
        problems_.push_back(
            {Severity::Critical, element_ + ", " + what,
             fmt::format("{:.6g} is not between {:.6g} and {:.6g}.", value, low, high),
             "Correct it; values are in SI unless a unit is written."});
    }

    void require(const char* what, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            complain(what, value, low, high);
        }
    }

    void check();
    Result<Terrain> makeProfile() const;
    Result<Terrain> makeField() const;

    const project::Terrain& spec_;
    std::string element_;
    double travel_;
    Numbers n_{};
    Problems problems_;
};

void TerrainMaker::check() {
    if (spec_.kind == TerrainKind::Flat) {
        return;
    }
    require("start", n_.start, -2.0, 1000.0);
    constexpr double kThin = 1e-4;
    switch (spec_.kind) {
        case TerrainKind::Ramp:
            require("slope", n_.slope, -1.4, 1.4);
            require("length", n_.length, 0.01, 1000.0);
            break;
        case TerrainKind::Step:
            require("height", n_.height, -2.0, 2.0);
            require("length", n_.length, 0.0, 1000.0);
            if (std::abs(n_.height) < kThin) {
                complain("height", n_.height, kThin, 2.0);
            }
            break;
        case TerrainKind::Stairs:
            require("height", n_.height, kThin, 2.0);
            require("length", n_.length, 0.01, 100.0);
            require("count", spec_.count, 1, 500);
            break;
        case TerrainKind::Sinus:
            require("height", n_.height, kThin, 5.0);
            require("length", n_.length, 0.02, 100.0);
            require("count", spec_.count, 1, 500);
            break;
        case TerrainKind::Circle:
            require("radius", n_.radius, 1e-3, 10.0);
            require("height", n_.height, 0.0, n_.radius);
            require("length", n_.length, 0.0, 100.0);
            require("count", spec_.count, 1, 500);
            break;
        case TerrainKind::RandomProfile:
            require("height", n_.height, kThin, 2.0);
            require("length", n_.length, 0.1, 500.0);
            require("count", spec_.count, 1, 1000);
            break;
        case TerrainKind::Particles:
            require("radius", n_.radius, 0.03, 1.0);
            require("length", n_.length, 3.0 * n_.radius, 50.0);
            require("count", spec_.count, 1, 100000);
            break;
        case TerrainKind::Flat:
            break;
    }
}

Result<Terrain> TerrainMaker::makeProfile() const {
    Profile profile;
    addPoint(profile, std::min(begin(), n_.start - 1.0), 0.0);
    switch (spec_.kind) {
        case TerrainKind::Ramp:
            addRamp(profile, n_.start, n_.slope, n_.length);
            break;
        case TerrainKind::Step:
            addStep(profile, n_.start, n_.height, n_.length);
            break;
        case TerrainKind::Stairs:
            addStairs(profile, n_.start, n_.height, n_.length, spec_.count);
            break;
        case TerrainKind::Sinus:
            addSinus(profile, n_.start, n_.height, n_.length, spec_.count);
            break;
        case TerrainKind::Circle:
            addCircles(profile, n_.start, n_.radius, n_.height > 0.0 ? n_.height : n_.radius,
                       n_.length, spec_.count);
            break;
        case TerrainKind::RandomProfile:
            addRandom(profile, n_.start, n_.length, n_.height, spec_.count, spec_.seed);
            break;
        case TerrainKind::Flat:
        case TerrainKind::Particles:
            break;
    }
    addPoint(profile, std::max({0.0, travel_, profile.back().x()}) + kBeyond, profile.back().y());
    return Terrain::extruded(profile, -kHalfWidth, kHalfWidth);
}

Result<Terrain> TerrainMaker::makeField() const {
    HeightField field;
    field.cell = kFieldCell;
    field.x0 = begin();
    field.y0 = -kFieldHalfWidth;
    field.nx = static_cast<int>((std::max(travel_, n_.start + n_.length) + kBeyond - field.x0) /
                                kFieldCell) +
               1;
    field.ny = static_cast<int>(std::lround(2.0 * kFieldHalfWidth / kFieldCell)) + 1;
    field.heights.assign(static_cast<std::size_t>(field.nx) * static_cast<std::size_t>(field.ny),
                         0.0);
    depositParticles(field, n_.start, n_.length, n_.radius, spec_.count, spec_.seed);
    return Terrain::grid(field.x0, field.y0, field.cell, field.nx, field.ny, field.heights);
}

}  // namespace

Result<Terrain> makeTerrain(const project::Terrain& spec,
                            const project::ParameterValues& parameters, double travel) {
    return TerrainMaker(spec, parameters, travel).make();
}

Problems whyNoTerrain(const project::Terrain& spec, const project::ParameterValues& parameters) {
    return TerrainMaker(spec, parameters, 0.0).problems();
}

}  // namespace simcore::terrain
