#pragma once

#include <string>
#include <vector>

#include "simcore/mobility/mobility.h"

namespace simcore::mobility {

/// A closed loop of the mechanism, analysed on its own: only its bodies and joints, one of the
/// bodies held.
struct Loop {
    std::vector<std::string> joints;  ///< joints, contactOf(wheel) or gear, around the loop
    std::vector<std::string> bodies;  ///< without the world
    bool throughWorld = false;        ///< closes through the ground or fixed bodies
    bool gear = false;                ///< a gear between two joints rather than a ring of joints
    int rows = 0;
    int columns = 0;
    int gruebler = 0;  ///< columns - rows; freedoms of its joints minus 6 (a gear: minus 1)
    int rank = 0;
    int mobility = 0;   ///< columns - rank
    int redundant = 0;  ///< rows - rank
};

/// The shortest independent loops of the graph of bodies and joints; ground and fixed bodies are
/// one node, every touching wheel a joint to it. Then one entry for every gear.
///
/// Redundancies of a single loop are redundancies of the whole; the whole may have more, where
/// loops that share bodies act together. The loops' counts, and the freedoms of joints that are in
/// none, add up to the Grübler count: freedoms - 6 loops - gears, + 6 when nothing touches the
/// world.
std::vector<Loop> findLoops(const mechanism::Mechanism& mechanism, Model model,
                            const Stance& stance);

}  // namespace simcore::mobility
