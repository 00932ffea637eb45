#include "simcore/terrain/make_terrain.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "simcore/base/text.h"
#include "simcore/project/names.h"
#include "simcore/project/units.h"
#include "simcore/terrain/fields.h"
#include "simcore/terrain/mesh_check.h"
#include "simcore/terrain/particles.h"
#include "simcore/terrain/profiles.h"

namespace simcore::terrain {
namespace {

using project::Sides;
using project::TerrainKind;

// The ground reaches this far behind the start, beyond the travel, and to either side [m].
constexpr double kBehind = 2.5;
constexpr double kBeyond = 3.0;
constexpr double kHalfWidth = 3.0;
// Full 3-D ground: cell, when none is given, and half width [m].
constexpr double kFieldCell = 0.02;
constexpr double kFieldHalfWidth = 1.5;

/// One generator or file of a terrain: its numbers, what is wrong with them, and its heights.
class Part {
  public:
    Part(const project::Terrain& spec, const project::ParameterValues& parameters,
         std::string element)
        : spec_(spec),
          element_(std::move(element)),
          parameters_(parameters) {
        start_ = number(spec.start, Text::mark("start"));
        height_ = number(spec.height, Text::mark("height"));
        length_ = number(spec.length, Text::mark("length"));
        slope_ = number(spec.slope, Text::mark("slope"), "angle");
        radius_ = number(spec.radius, Text::mark("radius"));
        coverage_ = number(spec.coverage, Text::mark("coverage"), "ratio");
        cell_ = number(spec.cell, Text::mark("cell"));
        scale_ = number(spec.scale, Text::mark("scale"), "ratio");
        for (std::size_t i = 0; i < 3; ++i) {
            origin_[static_cast<Eigen::Index>(i)] = number(spec.origin[i], Text::mark("origin"));
        }
        check();
    }

    const Problems& problems() const { return problems_; }

    const std::string& element() const { return element_; }

    TerrainKind kind() const { return spec_.kind; }

    bool isRaster() const {
        return kind() == TerrainKind::Image || kind() == TerrainKind::AsciiGrid;
    }

    /// Made of heights on a grid, not of a polyline.
    bool isField() const {
        return isRaster() || kind() == TerrainKind::CrossSlope || kind() == TerrainKind::Random3d ||
               kind() == TerrainKind::Particles || kind() == TerrainKind::RockField;
    }

    bool touches(Sides side) const { return spec_.sides == Sides::Both || spec_.sides == side; }

    double start() const { return start_; }

    double fieldCell() const { return cell_ > 0.0 && !isRaster() ? cell_ : kFieldCell; }

    /// Where a field's last feature ends [m].
    double fieldEnd() const { return isRaster() ? 0.0 : start_ + length_; }

    /// Adds the features of a polyline to it.
    void addTo(Profile& profile) const;
    /// Adds what is not a polyline.
    void addTo(HeightField& field, const Imports& imports) const;

    Result<Terrain> makeRaster(const Imports& imports) const;
    Result<Terrain> makeMesh(const Imports& imports) const;
    Problems whyNotPlaced(const Imports& imports) const;

  private:
    std::string whereIs(const char* what) const { return element_ + ", " + Text::translated(what); }

    /// @param what  marked
    double number(const project::Quantity& quantity, const char* what,
                  const char* dimension = "length") {
        const auto value = project::evaluate(quantity, parameters_, {}, dimension);
        for (Problem problem : value.problems()) {
            problem.element = whereIs(what);
            appendNew(problems_, {problem});
        }
        return value ? *value : 0.0;
    }

    void complain(const char* what, double value, double low, double high) {
        problems_.push_back({Severity::Critical, whereIs(what),
                             Text::of("{:.6g} is not between {:.6g} and {:.6g}.", value, low, high),
                             Text::of("Correct it; values are in SI unless a unit is written.")});
    }

    void require(const char* what, double value, double low, double high) {
        if (!(value >= low && value <= high)) {
            complain(what, value, low, high);
        }
    }

    void check();
    void checkFile();

    /// How long the file's unit is, scale included [m].
    double fileUnit() const {
        const project::Unit* unit = project::findUnit(spec_.units);
        return scale_ * (unit != nullptr ? unit->factor : 1.0);
    }

    /// A raster's lower left point and its scale in the world.
    struct Placed {
        double x, y, cell, base, unit;
    };

    Placed place(const Raster& raster) const {
        if (kind() == TerrainKind::Image) {
            return {origin_.x(), origin_.y(), cell_, origin_.z(), height_};
        }
        const double unit = fileUnit();
        return {origin_.x() + unit * raster.x0, origin_.y() + unit * raster.y0, unit * raster.cell,
                origin_.z(), unit};
    }

    const project::Terrain& spec_;
    std::string element_;
    const project::ParameterValues& parameters_;
    double start_ = 0.0, height_ = 0.0, length_ = 0.0, slope_ = 0.0, radius_ = 0.0;
    double coverage_ = 0.0, cell_ = 0.0, scale_ = 1.0;
    Vec3 origin_ = Vec3::Zero();
    Problems problems_;
};

void Part::check() {
    if (isRaster() || kind() == TerrainKind::Mesh) {
        checkFile();
        return;
    }
    if (kind() == TerrainKind::Flat || kind() == TerrainKind::Sum) {
        return;
    }
    require(Text::mark("start"), start_, -2.0, 1000.0);
    if (isField()) {
        require(Text::mark("cell"), fieldCell(), 0.001, 0.5);
    }
    constexpr double kThin = 1e-4;
    switch (kind()) {
        case TerrainKind::Ramp:
            require(Text::mark("slope"), slope_, -1.4, 1.4);
            require(Text::mark("length"), length_, 0.01, 1000.0);
            break;
        case TerrainKind::CrossSlope:
            require(Text::mark("slope"), slope_, -1.0, 1.0);
            require(Text::mark("length"), length_, 0.1, 50.0);
            break;
        case TerrainKind::Step:
            require(Text::mark("height"), height_, -2.0, 2.0);
            require(Text::mark("length"), length_, 0.0, 1000.0);
            if (std::abs(height_) < kThin) {
                complain(Text::mark("height"), height_, kThin, 2.0);
            }
            break;
        case TerrainKind::Stairs:
            require(Text::mark("height"), height_, kThin, 2.0);
            require(Text::mark("length"), length_, 0.01, 100.0);
            require(Text::mark("count"), spec_.count, 1, 500);
            break;
        case TerrainKind::Trench:
            require(Text::mark("height"), height_, kThin, 2.0);
            require(Text::mark("length"), length_, 0.001, 100.0);
            break;
        case TerrainKind::Sinus:
            require(Text::mark("height"), height_, kThin, 5.0);
            require(Text::mark("length"), length_, 0.02, 100.0);
            require(Text::mark("count"), spec_.count, 1, 500);
            break;
        case TerrainKind::Circle:
            require(Text::mark("radius"), radius_, 1e-3, 10.0);
            require(Text::mark("height"), height_, 0.0, radius_);
            require(Text::mark("length"), length_, 0.0, 100.0);
            require(Text::mark("count"), spec_.count, 1, 500);
            break;
        case TerrainKind::RandomProfile:
            require(Text::mark("height"), height_, kThin, 2.0);
            require(Text::mark("length"), length_, 0.1, 500.0);
            require(Text::mark("count"), spec_.count, 1, 1000);
            break;
        case TerrainKind::Random3d:
            require(Text::mark("height"), height_, kThin, 2.0);
            require(Text::mark("length"), length_, 0.1, 50.0);
            require(Text::mark("count"), spec_.count, 1, 10000);
            break;
        case TerrainKind::Particles:
            require(Text::mark("radius"), radius_, 1.5 * fieldCell(), 1.0);
            require(Text::mark("length"), length_, 3.0 * radius_, 50.0);
            require(Text::mark("count"), spec_.count, 1, 100000);
            break;
        case TerrainKind::RockField:
            require(Text::mark("radius"), radius_, 2.0 * fieldCell(), 1.0);
            require(Text::mark("length"), length_, 3.0 * radius_, 50.0);
            require(Text::mark("coverage"), coverage_, 0.005, 0.4);
            break;
        default:
            break;
    }
}

void Part::checkFile() {
    for (const double coordinate : origin_) {
        require(Text::mark("origin"), coordinate, -1e7, 1e7);
    }
    if (kind() == TerrainKind::Image) {
        require(Text::mark("cell"), cell_, 0.001, 10.0);
        require(Text::mark("height"), height_, 0.0, 1000.0);
        return;
    }
    require(Text::mark("scale"), scale_, 1e-6, 1e6);
    const project::Unit* unit = project::findUnit(spec_.units);
    if (unit == nullptr || std::string_view(unit->dimension) != "length") {
        problems_.push_back({Severity::Critical, element_ + ", " + Text::of("units"),
                             Text::of("'{}' is no unit of length.", spec_.units),
                             Text::of("Use one of: m, dm, cm, mm, km, in.")});
    }
}

void Part::addTo(Profile& profile) const {
    switch (kind()) {
        case TerrainKind::Ramp:
            addRamp(profile, start_, slope_, length_);
            break;
        case TerrainKind::Step:
            addStep(profile, start_, height_, length_);
            break;
        case TerrainKind::Stairs:
            addStairs(profile, start_, height_, length_, spec_.count);
            break;
        case TerrainKind::Trench:
            addStep(profile, start_, -height_, length_);
            break;
        case TerrainKind::Sinus:
            addSinus(profile, start_, height_, length_, spec_.count);
            break;
        case TerrainKind::Circle:
            addCircles(profile, start_, radius_, height_ > 0.0 ? height_ : radius_, length_,
                       spec_.count);
            break;
        case TerrainKind::RandomProfile:
            addRandom(profile, start_, length_, height_, spec_.count, spec_.seed);
            break;
        default:
            break;  // flat, or no polyline
    }
}

void Part::addTo(HeightField& field, const Imports& imports) const {
    if (isRaster()) {
        const Raster& raster = imports.rasters.at(spec_.file);
        const Placed p = place(raster);
        addRaster(field, raster, p.x, p.y, p.cell, p.base, p.unit);
        return;
    }
    HeightField own = field;
    std::fill(own.heights.begin(), own.heights.end(), 0.0);
    if (kind() == TerrainKind::CrossSlope) {
        addCrossSlope(own, start_, length_, slope_);
    } else if (kind() == TerrainKind::Random3d) {
        addRandomFeatures(own, start_, length_, height_, spec_.count, spec_.seed);
    } else if (kind() == TerrainKind::Particles) {
        depositParticles(own, start_, length_, radius_, spec_.count, spec_.seed);
    } else {
        addRocks(own, start_, length_, radius_, coverage_, spec_.seed);
    }
    if (spec_.symmetric) {
        mirrorLeftHalf(own);
    }
    for (std::size_t i = 0; i < own.heights.size(); ++i) {
        field.heights[i] += own.heights[i];
    }
}

/// Why the points of a raster cannot be ground where its file and the scenario put them.
Problems Part::whyNotPlaced(const Imports& imports) const {
    constexpr double kClosest = 1e-4;  // [m], assumed: finer than any wheel feels
    const Raster& raster = imports.rasters.at(spec_.file);
    const Placed p = place(raster);
    double farthest = 0.0;
    const auto reach = [&farthest](double coordinate) {
        farthest = std::max(farthest, std::abs(coordinate));
    };
    reach(p.x);
    reach(p.y);
    reach(p.x + p.cell * (raster.columns - 1));
    reach(p.y + p.cell * (raster.rows - 1));
    for (const double value : raster.values) {
        reach(std::isnan(value) ? 0.0 : p.base + p.unit * value);
    }
    if (!(farthest <= kFarthestGround) || !(p.cell >= kClosest)) {
        return {
            {Severity::Critical, element_ + ", " + Text::of("file"),
             Text::of("its points are {:.6g} m apart and up to {:.6g} m away.", p.cell, farthest),
             Text::of("Check the file, its units, scale and origin: {} m apart at least, {} m "
                      "away at most.",
                      kClosest, kFarthestGround)}};
    }
    return {};
}

Result<Terrain> Part::makeRaster(const Imports& imports) const {
    const Raster& raster = imports.rasters.at(spec_.file);
    const Placed p = place(raster);
    HeightField field{p.x, p.y, p.cell, raster.columns, raster.rows, {}};
    field.heights.resize(raster.values.size());
    bool solid = false;  // a cell with all four corners
    for (int ix = 0; ix < field.nx; ++ix) {
        for (int iy = 0; iy < field.ny; ++iy) {
            field.at(ix, iy) = p.base + p.unit * raster.at(ix, field.ny - 1 - iy);
            solid = solid || (ix > 0 && iy > 0 &&
                              std::isfinite(field.at(ix, iy) + field.at(ix - 1, iy) +
                                            field.at(ix, iy - 1) + field.at(ix - 1, iy - 1)));
        }
    }
    if (!solid) {
        return Problem{Severity::Critical, element_ + ", " + Text::of("file"),
                       Text::of("no cell of the grid has a height at all of its corners."),
                       Text::of("Check the file and its value for 'no data'.")};
    }
    return Terrain::grid(field.x0, field.y0, field.cell, field.nx, field.ny, field.heights);
}

Result<Terrain> Part::makeMesh(const Imports& imports) const {
    TriangleMesh mesh = imports.meshes.at(spec_.file);
    const double unit = fileUnit();
    for (Vec3& v : mesh.vertices) {
        const Vec3 up = spec_.up == project::UpAxis::Z ? v : Vec3(v.x(), -v.z(), v.y());
        v = origin_ + unit * up;
    }
    auto clean = cleanMesh(mesh, element_);
    if (!clean) {
        return clean.problems();
    }
    Problems warnings = clean.problems();
    return Result<Terrain>(Terrain::fromMesh(std::move(clean).value()), std::move(warnings));
}

class TerrainMaker {
  public:
    TerrainMaker(const project::Terrain& spec, const project::ParameterValues& parameters,
                 double travel)
        : element_(Text::of("terrain {}", project::nameOf(spec.kind))),
          travel_(travel) {
        if (spec.kind != TerrainKind::Sum) {
            parts_.emplace_back(spec, parameters, element_);
        }
        for (std::size_t i = 0; spec.kind == TerrainKind::Sum && i < spec.terrains.size(); ++i) {
            const project::Terrain& part = spec.terrains[i];
            parts_.emplace_back(part, parameters,
                                fmt::format("{}, {} {}", element_, i + 1, nameOf(part.kind)));
        }
        check(spec);
    }

    const Problems& problems() const { return problems_; }

    Result<Terrain> make(const Imports& imports) {
        if (!(std::abs(travel_) <= 1000.0)) {
            problems_.push_back({Severity::Critical, element_ + ", " + Text::of("travel"),
                                 Text::of("{:.6g} m is more than 1000 m.", travel_),
                                 Text::of("Shorten the run's distance.")});
        }
        for (const Part& part : parts_) {
            if (part.isRaster() && !hasCritical(problems_)) {
                appendNew(problems_, part.whyNotPlaced(imports));
            }
        }
        if (hasCritical(problems_)) {
            return problems_;
        }
        if (parts_.size() == 1 && parts_[0].isRaster()) {
            return parts_[0].makeRaster(imports);
        }
        if (parts_.size() == 1 && parts_[0].kind() == TerrainKind::Mesh) {
            return parts_[0].makeMesh(imports);
        }
        const bool field = std::any_of(parts_.begin(), parts_.end(),
                                       [](const Part& part) { return part.isField(); });
        return field ? makeField(imports) : makeProfile();
    }

  private:
    void check(const project::Terrain& spec) {
        for (const Part& part : parts_) {
            appendNew(problems_, part.problems());
        }
        if (spec.kind != TerrainKind::Sum) {
            return;
        }
        constexpr std::size_t kMostParts = 50;
        if (parts_.empty() || parts_.size() > kMostParts) {
            problems_.push_back({Severity::Critical, element_ + ", " + Text::of("terrains"),
                                 Text::of("{} terrains are added.", parts_.size()),
                                 Text::of("Give 1 to {}.", kMostParts)});
        }
        for (const Part& part : parts_) {
            if (part.kind() == TerrainKind::Sum || part.kind() == TerrainKind::Mesh) {
                problems_.push_back(
                    {Severity::Critical, part.element(),
                     Text::of("a sum and a mesh cannot be added to others."),
                     Text::of("List the terrains of the inner sum; use a mesh alone.")});
            }
        }
    }

    /// Where the ground begins [m].
    double begin() const { return std::min(-kBehind, travel_ - kBeyond); }

    Profile profileOf(const Part& part) const {
        Profile profile;
        addPoint(profile, std::min(begin(), part.start() - 1.0), 0.0);
        part.addTo(profile);
        addPoint(profile, std::max({0.0, travel_, profile.back().x()}) + kBeyond,
                 profile.back().y());
        return profile;
    }

    Result<Terrain> makeProfile() const {
        std::vector<Profile> left;
        std::vector<Profile> right;
        // Under both sides, so that both are as long.
        Profile longest{{begin(), 0.0}, {std::max(0.0, travel_) + kBeyond, 0.0}};
        for (const Part& part : parts_) {
            Profile profile = profileOf(part);
            longest.front().x() = std::min(longest.front().x(), profile.front().x());
            longest.back().x() = std::max(longest.back().x(), profile.back().x());
            if (part.touches(Sides::Left)) {
                left.push_back(profile);
            }
            if (part.touches(Sides::Right)) {
                right.push_back(std::move(profile));
            }
        }
        if (parts_.size() == 1 && left.size() == right.size()) {
            return Terrain::extruded(left.front(), -kHalfWidth, kHalfWidth);
        }
        left.push_back(longest);
        right.push_back(longest);
        const Profile leftSum = sum(left);
        const Profile rightSum = sum(right);
        if (leftSum == rightSum) {
            return Terrain::extruded(leftSum, -kHalfWidth, kHalfWidth);
        }
        return Terrain::fromMesh(meshOfSides(leftSum, rightSum, kHalfWidth));
    }

    Result<Terrain> makeField(const Imports& imports) const {
        HeightField field;
        field.cell = 1.0;
        double end = travel_;
        std::vector<Profile> profiles;  // of each part, empty for fields
        for (const Part& part : parts_) {
            field.cell = std::min(field.cell, part.isField() ? part.fieldCell() : field.cell);
            profiles.push_back(part.isField() ? Profile{} : profileOf(part));
            end = std::max(end,
                           part.isField() ? part.fieldEnd() : profiles.back().back().x() - kBeyond);
        }
        field.x0 = begin();
        field.y0 = -kFieldHalfWidth;
        const double columns = (end + kBeyond - field.x0) / field.cell + 1.0;
        field.ny = static_cast<int>(std::lround(2.0 * kFieldHalfWidth / field.cell)) + 1;
        if (columns * field.ny > static_cast<double>(kMostRasterPoints)) {
            return Problem{Severity::Critical, element_ + ", " + Text::of("cell"),
                           Text::of("cells of {:.6g} m give {:.0f} x {} points.", field.cell,
                                    columns, field.ny),
                           Text::of("Choose larger cells or a shorter way: at most {} points.",
                                    kMostRasterPoints)};
        }
        field.nx = static_cast<int>(columns);
        field.heights.assign(
            static_cast<std::size_t>(field.nx) * static_cast<std::size_t>(field.ny), 0.0);
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Part& part = parts_[i];
            if (part.isField()) {
                part.addTo(field, imports);
            } else {
                addProfile(field, profiles[i], part.touches(Sides::Left),
                           part.touches(Sides::Right));
            }
        }
        return Terrain::grid(field.x0, field.y0, field.cell, field.nx, field.ny, field.heights);
    }

    std::string element_;
    double travel_;
    std::vector<Part> parts_;
    Problems problems_;
};

}  // namespace

Result<Terrain> makeTerrain(const project::Terrain& spec,
                            const project::ParameterValues& parameters, double travel,
                            const Imports& imports) {
    return TerrainMaker(spec, parameters, travel).make(imports);
}

Problems whyNoTerrain(const project::Terrain& spec, const project::ParameterValues& parameters) {
    return TerrainMaker(spec, parameters, 0.0).problems();
}

}  // namespace simcore::terrain
