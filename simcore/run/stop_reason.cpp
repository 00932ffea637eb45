#include "simcore/run/simulation.h"

namespace simcore::run {

std::string toString(StopReason reason) {
    switch (reason) {
        case StopReason::Running:
            return "running";
        case StopReason::Completed:
            return "completed";
        case StopReason::TimeUp:
            return "time-up";
        case StopReason::Stuck:
            return "stuck";
        case StopReason::NonFinite:
            return "non-finite";
        case StopReason::SingularPose:
            return "singular-pose";
        case StopReason::Stopped:
            return "stopped";
    }
    return "unknown";
}

}  // namespace simcore::run
