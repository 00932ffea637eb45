#include "simcore/statics/capability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "simcore/terrain/profiles.h"

namespace simcore::statics {
namespace {

constexpr double kHighest = 4.0;  ///< that is tried, in radii
constexpr double kHeightTolerance = 5e-4;
constexpr double kSlopeTolerance = 0.01 * std::numbers::pi / 180.0;
constexpr double kSteepest = 1.2;     // [rad]
constexpr double kHalfWidth = 50.0;   // of the ground [m]
constexpr double kBeyond = 50.0;      // the ground goes on [m]
constexpr double kSampleStep = 0.25;  // radii

/// Of all wheels on the ground as drawn.
struct Extent {
    double front = -std::numeric_limits<double>::infinity();
    double rear = std::numeric_limits<double>::infinity();
};

Extent extentOf(const mechanism::Mechanism& mechanism) {
    Extent extent;
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        extent.front = std::max(extent.front, wheel.center.x() + wheel.radius);
        extent.rear = std::min(extent.rear, wheel.center.x() - wheel.radius);
    }
    return extent;
}

/// The largest value up to `most` for which it holds; holds(0) is taken for granted.
template <class Holds>
std::pair<double, bool> largest(double most, double tolerance, Holds&& holds) {
    if (holds(most)) {
        return {most, false};
    }
    double low = 0.0;
    double high = most;
    while (high - low > tolerance) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? low : high) = middle;
    }
    return {low, true};
}

bool standsOnSlope(const mechanism::Mechanism& mechanism, const ClimbRequest& request,
                   double slope) {
    const double rise = kBeyond * std::tan(slope) * (request.backwards ? -1.0 : 1.0);
    const terrain::Terrain ground =
        terrain::Terrain::extruded({{-kBeyond, -rise}, {kBeyond, rise}}, -kHalfWidth, kHalfWidth);
    StaticModel model(mechanism, request.joints);
    PoseSolver solver(model, ground);
    const StandingPose pose = solver.settle({});
    if (pose.standing != Standing::Stands) {
        return false;
    }
    const Study study = studyPose(model, pose, std::nullopt, request.backwards, false);
    return study.feasible && study.frictionRequired <= request.friction && study.tipOver > 0.0;
}

}  // namespace

bool climbsStairs(const mechanism::Mechanism& mechanism, const ClimbRequest& request, double height,
                  double tread, int count) {
    const Extent extent = extentOf(mechanism);
    terrain::Profile profile;
    terrain::addPoint(profile, -kBeyond, 0.0);
    terrain::addStairs(profile, 0.0, height, tread, count);
    terrain::addPoint(profile, kBeyond, profile.back().y());
    if (request.backwards) {
        std::reverse(profile.begin(), profile.end());
        for (Eigen::Vector2d& point : profile) {
            point.x() = -point.x();
        }
    }
    const terrain::Terrain ground = terrain::Terrain::extruded(profile, -kHalfWidth, kHalfWidth);
    StaticModel model(mechanism, request.joints);
    PoseSolver solver(model, ground);
    TraverseRequest traverseRequest;
    traverseRequest.backwards = request.backwards;
    traverseRequest.step = kSampleStep;
    const double gap = 0.5 * leastRadius(mechanism);
    traverseRequest.from.x = request.backwards ? -extent.rear + gap : -extent.front - gap;
    traverseRequest.distance = extent.front - extent.rear + tread * (count - 1) + 2.0 * gap;
    const Traverse result = traverse(solver, traverseRequest, [&](const TraverseSample& sample) {
        return !sample.climbs ||
               (sample.study.feasible && sample.study.frictionRequired <= request.friction);
    });
    return result.end == TraverseEnd::Arrived;
}

Capability whatItClimbs(const mechanism::Mechanism& mechanism, const ClimbRequest& request) {
    Capability capability;
    const double highest = kHighest * leastRadius(mechanism);
    std::tie(capability.step, capability.stepLimited) =
        largest(highest, kHeightTolerance,
                [&](double height) { return climbsStairs(mechanism, request, height, 1.0, 1); });
    std::tie(capability.stair, capability.stairLimited) =
        largest(highest, kHeightTolerance, [&](double height) {
            return climbsStairs(mechanism, request, height, request.tread, request.stairs);
        });
    capability.slope = largest(kSteepest, kSlopeTolerance, [&](double slope) {
                           return standsOnSlope(mechanism, request, slope);
                       }).first;
    return capability;
}

}  // namespace simcore::statics
