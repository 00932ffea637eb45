#pragma once

#include <functional>
#include <string>
#include <vector>

#include "simcore/statics/static_study.h"

namespace simcore::statics {

/// A rover that creeps over the ground from one place to another.
struct TraverseRequest {
    Place from;
    double distance = 1.0;  ///< of the chassis' origin along its heading [m]
    bool backwards = false;
    double step = 0.1;  ///< no wheel moves further between two samples, in radii
    std::optional<ContactSet> contacts;
    bool study = true;  ///< forces and torques too, not only poses
};

/// The rover somewhere on its way.
struct TraverseSample {
    double way = 0.0;       ///< that its wheels have rolled, on average [m]
    double distance = 0.0;  ///< of the chassis' origin along its heading [m]
    StandingPose pose;
    /// Its energy rises: where it falls the rover goes on by itself, whatever the friction.
    bool climbs = false;
    Study study;
    /// What happens here, as "front meets", "front reaches edge", "rear lifts": just before it in
    /// one sample, just after it in the next, which tells it.
    std::vector<std::string> events;
};

enum class TraverseEnd {
    Arrived,
    NoPose,  ///< the last sample is the last pose there is
    Stuck,   ///< the wheels roll on, the rover does not
    Stopped  ///< by who watches
};

std::string toString(TraverseEnd end);

struct Traverse {
    TraverseEnd end = TraverseEnd::Arrived;
    Standing why = Standing::Stands;  ///< of NoPose
    std::vector<TraverseSample> samples;

    /// The largest required friction of the samples that climb; infinite when the rover does not
    /// arrive, or climbs a tenth of a radius of a wheel where no torques hold it [-].
    double frictionRequired() const;
    /// The sample that climbs with the largest required friction.
    std::size_t hardest() const;
    double radius = 0.0;  ///< least of the wheels [m]
};

/// Follows a rover along its own motion: not over a grid in x, since at a wall its front wheel
/// climbs while the chassis hardly moves. Wheels that meet, leave, lift, drop, reach an edge of the
/// ground or leave it are located to 1e-7 m of way.
/// @param watch  is given each sample; false stops
Traverse traverse(PoseSolver& solver, const TraverseRequest& request,
                  const std::function<bool(const TraverseSample&)>& watch = {});

}  // namespace simcore::statics
