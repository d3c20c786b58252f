// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_layer.hpp"

#include <array>
#include <cmath>

#include "render/depth_pass.hpp"

namespace rhexis {

Vec4 cornea_ball(const EyeAnatomy& eye) { return {0.0, 0.0, eye.cornea_apex_z - eye.cornea_radius, eye.cornea_radius}; }

Vec4 globe_ball(const EyeAnatomy& eye) {
    const double rise = std::sqrt(eye.globe_radius * eye.globe_radius - eye.limbus_radius * eye.limbus_radius);
    return {0.0, 0.0, eye.limbus_z - rise, eye.globe_radius};
}

void clear_bound_target() {
    const std::array<GLfloat, 4> none{};
    const GLfloat farthest = 1.0F;
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_COLOR, 0, none.data());
    glClearBufferfv(GL_DEPTH, 0, &farthest);
}

Result<ToolPainter> ToolPainter::create() {
    Result<Program> program = Program::build({"tool.vert"}, {"tool.frag"});
    if (!program.ok()) {
        return program.error();
    }
    return ToolPainter(std::move(program).value());
}

void ToolPainter::paint(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view, Medium medium,
                        const EyeAnatomy* eye, const Texture& detail) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    program_.use();
    program_.set("clip_from_world", view.clip_from_world);
    program_.set("camera", view.eye);
    program_.set("medium", static_cast<int>(medium));
    program_.set("cornea", eye == nullptr ? Vec4(Vec4::Zero()) : cornea_ball(*eye));
    program_.set("globe", eye == nullptr ? Vec4(Vec4::Zero()) : globe_ball(*eye));
    program_.set("detail_map", detail, 0);
    for (std::size_t i = 0; i < frame.tools.size(); ++i) {
        if (frame.tools[i].present) {
            paint_tool(tools[i], frame.tools[i].pose);
        }
    }
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

void ToolPainter::paint_tool(const ToolMesh& mesh, const Pose& pose) {
    program_.set("world_from_body", matrix_of(pose));
    for (const ToolMesh::Part& part : mesh.parts) {
        stream_.clear();
        append_triangles(part, stream_);
        program_.set("finish", static_cast<int>(part.finish));
        vertices_.send(stream_);
        vertices_.draw();
    }
}

ToolLayer::ToolLayer(int width, int height)
    : samples_(make_multisampled_target(width, height, GL_RGBA8)),
      flat_(make_single_target(width, height, GL_RGBA8, GL_LINEAR_MIPMAP_LINEAR)) {}

void ToolLayer::draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
                     Medium medium, const EyeAnatomy& eye, const Texture& detail) {
    samples_.bind();
    clear_bound_target();
    painter.paint(frame, tools, view, medium, &eye, detail);
    resolve(samples_, flat_);
    glBindTexture(GL_TEXTURE_2D, *flat_.colours[0].name);
    glGenerateMipmap(GL_TEXTURE_2D);
}

}  // namespace rhexis
