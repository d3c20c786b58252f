// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/x_number.hpp"

#include <SDL_syswm.h>

namespace rhexis::station {

unsigned long x_number(SDL_Window* window) {
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
    const bool known = SDL_GetWindowWMInfo(window, &info) == SDL_TRUE && info.subsystem == SDL_SYSWM_X11;
    return known ? info.info.x11.window : 0;
}

}  // namespace rhexis::station
