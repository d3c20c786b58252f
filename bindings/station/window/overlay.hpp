// SPDX-License-Identifier: GPL-3.0-or-later
// Dear ImGui on a window: its context, its font, and the frame around what is drawn with it.
#pragma once

#include "station/window/window.hpp"

namespace rhexis::station {

class Overlay {
public:
    explicit Overlay(Window& window);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    // Around what is drawn of a picture, on the thread that draws.
    void begin();
    void end() const;

private:
    Window& window_;
};

}  // namespace rhexis::station
