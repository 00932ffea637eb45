#include "simcore/terrain/fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/base/random.h"

namespace simcore::terrain {
namespace {

using std::numbers::pi;

struct Range {
    int first, last;
};

Range cellsWithin(double low, double high, double origin, double cell, int count) {
    return {std::max(0, static_cast<int>(std::ceil((low - origin) / cell))),
            std::min(count - 1, static_cast<int>(std::floor((high - origin) / cell)))};
}

/// Calls add(point, dx, dy) for every grid point within `reach` of a place.
template <class Add>
void around(HeightField& field, double x, double y, double reach, Add&& add) {
    const Range xs = cellsWithin(x - reach, x + reach, field.x0, field.cell, field.nx);
    const Range ys = cellsWithin(y - reach, y + reach, field.y0, field.cell, field.ny);
    for (int ix = xs.first; ix <= xs.last; ++ix) {
        for (int iy = ys.first; iy <= ys.last; ++iy) {
            add(field.at(ix, iy), field.x(ix) - x, field.y(iy) - y);
        }
    }
}

/// One wave over (-length/2, length/2), 1 in the middle.
double wave(double distance, double length) {
    return std::abs(distance) < 0.5 * length ? 0.5 * (1.0 + std::cos(2.0 * pi * distance / length))
                                             : 0.0;
}

struct Rock {
    double x, y, radius;
};

/// Number of rocks per square metre by diameter, from the law for covered area.
class RockSizes {
  public:
    RockSizes(double coverage, double smallest, double largest) : smallest_(smallest) {
        const double q = 1.79 + 0.152 / coverage;
        ratio_ = std::pow(largest / smallest, 1.0 / kSteps);
        cumulative_.push_back(0.0);
        double d = smallest;
        for (int i = 0; i < kSteps; ++i) {
            const double next = d * ratio_;
            // All rocks of a step count with its middle diameter.
            const double area = coverage * (std::exp(-q * d) - std::exp(-q * next));
            const double middle = 0.5 * (d + next);
            cumulative_.push_back(cumulative_.back() + area / (0.25 * pi * middle * middle));
            d = next;
        }
    }

    double perSquareMetre() const { return cumulative_.back(); }

    double draw(Random& random) const {
        const double wanted = random.uniform(0.0, cumulative_.back());
        const auto above = std::upper_bound(cumulative_.begin() + 1, cumulative_.end() - 1, wanted);
        const auto step = static_cast<double>(above - cumulative_.begin() - 1);
        const double share = (wanted - *(above - 1)) / (*above - *(above - 1));
        return smallest_ * std::pow(ratio_, step + share);
    }

  private:
    static constexpr int kSteps = 200;
    double smallest_;
    double ratio_ = 1.0;
    std::vector<double> cumulative_;
};

}  // namespace

void addCrossSlope(HeightField& field, double start, double length, double slope) {
    for (int ix = 0; ix < field.nx; ++ix) {
        const double s = std::clamp((field.x(ix) - start) / length, 0.0, 1.0);
        const double rise = std::tan(slope * s * s * (3.0 - 2.0 * s));
        for (int iy = 0; iy < field.ny; ++iy) {
            field.at(ix, iy) += field.y(iy) * rise;
        }
    }
}

void addRandomFeatures(HeightField& field, double start, double length, double height, int count,
                       int seed) {
    Random random(static_cast<std::uint64_t>(static_cast<std::uint32_t>(seed)));
    const double halfWidth = 0.5 * field.cell * (field.ny - 1);
    const double middle = field.y0 + halfWidth;
    // As wide as its share of the ground, less by lot.
    const double share =
        std::min({std::sqrt(2.0 * halfWidth * length / count), 2.0 * halfWidth, length});
    for (int i = 0; i < count; ++i) {
        const double h = height * random.uniform(0.4, 1.0);
        const double size = share * random.uniform(0.5, 1.0);
        const double across = size * random.uniform(0.5, 1.0);
        const double heading = random.uniform(0.0, pi);
        const double reach = 0.5 * std::hypot(size, across);
        const double x =
            random.uniform(start + reach, std::max(start + reach, start + length - reach));
        const double y = middle + random.uniform(-1.0, 1.0) * std::max(0.0, halfWidth - reach);
        const double cosine = std::cos(heading);
        const double sine = std::sin(heading);
        const auto kind = random.next() % 3;
        around(field, x, y, reach, [&](double& z, double dx, double dy) {
            const double u = cosine * dx + sine * dy;
            const double v = cosine * dy - sine * dx;
            if (kind == 0) {  // a block
                z += std::abs(u) <= 0.5 * size && std::abs(v) <= 0.5 * across ? h : 0.0;
            } else if (kind == 1) {  // a wave, ebbing to its sides
                z += h * wave(u, size) * wave(v, across);
            } else {  // a cap of a sphere
                const double base = 0.5 * across;
                const double cap = std::min(h, base);
                const double radius = (base * base + cap * cap) / (2.0 * cap);
                const double rest = radius * radius - u * u - v * v;
                z += u * u + v * v < base * base ? std::sqrt(rest) - (radius - cap) : 0.0;
            }
        });
    }
}

void addRocks(HeightField& field, double start, double length, double radius, double coverage,
              int seed) {
    Random random(static_cast<std::uint64_t>(static_cast<std::uint32_t>(seed)));
    const RockSizes sizes(coverage, 3.0 * field.cell, 2.0 * radius);
    const double yMax = field.y(field.ny - 1);
    const double area = length * (yMax - field.y0);
    std::vector<double> radii(static_cast<std::size_t>(std::lround(sizes.perSquareMetre() * area)));
    for (double& r : radii) {
        r = 0.5 * sizes.draw(random);
    }
    // Large ones first: small ones find room between them.
    std::sort(radii.begin(), radii.end(), std::greater<>());
    // Rocks by square metre or so, to look for overlaps near by only.
    const double bin = std::max(0.1, 2.0 * radius);
    const auto binsX = static_cast<int>(length / bin) + 1;
    const auto binsY = static_cast<int>((yMax - field.y0) / bin) + 1;
    std::vector<std::vector<Rock>> bins(static_cast<std::size_t>(binsX) *
                                        static_cast<std::size_t>(binsY));
    const auto binAt = [&](int ix, int iy) -> std::vector<Rock>& {
        return bins[static_cast<std::size_t>(ix) * static_cast<std::size_t>(binsY) +
                    static_cast<std::size_t>(iy)];
    };
    const auto isFree = [&](const Rock& rock, int ix, int iy) {
        for (int jx = std::max(0, ix - 1); jx <= std::min(binsX - 1, ix + 1); ++jx) {
            for (int jy = std::max(0, iy - 1); jy <= std::min(binsY - 1, iy + 1); ++jy) {
                for (const Rock& other : binAt(jx, jy)) {
                    if (std::hypot(other.x - rock.x, other.y - rock.y) <
                        other.radius + rock.radius) {
                        return false;
                    }
                }
            }
        }
        return true;
    };
    constexpr int kMostTries = 100;
    for (const double r : radii) {
        for (int attempt = 0; attempt < kMostTries; ++attempt) {
            const Rock rock{random.uniform(start + r, start + length - r),
                            random.uniform(field.y0 + r, yMax - r), r};
            const int ix = std::clamp(static_cast<int>((rock.x - start) / bin), 0, binsX - 1);
            const int iy = std::clamp(static_cast<int>((rock.y - field.y0) / bin), 0, binsY - 1);
            if (!isFree(rock, ix, iy)) {
                continue;
            }
            binAt(ix, iy).push_back(rock);
            around(field, rock.x, rock.y, r, [r](double& z, double dx, double dy) {
                z += std::sqrt(std::max(0.0, r * r - dx * dx - dy * dy));
            });
            break;
        }
    }
}

void addProfile(HeightField& field, const Profile& profile, bool left, bool right) {
    for (int ix = 0; ix < field.nx; ++ix) {
        const auto [before, after] = heightsAt(profile, field.x(ix));
        const double height = std::max(before, after);
        for (int iy = 0; iy < field.ny; ++iy) {
            const double y = field.y(iy);
            if ((left && y >= 0.0) || (right && y <= 0.0)) {
                field.at(ix, iy) += height;
            }
        }
    }
}

void addRaster(HeightField& field, const Raster& raster, double x, double y, double cell,
               double base, double unit) {
    for (int ix = 0; ix < field.nx; ++ix) {
        for (int iy = 0; iy < field.ny; ++iy) {
            const double u = (field.x(ix) - x) / cell;
            const double v = (field.y(iy) - y) / cell;
            if (!(u >= 0.0 && v >= 0.0 && u <= raster.columns - 1.0 && v <= raster.rows - 1.0)) {
                continue;
            }
            const int i = std::min(static_cast<int>(u), raster.columns - 2);
            const int k = std::min(static_cast<int>(v), raster.rows - 2);
            const double s = u - i;
            const double t = v - k;
            const auto value = [&](int column, int up) {
                return raster.at(column, raster.rows - 1 - up);
            };
            const double mean = (1.0 - s) * ((1.0 - t) * value(i, k) + t * value(i, k + 1)) +
                                s * ((1.0 - t) * value(i + 1, k) + t * value(i + 1, k + 1));
            if (std::isfinite(mean)) {
                field.at(ix, iy) += base + unit * mean;
            }
        }
    }
}

void mirrorLeftHalf(HeightField& field) {
    for (int ix = 0; ix < field.nx; ++ix) {
        for (int iy = 0; iy < field.ny / 2; ++iy) {
            field.at(ix, iy) = field.at(ix, field.ny - 1 - iy);
        }
    }
}

}  // namespace simcore::terrain
