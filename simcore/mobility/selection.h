#pragma once

#include <string>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/mobility/mobility.h"
#include "simcore/project/edit.h"

/// Part of a mechanism, analysed alone: the fork's loop, one bogie.
namespace simcore::mobility {

/// What to look at, by indices in the mechanism.
struct Selection {
    std::vector<int> bodies;
    std::vector<int> joints;  ///< stand for the two bodies that they join
    std::vector<int> wheels;  ///< stand for their body and the contact with the ground
};

/// A part as a mechanism of its own. Its bodies are those of the selection; its joints all that
/// join two of them; its gears those whose two joints are among these. A wheel touches the ground
/// only when the wheel itself is selected. In every piece that neither a contact nor a fixed body
/// ties to the world, one body is held: the chassis, or else the first. So a piece's count is that
/// of its motions within itself, as textbooks count.
struct Part {
    mechanism::Mechanism mechanism;
    Stance stance;
    std::vector<int> bodies;  ///< index in the whole mechanism, for every body
    std::vector<int> joints;  ///< the same of joints
    std::vector<int> wheels;  ///< the same of wheels
    int pieces = 0;           ///< groups of bodies that no joint connects; the world is no body
    int constraints = 0;      ///< joints and contacts: with none there is nothing to count

    /// Names of the bodies that stand still.
    std::vector<std::string> heldBodies() const;
};

/// What a part's counts say, in a sentence or two.
std::string describe(const Part& part, const Report& report);

/// Throws std::invalid_argument when selection or stance do not fit the mechanism.
Part partOf(const mechanism::Mechanism& mechanism, const Stance& stance,
            const Selection& selection);

/// What elements of the project mean in its mechanism; kinds other than bodies, joints and wheels
/// mean nothing. A mirrored element stands for its left copy, and for the right one as well where
/// something selected joins the two sides.
Selection selectionOf(const project::Project& project, const mechanism::Mechanism& mechanism,
                      const std::vector<project::ElementRef>& elements);

/// The same by names of the mechanism or the project, "fork_a" or "wheel front": a bare name is
/// that of a body, else of a joint, else of a wheel. Problems: for every name that is unknown.
Result<Selection> selectionOf(const project::Project& project,
                              const mechanism::Mechanism& mechanism,
                              const std::vector<std::string>& names);

/// How much of the self-stress is in one joint, contact or gear.
struct ElementShare {
    std::string element;
    int joint = -1;
    int wheel = -1;
    double share = 0.0;  ///< sum over its rows: how many redundant constraints it stands for
    double part = 0.0;   ///< of all redundant constraints; all elements add up to 1
};

/// Largest first, without those that have none.
std::vector<ElementShare> shareByElement(const Report& report);

}  // namespace simcore::mobility
