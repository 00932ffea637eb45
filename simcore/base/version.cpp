#include "simcore/base/version.h"

namespace simcore {

std::string programVersion() {
    return ROVER_VERSION;
}

}  // namespace simcore
