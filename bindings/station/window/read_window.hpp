// SPDX-License-Identifier: GPL-3.0-or-later
// What a window shows, as a picture: before it is presented, on the thread that draws.
#pragma once

#include "flow/frame.hpp"
#include "station/window/window.hpp"

namespace rhexis::station {

Image read_window(const Window& window);

}  // namespace rhexis::station
