// SPDX-License-Identifier: GPL-3.0-or-later
// Thin transparent sheets and shells alone, to be laid over the picture of what is under them. Nothing is sorted:
// layers, light and shade of all of them add up, because each of them changes little.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "flow/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/pixel_rect.hpp"
#include "render/shell_surface.hpp"
#include "render/smooth_sheet.hpp"
#include "render/view.hpp"

namespace rhexis {

class SheetLayer {
public:
    static Result<SheetLayer> create(int width, int height);

    /// stop, reference: see DepthPass; what lies deeper than an instrument is not drawn. contour: of the lens under it,
    /// see still_lens.hpp. detail: repeating noise. Within `area`, what lies outside is stale; only what lies within
    /// `reach` of the eye's axis [mm].
    void draw(const Frame& frame, const View& view, const Texture& stop, const Vec3& reference, const Vec3& contour,
              const Texture& detail, const PixelRect& area, double reach);

    /// RGBA8: a quarter of the number of layers along the line of sight, twice the light that they mirror, twice the
    /// whitish veil, shade.
    [[nodiscard]] const Texture& picture() const { return sheets_.colours[0]; }

private:
    SheetLayer(Program surface, Program edge, int width, int height);
    const SmoothSheet& smoothed(std::size_t membrane, const std::shared_ptr<const MembraneSheet>& sheet);
    const ShellSurface& closed(std::size_t shell, const Frame& frame);
    void collect_surface(const std::vector<std::array<int, 3>>& triangles, const std::vector<Vec3>& rest,
                         const std::vector<Vec3>& folds, double reach);
    void collect_edges(const std::vector<SheetEdge>& edges, const Vec3& view_axis);

    Program surface_;
    Program edge_;
    Target sheets_;
    VertexStream surface_vertices_;
    VertexStream edge_vertices_;
    std::vector<float> surface_stream_;
    std::vector<GLuint> surface_indices_;
    std::vector<float> edge_stream_;
    std::vector<SmoothSheet> smooth_;   ///< per membrane, for as long as its connectivity stays
    std::vector<ShellSurface> closed_;  ///< per shell
    std::shared_ptr<const WorldModel> closed_of_;
    std::vector<Vec3> places_;
};

}  // namespace rhexis
