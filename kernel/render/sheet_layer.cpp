// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sheet_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "render/depth_pass.hpp"
#include "render/sheet_strain.hpp"
#include "render/vertex_floats.hpp"

namespace rhexis {

namespace {

constexpr std::size_t floats_per_vertex = 10;  ///< of the surface
constexpr double ribbon_mm = 0.12;             ///< half the width of what is drawn along an edge

/// Unit, weighted by area; zero where nothing lies around a node.
std::vector<Vec3> node_normals(const std::vector<std::array<int, 3>>& triangles, const std::vector<Vec3>& places) {
    std::vector<Vec3> normals(places.size(), Vec3::Zero());
    for (const std::array<int, 3>& t : triangles) {
        const Vec3 twice_area = (places[t[1]] - places[t[0]]).cross(places[t[2]] - places[t[0]]);
        for (int node : t) {
            normals[node] += twice_area;
        }
    }
    for (Vec3& normal : normals) {
        normal.normalize();
    }
    return normals;
}

/// On which side of an edge a node shows, and how far: twice the area of the triangle as seen.
double side_of(const SheetEdge& edge, int node, const std::vector<Vec3>& places, const Vec3& view_axis) {
    return view_axis.dot((places[edge.to] - places[edge.from]).cross(places[node] - places[edge.from]));
}

/// Where the sheet ends, or is folded over: both triangles show on the same side.
std::vector<SheetEdge> shown_edges(const std::vector<SheetEdge>& edges, const std::vector<Vec3>& places,
                                   const Vec3& view_axis) {
    std::vector<SheetEdge> shown;
    for (const SheetEdge& edge : edges) {
        if (edge.right < 0 ||
            side_of(edge, edge.left, places, view_axis) * side_of(edge, edge.right, places, view_axis) > 0.0) {
            shown.push_back(edge);
        }
    }
    return shown;
}

/// Away from the sheet, across its edge and the line of sight, at the nodes of edges; shorter than 1 where edges meet
/// at a sharp angle, as at the end of a tear.
std::vector<Vec3> outward_at_edges(const std::vector<SheetEdge>& edges, const std::vector<Vec3>& places,
                                   const Vec3& view_axis) {
    std::vector<Vec3> outward(places.size(), Vec3::Zero());
    for (const SheetEdge& edge : edges) {
        const Vec3 left_side = view_axis.cross(places[edge.to] - places[edge.from]).normalized();
        const Vec3 away = side_of(edge, edge.left, places, view_axis) > 0.0 ? Vec3(-left_side) : left_side;
        outward[edge.from] += away;
        outward[edge.to] += away;
    }
    for (Vec3& way : outward) {
        way /= std::max(1.0, way.norm());
    }
    return outward;
}

}  // namespace

Result<SheetLayer> SheetLayer::create(int width, int height) {
    Result<Program> surface = Program::build({"sheet.vert"}, {"sheet.frag"});
    if (!surface.ok()) {
        return surface.error();
    }
    Result<Program> edge = Program::build({"sheet_edge.vert"}, {"sheet_edge.frag"});
    if (!edge.ok()) {
        return edge.error();
    }
    return SheetLayer(std::move(surface).value(), std::move(edge).value(), width, height);
}

SheetLayer::SheetLayer(Program surface, Program edge, int width, int height)
    : surface_(std::move(surface)),
      edge_(std::move(edge)),
      sheets_(make_single_target(width, height, GL_RGBA8, GL_LINEAR)),
      surface_vertices_({3, 3, 4}),
      edge_vertices_({3, 3}) {}

const SmoothSheet& SheetLayer::smoothed(std::size_t membrane, const std::shared_ptr<const MembraneSheet>& sheet) {
    if (membrane >= smooth_.size()) {
        smooth_.emplace_back(sheet);
    } else if (smooth_[membrane].sheet() != sheet) {
        smooth_[membrane] = SmoothSheet(sheet);
    }
    return smooth_[membrane];
}

/// The model of a scene does not change but for bodies that come apart, which makes it another.
const ShellSurface& SheetLayer::closed(std::size_t shell, const Frame& frame) {
    if (closed_of_ != frame.model) {
        closed_of_ = frame.model;
        closed_.clear();
        for (const ShellModel& model : frame.model->shells) {
            closed_.emplace_back(model);
        }
    }
    return closed_[shell];
}

/// folds: of the wrinkles, or empty.
void SheetLayer::collect_surface(const std::vector<std::array<int, 3>>& triangles, const std::vector<Vec3>& rest_places,
                                 const std::vector<Vec3>& folds, double reach) {
    const std::vector<Vec3> normals = node_normals(triangles, places_);
    const GLuint first = static_cast<GLuint>(surface_stream_.size() / floats_per_vertex);
    for (std::size_t node = 0; node < places_.size(); ++node) {
        append_floats(places_[node], surface_stream_);
        append_floats(normals[node], surface_stream_);
        const Vec3& rest = rest_places[node];
        const Vec3 fold = folds.empty() ? Vec3(Vec3::Zero()) : folds[node];
        for (double number : {rest.x(), rest.y(), fold.x(), fold.y()}) {
            surface_stream_.push_back(static_cast<float>(number));
        }
    }
    for (const std::array<int, 3>& t : triangles) {
        // Not "beyond": what is not finite is not within.
        const bool within = places_[t[0]].head<2>().norm() < reach && std::isfinite(places_[t[0]].z());
        if (!within || !(places_[t[1]] + places_[t[2]]).allFinite()) {
            continue;
        }
        for (int node : t) {
            surface_indices_.push_back(first + static_cast<GLuint>(node));
        }
    }
}

void SheetLayer::collect_edges(const std::vector<SheetEdge>& all, const Vec3& view_axis) {
    const std::vector<Vec3>& places = places_;
    const std::vector<SheetEdge> edges = shown_edges(all, places, view_axis);
    const std::vector<Vec3> outward = outward_at_edges(edges, places, view_axis);
    const auto corner = [&](int node, double across) {
        append_floats(places[node] + across * outward[node], edge_stream_);
        append_floats({outward[node].x(), outward[node].y(), across}, edge_stream_);
    };
    for (const SheetEdge& edge : edges) {
        if (!(places[edge.from] + places[edge.to] + outward[edge.from] + outward[edge.to]).allFinite()) {
            continue;
        }
        corner(edge.from, -ribbon_mm);
        corner(edge.to, -ribbon_mm);
        corner(edge.to, ribbon_mm);
        corner(edge.from, -ribbon_mm);
        corner(edge.to, ribbon_mm);
        corner(edge.from, ribbon_mm);
    }
}

void SheetLayer::draw(const Frame& frame, const View& view, const Texture& stop, const Vec3& reference,
                      const Vec3& contour, const Texture& detail, const PixelRect& area, double reach) {
    surface_stream_.clear();
    surface_indices_.clear();
    edge_stream_.clear();
    for (std::size_t i = 0; i < frame.membranes.size(); ++i) {
        const SmoothSheet& sheet = smoothed(i, frame.membranes[i].sheet);
        places_ = sheet.refined(frame.membranes[i].position);
        collect_surface(sheet.triangles(), sheet.rest(), sheet.refined(wrinkles(frame.membranes[i])), reach);
        collect_edges(sheet.edges(), view.axis);
    }
    const std::size_t sheets_end = surface_indices_.size();
    for (std::size_t i = 0; i < frame.shells.size(); ++i) {
        if (frame.shells[i].loaded) {
            continue;  // it lies in an injector outside the eye
        }
        const ShellSurface& shell = closed(i, frame);
        places_ = shell.places(frame.shells[i]);
        collect_surface(shell.triangles(), shell.rest(), {}, reach);
        collect_edges(shell.edges(), view.axis);
    }
    const Scissor scissor(area);
    sheets_.bind();
    const std::array<GLfloat, 4> none{};
    glClearBufferfv(GL_COLOR, 0, none.data());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (Program* program : {&surface_, &edge_}) {
        program->use();
        set_view(*program, view);
        program->set("reference", reference);
        program->set("stop", stop, 0);
        program->set("detail_map", detail, 1);
        program->set("contour", contour);
        program->set("pixel_mm", pixel_mm(view, reference));
        if (program == &surface_) {
            const std::span<const GLuint> all(surface_indices_);
            for (const bool body : {false, true}) {
                program->set("body", body ? 1 : 0);
                surface_vertices_.send(surface_stream_, body ? all.subspan(sheets_end) : all.first(sheets_end));
                surface_vertices_.draw();
            }
        } else {
            edge_vertices_.send(edge_stream_);
            edge_vertices_.draw();
        }
    }
    glDisable(GL_BLEND);
}

}  // namespace rhexis
