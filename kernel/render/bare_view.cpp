// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bare_view.hpp"

#include <algorithm>

#include "render/bare_surface.hpp"

namespace rhexis {

namespace {

constexpr double camera_distance = 200.0;
constexpr double mesh_lines = 0.28;
const Vec3 ground_colour(0.62, 0.63, 0.65);
const Vec3 shadow_colour(0.40, 0.41, 0.43);

struct WindowBox {
    Vec3 low = Vec3::Constant(1e30);
    Vec3 high = Vec3::Constant(-1e30);
};

WindowBox box_of(const Frame& frame) {
    WindowBox box;
    const auto add = [&box](const std::vector<Vec3>& nodes) {
        for (const Vec3& node : nodes) {
            if (node.allFinite()) {
                box.low = box.low.cwiseMin(node);
                box.high = box.high.cwiseMax(node);
            }
        }
    };
    for (const SolidState& solid : frame.solids) {
        add(solid.position);
    }
    for (const MembraneState& membrane : frame.membranes) {
        add(membrane.position);
    }
    for (const ShellState& shell : frame.shells) {
        add(shell.position);
    }
    return box.low.x() <= box.high.x() ? box : WindowBox{Vec3::Constant(-1.0), Vec3::Constant(1.0)};
}

void append_vertex(const Vec3& place, const Vec3& normal, const Vec3& tint, std::vector<float>& stream) {
    const Vec3 far_from_edges = Vec3::Ones();
    for (const Vec3* triple : {&place, &normal, &tint, &far_from_edges}) {
        for (int i = 0; i < 3; ++i) {
            stream.push_back(static_cast<float>((*triple)[i]));
        }
    }
}

/// A square piece of the plane under the scene.
std::vector<float> ground(const PlaneModel& plane, const WindowBox& box) {
    const Vec3 middle = 0.5 * (box.low + box.high);
    const Vec3 foot = middle - plane.normal.dot(middle - plane.point) * plane.normal;
    const double reach = 2.0 * (box.high - box.low).norm();
    const Vec3 u = reach * plane.normal.unitOrthogonal();
    const Vec3 v = plane.normal.cross(u);
    std::vector<float> stream;
    for (const Vec3& corner : {Vec3(-u - v), Vec3(u - v), Vec3(u + v), Vec3(-u - v), Vec3(u + v), Vec3(v - u)}) {
        append_vertex(foot + corner, plane.normal, ground_colour, stream);
    }
    return stream;
}

/// The bodies' triangles laid onto the plane along the light.
std::vector<float> shadow(const PlaneModel& plane, const std::vector<float>& bodies, const Vec3& light) {
    std::vector<float> stream;
    const double climb = plane.normal.dot(light);
    for (std::size_t i = 0; climb > 0.1 && i + 11 < bodies.size(); i += 12) {
        const Vec3 place(bodies[i], bodies[i + 1], bodies[i + 2]);
        const double height = plane.normal.dot(place - plane.point);
        const Vec3 shade = place - (height - 1e-3) / climb * light;
        append_vertex(shade, plane.normal, shadow_colour, stream);
    }
    return stream;
}

}  // namespace

Camera camera_around(const Frame& frame) {
    const WindowBox box = box_of(frame);
    Camera camera;
    camera.target = 0.5 * (box.low + box.high);
    camera.eye = camera.target + camera_distance * Vec3(0.45, -0.80, 0.42).normalized();
    camera.up = Vec3::UnitZ();
    camera.field_mm = std::max(1.15 * (box.high - box.low).norm(), 1e-3);
    return camera;
}

Result<BareView> BareView::create(int width, int height) {
    Result<Program> backdrop = Program::build({"fullscreen.vert"}, {"backdrop.frag"});
    if (!backdrop.ok()) {
        return backdrop.error();
    }
    Result<Program> bodies = Program::build({"bare.vert"}, {"bare.frag"});
    if (!bodies.ok()) {
        return bodies.error();
    }
    return BareView(std::move(backdrop).value(), std::move(bodies).value(), width, height);
}

BareView::BareView(Program backdrop, Program bodies, int width, int height)
    : backdrop_(std::move(backdrop)),
      bodies_(std::move(bodies)),
      samples_(make_multisampled_target(width, height, GL_RGBA8)),
      flat_(make_single_target(width, height, GL_RGBA8, GL_NEAREST)),
      vertices_({3, 3, 3, 3}) {}

void BareView::draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
                    const Texture& detail) {
    stream_.clear();
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        append_surface(frame.model->solids[i], frame.solids[i], static_cast<int>(i), stream_);
    }
    for (const MembraneState& membrane : frame.membranes) {
        append_sheet(membrane, stream_);
    }
    for (std::size_t i = 0; i < frame.shells.size(); ++i) {
        append_shell(frame.model->shells[i], frame.shells[i], stream_);
    }
    samples_.bind();
    clear_bound_target();
    backdrop_.use();
    cover_target();
    bodies_.use();
    bodies_.set("clip_from_world", view.clip_from_world);
    bodies_.set("camera", view.eye);
    bodies_.set("light_way",
                Vec3((-view.forward + 0.9 * view.up.normalized() - 0.5 * view.right.normalized()).normalized()));
    glEnable(GL_DEPTH_TEST);
    draw_planes(frame, view);
    bodies_.set("lines", mesh_lines);
    vertices_.send(stream_);
    vertices_.draw();
    glDisable(GL_DEPTH_TEST);
    painter.paint(frame, tools, view, Medium::all, nullptr, detail);
    resolve(samples_, flat_, whole(view));
}

void BareView::draw_planes(const Frame& frame, const View& view) {
    const WindowBox box = box_of(frame);
    bodies_.set("lines", 0.0);
    for (const PlaneModel& plane : frame.model->planes) {
        vertices_.send(ground(plane, box));
        vertices_.draw();
        const Vec3 light = (plane.normal + 0.35 * view.up.normalized() - 0.3 * view.right.normalized()).normalized();
        glBlendEquation(GL_MIN);
        glEnable(GL_BLEND);
        vertices_.send(shadow(plane, stream_, light));
        vertices_.draw();
        glDisable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
    }
}

}  // namespace rhexis
