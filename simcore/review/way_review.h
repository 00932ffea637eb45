#pragma once

#include <functional>

#include "simcore/review/review.h"
#include "simcore/run/simulation.h"

namespace simcore::review {

/// Whether the way of a scenario asks for something that depends on the rover's pose: steps,
/// stairs, rough ground. Even ground is looked at by review().
bool hasObstacles(const project::Scenario& scenario);

/// Whether friction and motors suffice for what the scenario contains, by statics along its whole
/// way: torques within the motors' limits, no speed, no rolling resistance. A second or so for each
/// scenario with obstacles, so not for every edit. None for a scenario without obstacles, with a
/// variant (another rover), or that cannot be run.
/// @param goOn  asked at every sample of the way; false gives up, with no findings
std::vector<Finding> reviewWay(const project::Project& project, const std::string& scenario,
                               const project::ProjectFiles& files = {},
                               const std::function<bool()>& goOn = {});

}  // namespace simcore::review
