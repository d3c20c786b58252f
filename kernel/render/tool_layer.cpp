// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/depth_pass.hpp"
#include "render/eye_balls.hpp"
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
        case ToolFinish::sleeve:
            return sleeve;
        case ToolFinish::clear:
            return clear;
        case ToolFinish::hub:
        case ToolFinish::sponge:
        case ToolFinish::nylon:
            return plastic;
        case ToolFinish::skin:
        case ToolFinish::lash:
        case ToolFinish::drape:
            return skin;
        default:
            return metal;
    }
}

double reach_of_jaws(const ToolMesh& mesh) {
    const bool opens = std::any_of(mesh.parts.begin(), mesh.parts.end(),
                                   [](const ToolMesh::Part& part) { return part.hinge.has_value(); });
    return opens ? opening_mm : 0.0;
}

/// Box around a piece of a cone, from one share of its length to another.
PixelRect rect_around_piece(const RoundedCone& part, const Pose& pose, double from, double to, double radius,
                            const View& view) {
    const Vec3 right = radius * view.right.normalized();
    const Vec3 up = radius * view.up.normalized();
    const Vec3 away = radius * view.axis;
    std::array<Vec3, 16> corners;
    for (int corner = 0; corner < 16; ++corner) {
        const auto side = [corner](int bit) { return ((corner >> bit) & 1) != 0 ? 1.0 : -1.0; };
        const Vec3 end = part.a + ((corner >> 3) != 0 ? to : from) * (part.b - part.a);
        corners[corner] = pose.to_world(end) + side(0) * right + side(1) * up + side(2) * away;
    }
    return rect_around(view, corners, 2);
}

/// Boxes around pieces of what of the instruments lies in this medium.
std::vector<PixelRect> rects_around_tools(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
                                          Medium medium, const EyeAnatomy& eye) {
    constexpr int pieces = 16;
    std::vector<PixelRect> rects;
    for (std::size_t i = 0; i < frame.tools.size(); ++i) {
        if (!frame.tools[i].present) {
            continue;
        }
        const Pose& pose = frame.tools[i].pose;
        for (const RoundedCone& part : tools[i].bounds) {
            const double radius = std::max(part.radius_a, part.radius_b) + reach_of_jaws(tools[i]);
            const double reach = radius + 0.5 * (part.b - part.a).norm() / pieces;
            for (int piece = 0; piece < pieces; ++piece) {
                const double from = static_cast<double>(piece) / pieces;
                const double to = static_cast<double>(piece + 1) / pieces;
                const Vec3 middle = pose.to_world(part.a + 0.5 * (from + to) * (part.b - part.a));
                if (reaches(medium, eye, middle, reach)) {
                    rects.push_back(rect_around_piece(part, pose, from, to, radius, view));
                }
            }
        }
    }
    return rects;
}

}  // namespace

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
        const Pose pose = pose_of(part, tool);
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
        program.set("world_from_body", matrix_of(pose));
        program.set("finish", static_cast<int>(part.finish));
        stream_.clear();
        append_triangles(part, stream_);
        (is_clear(part.finish) ? glEnable : glDisable)(GL_BLEND);
        vertices_.send(stream_);
        vertices_.draw();
    }
}

ToolLayer::ToolLayer(int width, int height)
    : covered_(width, height),
      stale_(width, height),
      samples_(make_multisampled_target(width, height, GL_RGBA8)),
      flat_(make_single_target(width, height, GL_RGBA8, GL_LINEAR)) {
    covered_.mark_all();  // with whatever lies there
}

void ToolLayer::draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
                     Medium medium, const PixelRect& area, const EyeAnatomy& eye, const Texture& detail) {
    stale_ = covered_;
    covered_.clear();
    if (frame.lids && medium == Medium::outside) {  // they reach over all of the picture
        covered_.mark(area);
    } else {
        for (const PixelRect& rect : rects_around_tools(frame, tools, view, medium, eye)) {
            covered_.mark(intersected(rect, area));
        }
    }
    stale_.mark(covered_.rects());
    const std::vector<PixelRect> where = stale_.rects();
    if (where.empty()) {
        return;
    }
    samples_.bind();
    for (const PixelRect& rect : where) {
        const Scissor scissor(rect);
        clear_bound_target();
    }
    {
        const Scissor scissor(area);
        painter.paint(frame, tools, view, medium, &eye, detail);
    }
    for (const PixelRect& rect : where) {
        resolve(samples_, flat_, rect);
    }
}

}  // namespace rhexis
