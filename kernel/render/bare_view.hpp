// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of bodies without an eye: shaded surfaces, instruments, the planes that things rest on.
#pragma once

#include "render/tool_layer.hpp"

namespace rhexis {

class BareView {
public:
    static Result<BareView> create(int width, int height);

    void draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
              const Texture& detail);

    [[nodiscard]] const Target& picture() const { return flat_; }  ///< RGBA8

private:
    BareView(Program backdrop, Program bodies, int width, int height);
    void draw_planes(const Frame& frame, const View& view);

    Program backdrop_;
    Program bodies_;
    Target samples_;
    Target flat_;
    VertexStream vertices_;
    std::vector<float> stream_;
};

/// Frames all bodies of a bare scene from the front, the right and above.
Camera camera_around(const Frame& frame);

}  // namespace rhexis
