// The gamepad, with a virtual one of SDL's.
#define SDL_MAIN_HANDLED
#include "widgets/session/gamepad.h"

#include <SDL.h>
#include <gtest/gtest.h>

using namespace widgets;

// Within the rest play nothing, beyond it from 0 without a jump to 1, the same to both sides.
TEST(GamepadTest, RestPlayIsTakenOut) {
    for (const double axis : {0.0, 0.1, 0.15}) {
        EXPECT_EQ(withoutRestPlay(axis), 0.0);
        EXPECT_EQ(withoutRestPlay(-axis), 0.0);
    }
    EXPECT_NEAR(withoutRestPlay(0.151), 0.001 / 0.85, 1e-12);
    EXPECT_NEAR(withoutRestPlay(0.575), 0.5, 1e-12);
    EXPECT_EQ(withoutRestPlay(1.0), 1.0);
    EXPECT_EQ(withoutRestPlay(-32768.0 / 32767.0), -1.0);
}

// Plugged in while looked for, read, and pulled out again.
TEST(GamepadTest, ReadsAPadThatComesAndGoes) {
    const auto gamepad = makeSdlGamepad();
    if (SDL_NumJoysticks() > 0) {
        GTEST_SKIP() << "a real gamepad is plugged in";
    }
    EXPECT_FALSE(gamepad->read());
    const int device = SDL_JoystickAttachVirtual(
        SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0);
    ASSERT_GE(device, 0) << SDL_GetError();
    SDL_Joystick* joystick = SDL_JoystickOpen(device);
    ASSERT_NE(joystick, nullptr) << SDL_GetError();
    ASSERT_TRUE(gamepad->read());
    EXPECT_EQ(gamepad->read()->ahead, 0.0);

    // SDL: pushed ahead is negative, to the right positive.
    SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_LEFTY, -32768);
    SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_LEFTX, 18841);
    (void)gamepad->read();
    EXPECT_EQ(gamepad->read()->ahead, 1.0);
    EXPECT_NEAR(gamepad->read()->left, -0.5, 1e-4);
    EXPECT_FALSE(gamepad->read()->slow);
    SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_LEFTX, 0);
    SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_RIGHTX, -32768);
    SDL_JoystickSetVirtualButton(joystick, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, 1);
    (void)gamepad->read();
    EXPECT_EQ(gamepad->read()->left, 1.0);
    EXPECT_TRUE(gamepad->read()->slow);

    SDL_JoystickClose(joystick);
    ASSERT_EQ(SDL_JoystickDetachVirtual(device), 0);
    EXPECT_FALSE(gamepad->read());
}
