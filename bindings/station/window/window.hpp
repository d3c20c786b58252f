// SPDX-License-Identifier: GPL-3.0-or-later
// The window on the microscope's picture, and the devices that belong to it.
#pragma once

#include <SDL.h>

#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "station/desk.hpp"
#include "station/user_event.hpp"

namespace rhexis::station {

class Window {
public:
    /// The error says whether a display or OpenGL is missing.
    static Result<Window> open(const std::string& title, int width, int height, bool full_screen);
    ~Window();
    Window(Window&&) noexcept;

    /// What happened since the last call.
    std::vector<UserEvent> poll();
    [[nodiscard]] int width() const;  ///< pixels
    [[nodiscard]] int height() const;
    /// What was drawn becomes visible.
    void present();
    /// The cursor shows, and works panels.
    void show_cursor(bool shown);
    [[nodiscard]] SDL_Window* handle() const;
    [[nodiscard]] void* context() const;

private:
    struct Parts;
    explicit Window(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis::station
