// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks of the lens as lines: a crack that has closed again has no width, and is seen all the same.
#pragma once

#include <vector>

#include "flow/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/pixel_rect.hpp"
#include "render/view.hpp"

namespace rhexis {

/// Whether faces of a body have given way.
bool has_cracks(const Frame& frame);

class CrackLayer {
public:
    static Result<CrackLayer> create(int width, int height);

    /// Within `area`. stop, reference: as in DepthPass.
    void draw(const Frame& frame, const View& view, const Texture& stop, const Vec3& reference, const PixelRect& area);

    /// RG8: how deep the crack is along the line of sight, share of a millimetre, in a thin line and in a wide one.
    [[nodiscard]] const Texture& picture() const { return lines_.colours[0]; }

private:
    CrackLayer(Program program, int width, int height)
        : program_(std::move(program)),
          lines_(make_single_target(width, height, GL_RG8, GL_LINEAR)),
          vertices_({3, 3}) {}

    Program program_;
    Target lines_;
    VertexStream vertices_;
    std::vector<float> stream_;
};

}  // namespace rhexis
