#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/mobility/mobility.h"
#include "simcore/project/project.h"

/// The Advisor: which joints to change so that every reaction follows from the loads, and the rover
/// still moves as it did. docs/mobility.md has the method and its limits.
namespace simcore::mobility {

/// What a joint, or the contact of a wheel, can become.
enum class JointType {
    Universal,       ///< two turns
    Ball,            ///< three turns
    Cylindrical,     ///< a turn and a slide along one axis
    BallWithSlide,   ///< three turns and a slide (the paper's joint of four freedoms)
    SidewaysContact  ///< a wheel's contact that holds nothing sideways
};

/// Points that a change costs, for one joint; a mirrored one counts twice. Assumed: a ball is a rod
/// end off the shelf, a cylindrical joint a pin with end play, the others have to be made; a
/// contact costs no part. What is cheaper in points is proposed first.
int costOf(JointType type);

/// Points on top for changing one copy of a mirrored element and not the other: the two sides are
/// then different parts, which a contact is not. Assumed.
int costOfOneSide(JointType type);

/// "ball", "ball with slide", ...
std::string toString(JointType type);

struct AdvisorOptions {
    int proposals = 10;  ///< at most so many, at least 1
    /// At most so many that differ only in where the same types of joints go; at least 1.
    int alike = 3;
    double seconds = 10.0;  ///< of wall clock, then the search ends with what it has [s]
    bool universal = true;
    bool ball = true;
    bool cylindrical = true;
    bool ballWithSlide = true;
    bool contacts = true;  ///< contacts of wheels may be freed sideways
    bool axles = false;    ///< axles of wheels may be changed
};

/// One element of the project with other freedoms in the relaxed model: both sides of a mirrored
/// one, unless nothing exact is that symmetric.
struct JointChange {
    int joint = -1;                   ///< index in Rover::joints; -1 for contacts
    int wheel = -1;                   ///< index in Rover::wheels; -1 for joints
    std::string element;              ///< "fork_b", "contact bogie_{side}_front"
    std::vector<std::string> copies;  ///< what is changed in the mechanism: one name, or two
    std::string from;                 ///< "pin", "contact", ...
    std::string to;                   ///< "ball", "ball with slide z", ...
    JointType type = JointType::Ball;
    project::Sides sides = project::Sides::Both;  ///< which copies change
    /// Joint::relaxed; empty for contacts.
    std::vector<project::FreedomText> relaxed;
    int freed = 0;  ///< directions let go, of all copies; negative: held, against an idle freedom
    int cost = 0;   ///< points
    bool operator==(const JointChange&) const = default;
};

/// A relaxed model in which nothing is redundant, nothing idle, and whose chassis and wheels move
/// as in the model as built.
struct Proposal {
    std::vector<JointChange> changes;  ///< in the order of the project
    Report report;                     ///< analyse() of the relaxed model
    int changed = 0;                   ///< joints and contacts of the mechanism
    int cost = 0;                      ///< points
    /// 0 to 1: least singular value of the self-stress states seen at what is let go. Small: barely
    /// exact, and small errors of make become large where they are taken up.
    double margin = 0.0;
    std::string why;  ///< its place among the others, for people
};

enum class AdviceEnd {
    Complete,  ///< no exact set of permitted joints costs less than the last proposal
    TimeUp,
    Cancelled
};

struct Advice {
    Report built;               ///< as built, at the pose that was searched
    Report fileRelaxed;         ///< the relaxed model that the project has
    bool alreadyExact = false;  ///< as built: nothing redundant, nothing idle
    /// The drawn pose is special, so a pose after a small real motion was searched.
    bool searchedMovedPose = false;
    /// Nothing exact treats both sides alike, so changes of one side were searched, too.
    bool oneSided = false;
    std::vector<Proposal> proposals;  ///< cheapest first
    AdviceEnd end = AdviceEnd::Complete;
    std::vector<std::string> notes;  ///< what a person should know, one sentence each
};

/// Looks for exact sets of joints, cheapest first. Each proposal is confirmed by analyse() and by a
/// finite step along its motion. Without a time limit that strikes, the same project gives the same
/// advice. Any thread; `stop` may be requested from another, and is obeyed within a
/// tenth of a second. Problems: those of resolving the project. Throws std::invalid_argument when
/// an option is out of range.
Result<Advice> advise(const project::Project& project, const AdvisorOptions& options = {},
                      const std::stop_token& stop = {});

/// The project with the proposal as its relaxed model, in place of the one it has: joints that the
/// proposal leaves alone are as built in it. One value, so one step of undo. Problem: an element
/// that the proposal changes is no longer there.
Result<project::Project> withRelaxation(const project::Project& project, const Proposal& proposal);

/// The verdict in a sentence or two, for people.
std::string describe(const Advice& advice);

}  // namespace simcore::mobility
