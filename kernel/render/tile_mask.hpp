// SPDX-License-Identifier: GPL-3.0-or-later
// Which tiles of a picture something concerns.
#pragma once

#include <vector>

#include "render/pixel_rect.hpp"

namespace rhexis {

class TileMask {
public:
    TileMask(int width, int height);

    void clear();
    void mark_all();
    void mark(const PixelRect& rect);
    void mark(const std::vector<PixelRect>& rects);
    /// Also what lies within so many pixels, and a tile more at most.
    void grow(double pixels);

    /// Runs of tiles, on the rows of bands (pixel_rect.hpp).
    [[nodiscard]] std::vector<PixelRect> rects() const;
    /// Of bands, what lies in these tiles.
    [[nodiscard]] std::vector<PixelRect> within(const std::vector<PixelRect>& bands) const;
    /// Tiles of this one that are not marked in the other, which is of one size with it.
    [[nodiscard]] TileMask without(const TileMask& other) const;

private:
    int width_;
    int height_;
    int columns_;
    int rows_;
    std::vector<unsigned char> marked_;  ///< row by row from the bottom left
};

}  // namespace rhexis
