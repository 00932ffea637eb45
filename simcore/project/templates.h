#pragma once

#include <string>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/project/project.h"
#include "simcore/project/resolve.h"

/// New rovers from templates. A template is a project like any other (assets/templates); its *main
/// dimensions* are its parameters that are plain numbers with both limits, all others follow from
/// them. So a new topology is a new file.
namespace simcore::project {

/// Places of the main dimensions among the parameters, in the order of the file.
std::vector<int> mainDimensions(const Project& templ);

/// The template with these main dimensions; those not named stay. Problems: no such dimension, a
/// value outside its range, dimensions that do not go together.
Result<Project> fromTemplate(const Project& templ, const std::vector<Assignment>& dimensions);

}  // namespace simcore::project
