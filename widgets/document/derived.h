#pragma once

#include <optional>

#include "simcore/mobility/mobility.h"
#include "simcore/project/project.h"
#include "simcore/project/project_files.h"
#include "simcore/project/resolve.h"
#include "simcore/review/review.h"

namespace widgets {

/// What follows from a project, worked out anew after every edit.
struct Derived {
    simcore::Problems problems;                    ///< all of them, worst first
    simcore::project::ParameterValues parameters;  ///< empty when they cannot be valued
    /// Absent while the rover has critical problems.
    std::optional<simcore::mechanism::Mechanism> mechanism;
    simcore::mobility::Report built, relaxed;        ///< of the mechanism, when there is one
    std::vector<simcore::review::Finding> findings;  ///< what is no mistake but unwise, worst first
};

/// `files` is where the terrain files of the project are looked for.
Derived derive(const simcore::project::Project& project,
               const simcore::project::ProjectFiles& files = {});

}  // namespace widgets
