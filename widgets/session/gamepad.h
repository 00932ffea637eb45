#pragma once

#include <memory>
#include <optional>

namespace widgets {

/// How far a person pushes, each from -1 to 1: ahead and to the left are positive.
struct DriveInput {
    double ahead = 0.0;
    double left = 0.0;
    bool slow = false;
    bool operator==(const DriveInput&) const = default;
};

/// A stick's axis (-1 to 1) without the rest play about its middle, which never returns to 0 quite:
/// 0 within the dead zone, and from there on rising from 0 to 1.
double withoutRestPlay(double axis);

/// A game controller; the first one that is plugged in.
class Gamepad {
  public:
    virtual ~Gamepad() = default;
    /// Nothing when none is plugged in.
    virtual std::optional<DriveInput> read() = 0;
};

/// Through SDL, which knows the layout of most makes. Left stick, or for the turn the right one
/// too; a shoulder button for slow.
std::unique_ptr<Gamepad> makeSdlGamepad();

}  // namespace widgets
