// SPDX-License-Identifier: GPL-3.0-or-later
// Optical depth of all bodies along the line of each pixel, up to the first instrument.
#pragma once

#include "flow/frame.hpp"
#include "render/depth_raster.hpp"
#include "render/drawn_from.hpp"
#include "render/gl_objects.hpp"
#include "render/pixel_rect.hpp"
#include "render/signed_faces.hpp"
#include "render/tool_mesh.hpp"
#include "render/view.hpp"

namespace rhexis {

/// Sets the parameters of view.glsl.
void set_view(const Program& program, const View& view);

class DepthPass {
public:
    /// keeps: from picture to picture, where bodies move by less than is seen, what no instrument changes.
    DepthPass(int width, int height, bool keeps);

    /// tools: one mesh per frame.model->tools. Instruments are drawn within `tool_area` only, bodies within
    /// `body_area`; what lies outside is stale.
    void draw(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view, const PixelRect& tool_area,
              const PixelRect& body_area);

    /// RGB32F or R32F (which reads as grey): times tint() and the stretch of a ray it is the optical depth.
    [[nodiscard]] const Texture& optical_depth() const { return grey_ ? grey_sum_ : sum_; }
    /// The same as numbers, and what stops the lines.
    [[nodiscard]] const DepthRaster& raster() const { return raster_; }
    /// Where all tissues absorb red, green and blue in one proportion, one channel is drawn instead of three.
    [[nodiscard]] const Vec3& tint() const { return tint_; }
    [[nodiscard]] bool grey() const { return grey_; }
    /// R32F: depth of the first instrument behind the plane through reference(), or no_stop.
    [[nodiscard]] const Texture& stop() const { return stop_; }
    [[nodiscard]] const Vec3& reference() const { return reference_; }
    /// Where the optical depth has been drawn anew by the last draw().
    [[nodiscard]] const PixelRect& changed() const { return changed_; }

private:
    /// Where they may show.
    PixelRect draw_tools(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
                         const PixelRect& area);
    bool is_still(const View& view, const PixelRect& body_area);
    void find_tint(const Frame& frame);

    /// Of what is kept.
    struct Drawn {
        DrawnFrom from;
        int channels = 0;
        FaceStream faces;
    };

    bool keeps_;
    Drawn drawn_;
    PixelRect tools_;  ///< where instruments were
    PixelRect changed_;
    DepthRaster raster_;
    Texture sum_;
    Texture grey_sum_;
    Texture stop_;
    FaceStream stream_;
    std::vector<Vec3> fine_;
    std::vector<Vec3> corners_;
    Vec3 reference_ = Vec3::Zero();
    Vec3 tint_ = Vec3::Ones();
    bool grey_ = false;
};

/// Pose as a matrix.
Eigen::Matrix4d matrix_of(const Pose& pose);

}  // namespace rhexis
