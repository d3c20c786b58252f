// SPDX-License-Identifier: GPL-3.0-or-later
// Optical depth of all bodies along the line of each pixel, up to the first instrument.
#pragma once

#include "flow/frame.hpp"
#include "render/gl_objects.hpp"
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

    /// tools: one mesh per frame.model->tools.
    void draw(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view);

    [[nodiscard]] const Target& optical_depth() const { return sum_; }  ///< RGBA32F; times the stretch of a ray
    /// R32F: depth of the first instrument behind the plane through reference(), or no_stop.
    [[nodiscard]] const Texture& stop() const { return stop_.colours[0]; }
    [[nodiscard]] const Vec3& reference() const { return reference_; }

private:
    DepthPass(Program faces, Program distance, int width, int height);
    void draw_tools(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view);
    void draw_faces(const View& view);

    Program faces_;
    Program distance_;
    Target sum_;
    Target stop_;
    VertexStream vertices_;
    FaceStream stream_;
    std::vector<Vec3> fine_;
    Vec3 reference_ = Vec3::Zero();
};

/// Pose as a matrix.
Eigen::Matrix4d matrix_of(const Pose& pose);

}  // namespace rhexis
