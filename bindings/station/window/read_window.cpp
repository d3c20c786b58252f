// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/read_window.hpp"

#include <epoxy/gl.h>

namespace rhexis::station {

Image read_window(const Window& window) {
    const int width = window.width();
    const int height = window.height();
    Image image{width, height, std::vector<unsigned char>(3 * static_cast<std::size_t>(width) * height)};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int row = 0; row < height; ++row) {  // the window's first one is at the bottom
        glReadPixels(0, height - 1 - row, width, 1, GL_RGB, GL_UNSIGNED_BYTE,
                     &image.rgb[3 * static_cast<std::size_t>(row) * width]);
    }
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    return image;
}

}  // namespace rhexis::station
