#pragma once

#include <map>

#include "simcore/experiment/experiment.h"

namespace simcore::experiment {

/// What each ground asks of a rover by statics, whatever drives it: found once a ground.
class GroundStatics {
  public:
    /// The friction required to creep over the ground of a seed with the heading held, rolling
    /// resistance left out (statics::Traverse::frictionRequired()) [-]. Infinite where the rover
    /// does not come over it by statics; NaN where it cannot be studied.
    double frictionRequired(const project::Project& project, const Plan& plan, int seed);

  private:
    std::map<int, double> known_;
};

}  // namespace simcore::experiment
