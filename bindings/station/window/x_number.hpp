// SPDX-License-Identifier: GPL-3.0-or-later
// Apart, for the headers of X give common words another meaning.
#pragma once

struct SDL_Window;

namespace rhexis::station {

/// Of a window in an X server; 0: it is in none.
unsigned long x_number(SDL_Window* window);

}  // namespace rhexis::station
