#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "simcore/base/pose.h"
#include "simcore/base/result.h"
#include "simcore/project/edit.h"
#include "simcore/project/element_names.h"

/// Places of a rover that can be taken hold of and moved about in a drawing of it.
namespace simcore::project {

enum class HandleKind {
    CenterOfMass,  ///< of the whole rover: moves that of the chassis
    Body,          ///< centre of mass of one body
    Joint,
    Wheel,  ///< its axle, and with it what its body has at fixed numbers
    Payload
};

struct Handle {
    HandleKind kind = HandleKind::Joint;
    ElementRef element;            ///< of the rover: the chassis for CenterOfMass
    Side side = Side::Center;      ///< which copy of a mirrored element
    std::string name;              ///< of the copy
    Vec3 position = Vec3::Zero();  ///< rover frame, drawn pose [m]
};

/// All handles of a rover: its centre of mass first, then bodies, joints, payloads and wheels in
/// the order of the file. None when its numbers have no values. A wheel stands for its axle and
/// body.
std::vector<Handle> handlesOf(const Project& project);

/// Parameters that can be set and that each coordinate of a handle depends on, through derived ones
/// too.
std::array<std::vector<std::string>, 3> parametersOf(const Project& project, const Handle& handle);

struct DragRequest {
    std::array<bool, 3> axes{};  ///< coordinates that are to change
    Vec3 to = Vec3::Zero();      ///< rover frame [m]; others are ignored
    bool replace = false;        ///< expressions become numbers
    /// For coordinates of several parameters the one to change, by axis (0 = x).
    std::map<int, std::string> choice;
};

struct Dragged {
    Project project;
    Vec3 reached = Vec3::Zero();  ///< where the handle is now: a parameter's range may end before
    std::vector<std::string> parameters;  ///< that were changed
};

/// Moves a handle: both copies of a mirrored element keep mirroring one another. A coordinate that
/// is a number gets the new one. One that depends on exactly one free parameter changes that, as
/// far as its range goes; with several, `choice` tells which. The rover's centre of mass moves by
/// moving that of the chassis by the ratio of the masses.
///
/// Problems: a coordinate of several parameters without a choice, one that its parameter does not
/// move, a chassis that is mirrored or without mass.
Result<Dragged> dragged(const Project& project, const Handle& handle, const DragRequest& request);

}  // namespace simcore::project
