// SPDX-License-Identifier: GPL-3.0-or-later
// Optical depth of all bodies along the line of each pixel, up to the first instrument.
#pragma once

#include "flow/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/pixel_rect.hpp"
#include "render/signed_faces.hpp"
#include "render/tool_mesh.hpp"
#include "render/view.hpp"

namespace rhexis {

/// Sets the parameters of view.glsl.
void set_view(const Program& program, const View& view);

/// A depth beyond any scene: no instrument on this line.
inline constexpr float no_stop = 1e4F;

class DepthPass {
public:
    static Result<DepthPass> create(int width, int height);

    /// tools: one mesh per frame.model->tools. Instruments are drawn within `tool_area` only, bodies within
    /// `body_area`; what lies outside is stale.
    void draw(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view, const PixelRect& tool_area,
              const PixelRect& body_area);

    /// RGBA32F or R32F (which reads as grey): times tint() and the stretch of a ray it is the optical depth.
    [[nodiscard]] const Target& optical_depth() const { return grey_ ? grey_sum_ : sum_; }
    /// Where all tissues absorb red, green and blue in one proportion, one channel is drawn instead of three.
    [[nodiscard]] const Vec3& tint() const { return tint_; }
    [[nodiscard]] bool grey() const { return grey_; }
    /// R32F: depth of the first instrument behind the plane through reference(), or no_stop.
    [[nodiscard]] const Texture& stop() const { return stop_.colours[0]; }
    [[nodiscard]] const Vec3& reference() const { return reference_; }

private:
    DepthPass(Program faces, Program distance, int width, int height);
    void draw_tools(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view);
    void draw_faces(const View& view);
    void find_tint(const WorldModel& model);

    Program faces_;
    Program distance_;
    Target sum_;
    Target grey_sum_;
    Target stop_;
    VertexStream vertices_;
    FaceStream stream_;
    std::vector<Vec3> fine_;
    Vec3 reference_ = Vec3::Zero();
    Vec3 tint_ = Vec3::Ones();
    bool grey_ = false;
};

/// Pose as a matrix.
Eigen::Matrix4d matrix_of(const Pose& pose);

}  // namespace rhexis
