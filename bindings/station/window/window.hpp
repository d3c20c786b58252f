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
    /// The error says that a display is missing.
    static Result<Window> open(const std::string& title, int width, int height, bool full_screen);
    ~Window();
    Window(Window&&) noexcept;

    /// What happened since the last call, waiting so long for something to happen. On the thread that opened it.
    std::vector<UserEvent> poll(double longest_s = 0.0);
    /// The same as SDL tells it, for panels; on any thread.
    std::vector<SDL_Event> take_raw();
    [[nodiscard]] int width() const;  ///< pixels
    [[nodiscard]] int height() const;
    /// What was drawn becomes visible.
    void present();
    /// OpenGL on this thread, until it lets go. The error says that there is no OpenGL.
    Status draw_here();
    void let_go();
    /// Taken, the cursor is not seen and no edge holds it: where it would be is told. Otherwise it shows, and works
    /// panels.
    void take_cursor(bool taken);
    [[nodiscard]] SDL_Window* handle() const;
    [[nodiscard]] void* context() const;

private:
    struct Parts;
    explicit Window(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis::station
