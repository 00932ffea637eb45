#include "simcore/experiment/terrain_sets.h"

namespace simcore::experiment {
namespace {

using project::Terrain;
using project::TerrainKind;

// Where the features are [m]: the rover stands on level ground first, and leaves it at the end.
constexpr double kStart = 0.9;
constexpr double kLength = 2.6;
constexpr int kProfileFeatures = 5;
constexpr int kFieldFeatures = 30;
constexpr int kGrains = 60;
// Heights and sizes over the wheel's radius (assumed).
constexpr double kMild = 0.5;
constexpr double kFull = 1.0;
constexpr double kField = 0.6;
constexpr double kGrain = 1.2;

Terrain profile(int seed, double wheelRadius) {
    Terrain terrain;
    terrain.kind = TerrainKind::RandomProfile;
    terrain.start = kStart;
    terrain.length = kLength;
    terrain.height = (seed % 2 != 0 ? kMild : kFull) * wheelRadius;
    terrain.count = kProfileFeatures;
    terrain.seed = seed;
    return terrain;
}

Terrain field(int seed, double wheelRadius) {
    Terrain features;
    features.kind = TerrainKind::Random3d;
    features.start = kStart;
    features.length = kLength;
    features.height = kField * wheelRadius;
    features.count = kFieldFeatures;
    features.seed = seed;
    Terrain grains;
    grains.kind = TerrainKind::Particles;
    grains.start = kStart;
    grains.length = kLength;
    grains.radius = kGrain * wheelRadius;
    grains.count = kGrains;
    grains.seed = seed;
    Terrain sum;
    sum.kind = TerrainKind::Sum;
    sum.terrains = {features, grains};
    return sum;
}

}  // namespace

std::string toString(TerrainSet set) {
    return set == TerrainSet::Profiles ? "profiles" : "terrains";
}

Terrain terrainOf(TerrainSet set, int seed, double wheelRadius) {
    return set == TerrainSet::Profiles ? profile(seed, wheelRadius) : field(seed, wheelRadius);
}

}  // namespace simcore::experiment
