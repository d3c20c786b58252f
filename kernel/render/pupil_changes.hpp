// SPDX-License-Identifier: GPL-3.0-or-later
// What of the pupil looks another way than when it was painted last, where a picture keeps what does not.
#pragma once

#include <vector>

#include "flow/frame.hpp"
#include "render/depth_raster.hpp"
#include "render/tile_mask.hpp"

namespace rhexis {

class PupilChanges {
public:
    PupilChanges(int width, int height);

    /// All of it, the next time.
    void forget() { parameters_.clear(); }

    /// Tiles to paint: where the optical depth is another one, by more than is seen, where crumbs are or were, and all
    /// of `area` if another number is told of the scene. From here on they count as painted. parameters: those of the
    /// program that paints it, without instruments, crumbs and time.
    const TileMask& find(const DepthRaster& raster, const Frame& frame, const View& view, const PixelRect& area,
                         std::vector<unsigned char>& parameters);

    /// Tiles in which crumbs are, as of the last find().
    [[nodiscard]] const TileMask& crumbs() const { return crumbs_; }

private:
    void mark_depths(const DepthRaster& raster, const PixelRect& area);
    void mark_crumbs(const Frame& frame, const View& view);

    int width_;
    TileMask changed_;
    TileMask crumbs_;
    std::vector<float> painted_;  ///< optical depths
    std::vector<unsigned char> parameters_;
};

}  // namespace rhexis
