// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_layer.hpp"

#include <array>
#include <cmath>

#include "render/depth_pass.hpp"
#include "render/lids_mesh.hpp"

namespace rhexis {

namespace {

constexpr double opening_mm = 0.7;  ///< how far jaws may go beyond where they are drawn closed

bool in_ball(const Vec4& ball, const Vec3& point, double margin) {
    return (point - ball.head<3>()).norm() < ball.w() + margin;
}

/// Whether some of a ball around a point lies in this medium.
bool reaches(Medium medium, const EyeAnatomy& eye, const Vec3& point, double radius) {
    const double margin = medium == Medium::inside ? radius : -radius;
    const bool inside = in_ball(cornea_ball(eye), point, margin) || in_ball(globe_ball(eye), point, margin);
    return inside == (medium == Medium::inside);
}

/// Of the features of tool.frag, the one that a finish has.
unsigned kind_of(ToolFinish finish) {
    enum Kind : unsigned { metal = 0, sleeve = 1, clear = 2, plastic = 4, skin = 8 };
    switch (finish) {
        case ToolFinish::sleeve: return sleeve;
        case ToolFinish::clear: return clear;
        case ToolFinish::hub:
        case ToolFinish::sponge:
        case ToolFinish::nylon: return plastic;
        case ToolFinish::skin:
        case ToolFinish::lash:
        case ToolFinish::drape: return skin;
        default: return metal;
    }
}

/// Boxes around what of the instruments lies in this medium.
PixelRect rect_around_tools(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view, Medium medium,
                            const EyeAnatomy& eye) {
    constexpr int pieces = 16;
    PixelRect rect;
    for (std::size_t i = 0; i < frame.tools.size(); ++i) {
        if (!frame.tools[i].present) {
            continue;
        }
        for (const RoundedCone& part : tools[i].bounds) {
            const double radius = std::max(part.radius_a, part.radius_b) + opening_mm;
            const Vec3 step = (part.b - part.a) / pieces;
            const double reach = radius + 0.5 * step.norm();
            for (int piece = 0; piece < pieces; ++piece) {
                const Vec3 middle = frame.tools[i].pose.to_world(part.a + (piece + 0.5) * step);
                if (!reaches(medium, eye, middle, reach)) {
                    continue;
                }
                std::array<Vec3, 16> corners;
                for (int corner = 0; corner < 16; ++corner) {
                    const Vec3 off((corner & 1) - 0.5, ((corner >> 1) & 1) - 0.5, ((corner >> 2) & 1) - 0.5);
                    const Vec3 end = part.a + (piece + (corner >> 3)) * step;
                    corners[corner] = frame.tools[i].pose.to_world(end + 2.0 * radius * off);
                }
                rect = united(rect, rect_around(view, corners, 2));
            }
        }
    }
    return rect;
}

}  // namespace

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

/// What does not depend on the part that is painted.
struct ToolPainter::Scene {
    const View& view;
    Medium medium;
    const EyeAnatomy* eye;
    const Texture& detail;
};

Result<ToolPainter> ToolPainter::create() {
    Result<ProgramVariants> programs =
        ProgramVariants::create({"tool.vert"}, {"tool.frag"}, {"SLEEVE", "CLEAR", "PLASTIC", "SKIN"});
    if (!programs.ok()) {
        return programs.error();
    }
    return ToolPainter(std::move(programs).value());
}

void ToolPainter::paint(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view, Medium medium,
                        const EyeAnatomy* eye, const Texture& detail) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    const Scene scene{view, medium, eye, detail};
    if (frame.lids && medium == Medium::outside) {
        paint_tool(lids_mesh(*frame.model->lids, *frame.lids), ToolState{}, scene);
    }
    for (std::size_t i = 0; i < frame.tools.size(); ++i) {
        if (frame.tools[i].present) {
            paint_tool(tools[i], frame.tools[i], scene);
        }
    }
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

void ToolPainter::paint_tool(const ToolMesh& mesh, const ToolState& tool, const Scene& scene) {
    const bool bare = scene.medium == Medium::all;
    const View& view = scene.view;
    const Vec3 lamps = bare ? Vec3(-view.forward + 0.7 * view.up.normalized() - 0.3 * view.right.normalized())
                            : Vec3(-0.06, 0.10, 1.0);
    for (const ToolMesh::Part& part : mesh.parts) {
        const Program& program = programs_.with(kind_of(part.finish));
        program.use();
        program.set("clip_from_world", view.clip_from_world);
        program.set("camera", view.eye);
        program.set("lamp_way", Vec3(lamps.normalized()));
        program.set("encoded", bare ? 1 : 0);
        program.set("medium", static_cast<int>(scene.medium));
        program.set("cornea", scene.eye == nullptr ? Vec4(Vec4::Zero()) : cornea_ball(*scene.eye));
        program.set("globe", scene.eye == nullptr ? Vec4(Vec4::Zero()) : globe_ball(*scene.eye));
        program.set("detail_map", scene.detail, 0);
        program.set("world_from_body", matrix_of(pose_of(part, tool)));
        program.set("finish", static_cast<int>(part.finish));
        stream_.clear();
        append_triangles(part, stream_);
        vertices_.send(stream_);
        vertices_.draw();
    }
}

ToolLayer::ToolLayer(int width, int height)
    : drawn_{0, 0, width, height},
      samples_(make_multisampled_target(width, height, GL_RGBA8)),
      flat_(make_single_target(width, height, GL_RGBA8, GL_LINEAR)) {}

void ToolLayer::draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
                     Medium medium, const PixelRect& area, const EyeAnatomy& eye, const Texture& detail) {
    const bool lids = frame.lids && medium == Medium::outside;  // they reach over all of the picture
    const PixelRect now = lids ? area : intersected(rect_around_tools(frame, tools, view, medium, eye), area);
    const Scissor scissor(united(drawn_, now));
    drawn_ = now;
    samples_.bind();
    clear_bound_target();
    painter.paint(frame, tools, view, medium, &eye, detail);
    resolve(samples_, flat_);
}

}  // namespace rhexis
