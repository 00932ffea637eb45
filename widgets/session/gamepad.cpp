#include "widgets/session/gamepad.h"

#include <algorithm>
#include <cmath>

// SDL is to read the pad, not to take over main().
#define SDL_MAIN_HANDLED
#include <SDL.h>

namespace widgets {
namespace {

/// Usual rest play of a worn stick (assumed; makers give 10 to 25 %).
constexpr double kDeadZone = 0.15;

class SdlGamepad final : public Gamepad {
  public:
    SdlGamepad() {
        SDL_SetMainReady();
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        // The window belongs to Qt: SDL would never see the focus it waits for.
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        ready_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
    }

    ~SdlGamepad() override {
        close();
        if (ready_) {
            SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
        }
    }

    SdlGamepad(const SdlGamepad&) = delete;
    SdlGamepad& operator=(const SdlGamepad&) = delete;

    std::optional<DriveInput> read() override {
        if (!ready_) {
            return std::nullopt;
        }
        SDL_GameControllerUpdate();
        if (pad_ != nullptr && SDL_GameControllerGetAttached(pad_) == SDL_FALSE) {
            close();
        }
        if (pad_ == nullptr && !open()) {
            return std::nullopt;
        }
        DriveInput input;
        // SDL's axes point right and down.
        input.ahead = -axis(SDL_CONTROLLER_AXIS_LEFTY);
        input.left = std::clamp(-axis(SDL_CONTROLLER_AXIS_LEFTX) - axis(SDL_CONTROLLER_AXIS_RIGHTX),
                                -1.0, 1.0);
        input.slow = pressed(SDL_CONTROLLER_BUTTON_LEFTSHOULDER) ||
                     pressed(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
        return input;
    }

  private:
    bool open() {
        for (int i = 0; i < SDL_NumJoysticks() && pad_ == nullptr; ++i) {
            if (SDL_IsGameController(i) == SDL_TRUE) {
                pad_ = SDL_GameControllerOpen(i);
            }
        }
        return pad_ != nullptr;
    }

    void close() {
        if (pad_ != nullptr) {
            SDL_GameControllerClose(pad_);
            pad_ = nullptr;
        }
    }

    double axis(SDL_GameControllerAxis which) const {
        return withoutRestPlay(SDL_GameControllerGetAxis(pad_, which) / 32767.0);
    }

    bool pressed(SDL_GameControllerButton which) const {
        return SDL_GameControllerGetButton(pad_, which) != 0;
    }

    SDL_GameController* pad_ = nullptr;
    bool ready_ = false;
};

}  // namespace

double withoutRestPlay(double axis) {
    const double beyond = (std::min(std::abs(axis), 1.0) - kDeadZone) / (1.0 - kDeadZone);
    return std::copysign(std::max(beyond, 0.0), axis);
}

std::unique_ptr<Gamepad> makeSdlGamepad() {
    return std::make_unique<SdlGamepad>();
}

}  // namespace widgets
