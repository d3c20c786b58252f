// SPDX-License-Identifier: GPL-3.0-or-later
// Smaller copies of a picture (mipmaps), made anew only where it has changed.
#pragma once

#include "render/gl_objects.hpp"
#include "render/tile_mask.hpp"

namespace rhexis {

class SmallerCopies {
public:
    static Result<SmallerCopies> create();

    /// Of a texture that is filtered with its copies, always the same one: `levels` of them, each half the size of the
    /// one before, are made anew where `changed` is marked, all of them where there are more than the last time. It
    /// then shows no smaller ones.
    void make(const Texture& picture, const TileMask& changed, int levels);

private:
    explicit SmallerCopies(Program halve) : halve_(std::move(halve)), rectangles_({2}) {}
    void reach_for(const Texture& picture, int levels);

    Program halve_;
    VertexStream rectangles_;
    std::vector<GlName<release_framebuffer>> targets_;  ///< level 1, 2, ... of the picture
    int made_ = 0;                                      ///< the last time
};

}  // namespace rhexis
