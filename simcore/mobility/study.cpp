#include "simcore/mobility/study.h"

#include "simcore/base/text.h"

namespace simcore::mobility {

Study study(const mechanism::Mechanism& mechanism, Model model) {
    return study(mechanism, model, drawnStance(mechanism));
}

Study study(const mechanism::Mechanism& mechanism, Model model, const Stance& stance) {
    return {analyse(mechanism, model, stance), movedPose(mechanism, model, stance),
            determinedReactions(mechanism, model, stance), findLoops(mechanism, model, stance)};
}

std::string describe(const MovedPose& moved, const Report& present) {
    const int stuck = static_cast<int>(moved.motions.size()) - moved.moving;
    std::string text;
    if (stuck > 0) {
        text = moved.moving == 0
                   ? Text::of(
                         "No free motion can be continued: it yields in this pose, but some "
                         "constraints are inconsistent after any finite step.")
                   : Text::of(
                         "Only {} free motions can be continued: it yields in this pose, but some "
                         "constraints are inconsistent after any finite step.",
                         moved.moving);
    }
    if (moved.mobility != present.mobility) {
        text += (text.empty() ? "" : " ") +
                Text::of("This pose is special: after a small real motion the mobility is {}.",
                         moved.mobility);
    }
    return text;
}

}  // namespace simcore::mobility
