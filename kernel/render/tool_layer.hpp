// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the instruments.
#pragma once

#include "flow/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/tile_mask.hpp"
#include "render/tool_mesh.hpp"
#include "render/view.hpp"

namespace rhexis {

/// Which side of the eye's wall to draw.
enum class Medium { all = 0, inside = 1, outside = 2 };

/// Draws instruments into the bound target, over what its depth lets through: colour times coverage, and coverage.
class ToolPainter {
public:
    static Result<ToolPainter> create();

    /// detail: repeating noise. eye: may be null with Medium::all.
    void paint(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view, Medium medium,
               const EyeAnatomy* eye, const Texture& detail);

private:
    explicit ToolPainter(ProgramVariants programs) : programs_(std::move(programs)), vertices_({3, 3}) {}
    struct Scene;
    void paint_tool(const ToolMesh& mesh, const ToolState& tool, const Scene& scene);

    ProgramVariants programs_;  ///< one for each kind of finish
    VertexStream vertices_;
    std::vector<float> stream_;
};

/// The instruments alone, with smooth edges, to be laid over a picture.
class ToolLayer {
public:
    ToolLayer(int width, int height);

    /// Within `area` only.
    void draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
              Medium medium, const PixelRect& area, const EyeAnatomy& eye, const Texture& detail);

    [[nodiscard]] const Texture& picture() const { return flat_.colours[0]; }
    /// Outside of this it is empty.
    [[nodiscard]] const TileMask& covered() const { return covered_; }
    /// And outside of this it was so in the picture before, too.
    [[nodiscard]] const TileMask& stale() const { return stale_; }

private:
    TileMask covered_;
    TileMask stale_;
    Target samples_;
    Target flat_;
};

/// Nothing drawn yet, nothing near.
void clear_bound_target();

}  // namespace rhexis
