// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/window.hpp"

#include <SDL.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace rhexis;
using namespace rhexis::station;

namespace {

/// A device that SDL takes for one.
class VirtualDevice {
public:
    VirtualDevice(SDL_JoystickType type, int axes, int buttons)
        : index_(SDL_JoystickAttachVirtual(type, axes, buttons, 0)), joystick_(SDL_JoystickOpen(index_)) {
        REQUIRE(joystick_ != nullptr);
    }
    ~VirtualDevice() {
        if (joystick_ != nullptr) {
            unplug();
        }
    }
    VirtualDevice(const VirtualDevice&) = delete;
    VirtualDevice& operator=(const VirtualDevice&) = delete;

    void push(int axis, int value) { SDL_JoystickSetVirtualAxis(joystick_, axis, static_cast<Sint16>(value)); }
    void press(int button, bool down) { SDL_JoystickSetVirtualButton(joystick_, button, down ? 1 : 0); }
    void unplug() {
        const SDL_JoystickID id = SDL_JoystickInstanceID(joystick_);
        SDL_JoystickClose(joystick_);
        joystick_ = nullptr;
        for (int i = 0; i < SDL_NumJoysticks(); ++i) {
            if (SDL_JoystickGetDeviceInstanceID(i) == id) {
                SDL_JoystickDetachVirtual(i);
                return;
            }
        }
    }

private:
    int index_;
    SDL_Joystick* joystick_;
};

constexpr int pad_axes = SDL_CONTROLLER_AXIS_MAX;
constexpr int pad_buttons = SDL_CONTROLLER_BUTTON_MAX;

Window a_window() {
    Result<Window> window = Window::open("test", 160, 120, false);
    REQUIRE(window.ok());
    return std::move(window).value();
}

/// All that comes of a change within a few looks.
std::vector<UserEvent> come(Window& window) {
    std::vector<UserEvent> all;
    for (int i = 0; i < 5; ++i) {
        SDL_JoystickUpdate();
        const std::vector<UserEvent> some = window.poll();
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

int count(const std::vector<UserEvent>& events, EventKind kind, const std::string& name, double value) {
    return static_cast<int>(std::count_if(events.begin(), events.end(), [&](const UserEvent& event) {
        return event.kind == kind && event.name == name && std::abs(event.value - value) < 0.01;
    }));
}

}  // namespace

TEST_SUITE("window") {
    TEST_CASE("a pad is plugged in while it runs, works, and is unplugged") {
        Window window = a_window();
        come(window);
        VirtualDevice pad(SDL_JOYSTICK_TYPE_GAMECONTROLLER, pad_axes, pad_buttons);
        CHECK(count(come(window), EventKind::device, "pad", 1.0) == 1);
        pad.push(SDL_CONTROLLER_AXIS_LEFTX, 16384);
        pad.press(SDL_CONTROLLER_BUTTON_A, true);
        const std::vector<UserEvent> pushed = come(window);
        CHECK(count(pushed, EventKind::axis, "pad.leftx", 0.5) == 1);
        CHECK(count(pushed, EventKind::press, "pad.a", 1.0) == 1);
        pad.push(SDL_CONTROLLER_AXIS_LEFTX, 16390);  // less than its grain
        CHECK(come(window).empty());
        pad.unplug();
        CHECK(count(come(window), EventKind::device, "pad", 0.0) == 1);
    }

    TEST_CASE("of two equal pads the first counts; when it is unplugged the other does") {
        Window window = a_window();
        come(window);
        VirtualDevice first(SDL_JOYSTICK_TYPE_GAMECONTROLLER, pad_axes, pad_buttons);
        VirtualDevice second(SDL_JOYSTICK_TYPE_GAMECONTROLLER, pad_axes, pad_buttons);
        CHECK(count(come(window), EventKind::device, "pad", 1.0) == 1);
        second.push(SDL_CONTROLLER_AXIS_LEFTX, 32767);
        CHECK(come(window).empty());
        first.push(SDL_CONTROLLER_AXIS_LEFTX, 32767);
        CHECK(count(come(window), EventKind::axis, "pad.leftx", 1.0) == 1);
        first.unplug();
        const std::vector<UserEvent> after = come(window);
        CHECK(count(after, EventKind::device, "pad", 0.0) == 1);
        CHECK(count(after, EventKind::device, "pad", 1.0) == 1);
        second.push(SDL_CONTROLLER_AXIS_LEFTX, -32768);
        CHECK(count(come(window), EventKind::axis, "pad.leftx", -1.0) == 1);
    }

    TEST_CASE("a pedal is an axis of a joystick that is no pad") {
        Window window = a_window();
        come(window);
        VirtualDevice pedal(SDL_JOYSTICK_TYPE_UNKNOWN, 1, 2);
        CHECK(count(come(window), EventKind::device, "pedal", 1.0) == 1);
        pedal.push(0, 16384);
        pedal.press(1, true);
        const std::vector<UserEvent> pushed = come(window);
        CHECK(count(pushed, EventKind::axis, "pedal.0", 0.5) == 1);
        CHECK(count(pushed, EventKind::press, "pedal.button1", 1.0) == 1);
        pedal.unplug();
        CHECK(count(come(window), EventKind::device, "pedal", 0.0) == 1);
    }

    TEST_CASE("the window is closed; keys that repeat count once") {
        Window window = a_window();
        come(window);
        SDL_Event event{};
        event.type = SDL_QUIT;
        SDL_PushEvent(&event);
        event.type = SDL_KEYDOWN;
        event.key.keysym.sym = SDLK_TAB;
        SDL_PushEvent(&event);
        event.key.repeat = 1;
        SDL_PushEvent(&event);
        const std::vector<UserEvent> events = come(window);
        CHECK(count(events, EventKind::quit, "", 0.0) == 1);
        CHECK(count(events, EventKind::key, "Tab", 1.0) == 1);
    }
}
