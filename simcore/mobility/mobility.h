#pragma once

#include <array>
#include <string>
#include <vector>

#include "simcore/base/pose.h"
#include "simcore/mechanism/freedoms.h"
#include "simcore/mobility/stance.h"

/// Mobility of a mechanism on the ground: the Grübler count and what it hides.
namespace simcore::mobility {

using mechanism::Model;

/// What a wheel's contact is called among joints: "contact front_left". A name, in any language;
/// programs show it by the wheel's.
std::string contactOf(const std::string& wheel);

/// The wheel whose contact it is; empty for other names.
std::string wheelOfContact(const std::string& element);

/// One constraint equation, named so that a person can find it.
struct ConstraintName {
    std::string element;  ///< joint, gear, or contactOf(wheel)
    std::string kind;     ///< "slide" (a translation is held), "turn" (a rotation is held), "gear"
    Vec3 direction = Vec3::Zero();  ///< held direction, unit, rover axes
    int joint = -1;                 ///< mechanism joint index, -1 for contacts and gears
    int wheel = -1;                 ///< wheel index for contacts, else -1
    /// Share in the self-stress states, 0 (determined) to 1 (wholly redundant).
    double share = 0.0;
};

/// A free motion that moves neither chassis nor wheels. In a mechanism without wheels: one of a
/// single body between two or more others.
struct IdleFreedom {
    std::string body;          ///< the body that moves most
    Vec3 turn = Vec3::Zero();  ///< its angular velocity direction, rover axes
    Vec3 slide = Vec3::Zero();
};

/// Answer of analyse(). Identities: gruebler = columns - rows, mobility = columns - rank,
/// redundant = rows - rank.
struct Report {
    Model model = Model::Built;
    int bodies = 0;                        ///< that are not fixed
    int joints = 0;                        ///< contacts and gears included
    std::array<int, 5> jointsByFreedom{};  ///< f1..f5 of paper eq. 1
    int gruebler = 0;
    int columns = 0;
    int rows = 0;
    int rank = 0;
    int mobility = 0;
    int redundant = 0;
    std::vector<ConstraintName> removable;  ///< any one of them may go without new motion
    std::vector<ConstraintName>
        redundantSet;  ///< one set of exactly `redundant`, documented priority
    std::vector<IdleFreedom> idle;
    double rankGap = 0.0;  ///< last kept / first dropped pivot
};

/// Analyses the mechanism standing on flat ground at its drawn pose, wheel contacts counted as
/// joints of 3 freedoms (4 where the lateral slide is freed). Paper eq. 1 for the count; rank by
/// column-pivoted QR of the constraint Jacobian, lengths scaled by the wheelbase.
Report analyse(const mechanism::Mechanism& mechanism, Model model);

/// The same at any pose and on any ground; a wheel that does not touch counts as no joint. Throws
/// std::invalid_argument when the stance does not fit the mechanism.
Report analyse(const mechanism::Mechanism& mechanism, Model model, const Stance& stance);

/// The verdict in a sentence or two, for people.
std::string describe(const Report& report);

}  // namespace simcore::mobility
