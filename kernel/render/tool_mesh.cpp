// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rhexis {

namespace {

constexpr int sides = 40;
constexpr int cap_rings = 6;
constexpr double beyond_mm = 60.0;  ///< how far a shaft goes on behind its last part

using Part = ToolMesh::Part;
using Vertex = ToolMesh::Vertex;

/// A circle of a surface of revolution: radius and height along the part's axis, and the normal's two components.
struct Ring {
    double radius;
    double height;
    double normal_out;
    double normal_along;
};

/// Frame of a part: origin at its end `a`, axis to `b`.
struct Frame3 {
    Vec3 origin;
    Vec3 x;
    Vec3 y;
    Vec3 axis;
};

Frame3 frame_of(const RoundedCone& cone) {
    Frame3 frame;
    frame.origin = cone.a;
    const Vec3 along = cone.b - cone.a;
    frame.axis = along.norm() > 1e-12 ? Vec3(along.normalized()) : Vec3(Vec3::UnitZ());
    frame.x = std::abs(frame.axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    frame.x = (frame.x - frame.x.dot(frame.axis) * frame.axis).normalized();
    frame.y = frame.axis.cross(frame.x);
    return frame;
}

Vertex on_ring(const Frame3& frame, const Ring& ring, int side) {
    const double angle = 2.0 * std::numbers::pi * (side % sides) / sides;
    const Vec3 out = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
    return {frame.origin + ring.radius * out + ring.height * frame.axis,
            (ring.normal_out * out + ring.normal_along * frame.axis).normalized()};
}

void add_quad(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d, Part& part) {
    part.corners.insert(part.corners.end(), {a, b, c, a, c, d});
}

/// Rings in order of height make outward faces; in the opposite order faces that look inwards.
void add_rings(const Frame3& frame, const std::vector<Ring>& rings, Part& part) {
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
        for (int side = 0; side < sides; ++side) {
            add_quad(on_ring(frame, rings[i], side), on_ring(frame, rings[i], side + 1),
                     on_ring(frame, rings[i + 1], side + 1), on_ring(frame, rings[i + 1], side), part);
        }
    }
}

/// Outline of a cone with round ends: two balls and their common tangent.
std::vector<Ring> outline(const RoundedCone& cone) {
    const double length = (cone.b - cone.a).norm();
    const double slope = length > 1e-12 ? std::clamp((cone.radius_a - cone.radius_b) / length, -1.0, 1.0) : 0.0;
    const double tangent = std::asin(slope);  // latitude at which the cone leaves both balls
    std::vector<Ring> rings;
    const double quarter = 0.5 * std::numbers::pi;
    for (int i = 0; i <= cap_rings; ++i) {
        const double latitude = -quarter + (tangent + quarter) * i / cap_rings;
        rings.push_back({cone.radius_a * std::cos(latitude), cone.radius_a * std::sin(latitude), std::cos(latitude),
                         std::sin(latitude)});
    }
    for (int i = 0; i <= cap_rings; ++i) {
        const double latitude = tangent + (quarter - tangent) * i / cap_rings;
        rings.push_back({cone.radius_b * std::cos(latitude), length + cone.radius_b * std::sin(latitude),
                         std::cos(latitude), std::sin(latitude)});
    }
    return rings;
}

Part round_part(const RoundedCone& cone, ToolFinish finish) {
    Part part;
    part.finish = finish;
    add_rings(frame_of(cone), outline(cone), part);
    return part;
}

/// A vertex of the needle's end, cut by the bevel: the lip lies at local -y, the opening looks to +y.
Vertex on_cut(const Frame3& frame, const Ring& ring, int side, double slope, double outer) {
    Vertex vertex = on_ring(frame, ring, side);
    vertex.place += slope * (frame.y.dot(vertex.place - frame.origin) + outer) * frame.axis;
    return vertex;
}

void add_cut_strip(const Frame3& frame, const std::array<Ring, 2>& rings, const std::array<double, 2>& slopes,
                   double outer, Part& part) {
    for (int side = 0; side < sides; ++side) {
        add_quad(on_cut(frame, rings[0], side, slopes[0], outer), on_cut(frame, rings[0], side + 1, slopes[0], outer),
                 on_cut(frame, rings[1], side + 1, slopes[1], outer), on_cut(frame, rings[1], side, slopes[1], outer),
                 part);
    }
}

/// Wall, rim and bore of a hollow needle.
void add_needle(const ToolModel& tool, const RoundedCone& cone, std::vector<Part>& parts) {
    const Frame3 frame = frame_of(cone);
    const double outer = cone.radius_a;
    const double bore = std::min(tool.bore_radius, 0.95 * outer);
    // The needle runs on within its sleeve.
    const Vec3 end = tool.parts.size() > 1 ? tool.parts[1].b : cone.b;
    const double length = std::max((end - cone.a).dot(frame.axis), cone.radius_b);
    const double start = -outer;
    const double slope = std::tan(std::clamp(tool.bevel, 0.0, 1.2));
    Part wall;
    wall.finish = ToolFinish::titanium;
    add_cut_strip(frame, {Ring{outer, start, 1.0, 0.0}, Ring{cone.radius_b, length, 1.0, 0.0}}, {slope, 0.0}, outer,
                  wall);
    add_cut_strip(frame, {Ring{bore, start, 0.0, -1.0}, Ring{outer, start, 0.0, -1.0}}, {slope, slope}, outer, wall);
    Part inside;
    inside.finish = ToolFinish::bore;
    const double depth = start + 2.0 * outer * slope + 4.0 * outer;
    add_cut_strip(frame, {Ring{bore, depth, -1.0, 0.0}, Ring{bore, start, -1.0, 0.0}}, {0.0, slope}, outer, inside);
    add_rings(frame, {Ring{0.0, depth, 0.0, -1.0}, Ring{bore, depth, 0.0, -1.0}}, inside);
    parts.push_back(std::move(wall));
    parts.push_back(std::move(inside));
}

RoundedCone continued(RoundedCone cone) {
    const Vec3 along = cone.b - cone.a;
    if (along.norm() > 4.0 * std::max(cone.radius_a, cone.radius_b)) {
        cone.b += beyond_mm * along.normalized();
    }
    return cone;
}

ToolFinish finish_of(const ToolModel& tool, std::size_t part) {
    if (tool.kind != ToolKind::phaco) {
        return ToolFinish::steel;
    }
    return part == 1 ? ToolFinish::sleeve : ToolFinish::titanium;
}

}  // namespace

void append_triangles(const ToolMesh::Part& part, std::vector<float>& stream) {
    stream.reserve(stream.size() + 6 * part.corners.size());
    for (const Vertex& corner : part.corners) {
        for (const Vec3* triple : {&corner.place, &corner.normal}) {
            for (int i = 0; i < 3; ++i) {
                stream.push_back(static_cast<float>((*triple)[i]));
            }
        }
    }
}

std::vector<RoundedCone> drawn_parts(const ToolModel& tool) {
    std::vector<RoundedCone> parts = tool.parts;
    if (!parts.empty()) {
        parts.back() = continued(parts.back());
    }
    return parts;
}

ToolMesh tool_mesh(const ToolModel& tool) {
    ToolMesh mesh;
    const std::vector<RoundedCone> parts = drawn_parts(tool);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const RoundedCone& cone = parts[i];
        if (i == 0 && tool.kind == ToolKind::phaco && tool.bore_radius > 0.0) {
            add_needle(tool, cone, mesh.parts);
        } else {
            mesh.parts.push_back(round_part(cone, finish_of(tool, i)));
        }
    }
    std::stable_partition(mesh.parts.begin(), mesh.parts.end(),
                          [](const Part& part) { return part.finish != ToolFinish::sleeve; });
    return mesh;
}

}  // namespace rhexis
