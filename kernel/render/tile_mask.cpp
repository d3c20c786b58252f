// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tile_mask.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

constexpr int tile = band_rows;  ///< pixels each way

int tiles_for(int pixels) { return (pixels + tile - 1) / tile; }

}  // namespace

TileMask::TileMask(int width, int height)
    : width_(width),
      height_(height),
      columns_(tiles_for(width)),
      rows_(tiles_for(height)),
      marked_(static_cast<std::size_t>(columns_) * rows_, 0) {}

void TileMask::clear() { std::fill(marked_.begin(), marked_.end(), 0); }

void TileMask::mark_all() { std::fill(marked_.begin(), marked_.end(), 1); }

void TileMask::mark(const PixelRect& rect) {
    const PixelRect inside = intersected(rect, {0, 0, width_, height_});
    if (inside.empty()) {
        return;
    }
    for (int row = inside.y / tile; row <= (inside.y + inside.height - 1) / tile; ++row) {
        const auto first = marked_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
        std::fill(first + inside.x / tile, first + (inside.x + inside.width - 1) / tile + 1, 1);
    }
}

void TileMask::mark(const std::vector<PixelRect>& rects) {
    for (const PixelRect& rect : rects) {
        mark(rect);
    }
}

void TileMask::grow(double pixels) {
    const int reach = static_cast<int>(std::ceil(pixels / tile));
    for (const PixelRect& run : rects()) {
        mark({run.x - reach * tile, run.y - reach * tile, run.width + 2 * reach * tile, run.height + 2 * reach * tile});
    }
}

std::vector<PixelRect> TileMask::rects() const { return within({{0, 0, width_, height_}}); }

std::vector<PixelRect> TileMask::within(const std::vector<PixelRect>& bands) const {
    std::vector<PixelRect> pieces;
    for (const PixelRect& band : bands) {
        for (int row = band.y / tile; row * tile < band.y + band.height; ++row) {
            const auto marked = [&](int column) {
                return marked_[static_cast<std::size_t>(row) * columns_ + column] != 0;
            };
            for (int column = 0; column < columns_; ++column) {
                if (!marked(column)) {
                    continue;
                }
                const int from = column;
                while (column < columns_ && marked(column)) {
                    ++column;
                }
                const PixelRect piece = intersected(band, {from * tile, row * tile, (column - from) * tile, tile});
                if (!piece.empty()) {
                    pieces.push_back(piece);
                }
            }
        }
    }
    return pieces;
}

TileMask TileMask::without(const TileMask& other) const {
    TileMask rest = *this;
    for (std::size_t i = 0; i < marked_.size(); ++i) {
        rest.marked_[i] = marked_[i] != 0 && other.marked_[i] == 0 ? 1 : 0;
    }
    return rest;
}

}  // namespace rhexis
