#include "simcore/terrain/particles.h"

#include <algorithm>
#include <cmath>

#include "simcore/base/random.h"

namespace simcore::terrain {
namespace {

// Grains settle as flattened mounds, a third as high as wide, as loose soil would (assumed).
constexpr double kFlatness = 1.0 / 3.0;
// A grain rests where the ground is no steeper than this (assumed angle of repose, tan 30 deg).
constexpr double kRepose = 0.577;
constexpr int kMostMoves = 200;

class Ground {
  public:
    explicit Ground(HeightField& field) : field_(field) {}

    double at(int ix, int iy) const {
        ix = std::clamp(ix, 0, field_.nx - 1);
        iy = std::clamp(iy, 0, field_.ny - 1);
        return field_.at(ix, iy);
    }

    /// Steepest way down from a cell within the reach of a grain; {0, 0} where it rests.
    std::pair<int, int> wayDown(int ix, int iy, int reach) const {
        std::pair<int, int> best{0, 0};
        double steepest = kRepose;
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                if (dx == 0 && dy == 0) {
                    continue;
                }
                const double drop = at(ix, iy) - at(ix + dx * reach, iy + dy * reach);
                const double slope = drop / (reach * field_.cell * std::hypot(dx, dy));
                if (slope > steepest) {
                    steepest = slope;
                    best = {dx, dy};
                }
            }
        }
        return best;
    }

    /// A smooth mound: height (1 - r^2/R^2)^2, added to what is there.
    void addMound(double x, double y, double radius, double height) {
        const int reach = static_cast<int>(radius / field_.cell) + 1;
        const int cx = static_cast<int>(std::lround((x - field_.x0) / field_.cell));
        const int cy = static_cast<int>(std::lround((y - field_.y0) / field_.cell));
        for (int ix = std::max(0, cx - reach); ix <= std::min(field_.nx - 1, cx + reach); ++ix) {
            for (int iy = std::max(0, cy - reach); iy <= std::min(field_.ny - 1, cy + reach);
                 ++iy) {
                const double dx = field_.x0 + ix * field_.cell - x;
                const double dy = field_.y0 + iy * field_.cell - y;
                const double rest = 1.0 - (dx * dx + dy * dy) / (radius * radius);
                if (rest > 0.0) {
                    field_.at(ix, iy) += height * rest * rest;
                }
            }
        }
    }

  private:
    HeightField& field_;
};

}  // namespace

void depositParticles(HeightField& field, double start, double length, double radius, int count,
                      int seed) {
    Random random(static_cast<std::uint64_t>(static_cast<std::uint32_t>(seed)));
    Ground ground(field);
    const double yMax = field.y0 + field.cell * (field.ny - 1);
    const int reach = std::max(1, static_cast<int>(0.5 * radius / field.cell));
    for (int grain = 0; grain < count; ++grain) {
        const double size = radius * random.uniform(0.6, 1.4);
        // The whole mound stays beyond the start.
        double x = random.uniform(start + size, std::max(start + size, start + length - size));
        double y = random.uniform(field.y0 + size, yMax - size);
        for (int move = 0; move < kMostMoves; ++move) {
            const int ix = static_cast<int>(std::lround((x - field.x0) / field.cell));
            const int iy = static_cast<int>(std::lround((y - field.y0) / field.cell));
            const auto [dx, dy] = ground.wayDown(ix, iy, reach);
            const double nextX = x + dx * field.cell;
            if ((dx == 0 && dy == 0) || nextX < start + size) {
                break;
            }
            x = nextX;
            y += dy * field.cell;
        }
        ground.addMound(x, y, size, kFlatness * size);
    }
}

}  // namespace simcore::terrain
