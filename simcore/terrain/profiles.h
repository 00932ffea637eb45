#pragma once

#include <utility>
#include <vector>

#include "simcore/terrain/terrain.h"

/// Polylines in x-z of the obstacles of the paper (step, sinus, circle, sums of them) and of common
/// ones. A profile ends where its last feature ends; heights are relative to the ground there.
namespace simcore::terrain {

using Profile = std::vector<Eigen::Vector2d>;

/// Largest distance of a curve from its polyline [m].
inline constexpr double kChordError = 1e-4;

void addPoint(Profile& profile, double x, double z);

/// A vertical face up by `height` at x; with `length` > 0 a vertical face down after that length.
void addStep(Profile& profile, double x, double height, double length);

/// A straight rise at `slope` [rad] over the horizontal `run`.
void addRamp(Profile& profile, double x, double slope, double run);

/// `count` vertical risers of `height`, each followed by a tread of `length`.
void addStairs(Profile& profile, double x, double height, double length, int count);

/// height/2 (1 - cos(2 pi x / wavelength)): starts and ends level.
void addSinus(Profile& profile, double x, double height, double wavelength, int count);

/// Bumps that are half-cylinders of `radius`, or caps of `height` of it, `spacing` apart.
void addCircles(Profile& profile, double x, double radius, double height, double spacing,
                int count);

/// `count` steps, waves and bumps in random order and size between x and x + length, none higher
/// than `height`; the same on both sides of the rover. The paper's type-1 ground.
void addRandom(Profile& profile, double x, double length, double height, int count, int seed);

/// Heights just before and just after x; they differ at a vertical face. Level beyond the ends.
std::pair<double, double> heightsAt(const Profile& profile, double x);

/// Heights added, vertical faces included, over the longest of the profiles.
Profile sum(const std::vector<Profile>& profiles);

/// Two profiles of equal range side by side, the left one for y > 0, each `halfWidth` wide, with a
/// wall where they part at y = 0.
TriangleMesh meshOfSides(const Profile& left, const Profile& right, double halfWidth);

}  // namespace simcore::terrain
