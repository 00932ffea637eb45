#pragma once

#include <vector>

#include "simcore/base/result.h"
#include "simcore/project/edit.h"

/// Parts on the system's clipboard, as text: they may go to another window or program.
namespace widgets::clipboard {

/// Puts the elements there.
void copyParts(const simcore::project::Project& project,
               const std::vector<simcore::project::ElementRef>& elements);

/// With the clipboard's parts, shapes in the body at this place. Problems: there are none, or they
/// do not fit.
simcore::Result<simcore::project::Project> pasted(const simcore::project::Project& project,
                                                  int body);

}  // namespace widgets::clipboard
