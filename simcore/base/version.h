#pragma once

#include <string>

namespace simcore {

/// Version of the program, e.g. "0.1.0": the `program_version` of everything it writes.
std::string programVersion();

}  // namespace simcore
