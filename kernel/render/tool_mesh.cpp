// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rhexis {

namespace {

constexpr int sides = 24;
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

void add_own_parts(const ToolModel& tool, ToolMesh& mesh) {
    const std::vector<RoundedCone> parts = drawn_parts(tool);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i == 0 && tool.kind == ToolKind::phaco && tool.bore_radius > 0.0) {
            add_needle(tool, parts[i], mesh.parts);
        } else {
            mesh.parts.push_back(round_part(parts[i], finish_of(tool, i)));
        }
        mesh.bounds.push_back(parts[i]);
    }
}

/// A frame at each point of a wire that turns no more than the wire does.
std::vector<Frame3> frames_along(const std::vector<Vec3>& points) {
    std::vector<Frame3> frames;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 along = points[std::min(i + 1, points.size() - 1)] - points[i == 0 ? 0 : i - 1];
        Frame3 frame;
        frame.origin = points[i];
        frame.axis = along.norm() > 1e-12 ? Vec3(along.normalized()) : Vec3(Vec3::UnitZ());
        const Vec3 before = frames.empty() ? Vec3(Vec3::UnitX()) : frames.back().x;
        Vec3 x = before - before.dot(frame.axis) * frame.axis;
        x = x.norm() > 1e-6 ? x : Vec3(Vec3::UnitY() - frame.axis.y() * frame.axis);
        frame.x = x.normalized();
        frame.y = frame.axis.cross(frame.x);
        frames.push_back(frame);
    }
    return frames;
}

/// A point of a section that is wider across than along.
Vertex on_section(const Frame3& frame, const ToolWire& wire, const Ring& ring, int side) {
    const double angle = 2.0 * std::numbers::pi * (side % sides) / sides;
    const double across = std::cos(angle);
    const double along = std::sin(angle);
    const Vec3 place = wire.section[0] * across * frame.x + wire.section[1] * along * frame.y;
    const Vec3 out = across / wire.section[0] * frame.x + along / wire.section[1] * frame.y;
    return {frame.origin + ring.radius * place + ring.height * frame.axis,
            (ring.normal_out * out.normalized() + ring.normal_along * frame.axis).normalized()};
}

void add_sections(const ToolWire& wire, const Frame3& from, const Ring& a, const Frame3& to, const Ring& b,
                  Part& part) {
    for (int side = 0; side < sides; ++side) {
        add_quad(on_section(from, wire, a, side), on_section(from, wire, a, side + 1),
                 on_section(to, wire, b, side + 1), on_section(to, wire, b, side), part);
    }
}

/// The end of a wire: way -1 its first point, +1 its last. An open one has a hole in it.
void add_end(const ToolWire& wire, const Frame3& frame, double radius, double way, Part& part, Part& hole) {
    const bool round = wire.ends == WireEnds::round;
    const double bore = wire.ends == WireEnds::open ? std::min(wire.bore, 0.9 * radius) : 0.0;
    const auto add = [&](const Ring& outer, const Ring& inner, Part& to) {
        if (way < 0.0) {
            add_sections(wire, frame, inner, frame, outer, to);
        } else {
            add_sections(wire, frame, outer, frame, inner, to);
        }
    };
    if (!round) {
        add({radius, 0.0, 0.0, way}, {bore, 0.0, 0.0, way}, part);
        if (bore > 0.0) {
            add({bore, 0.0, 0.0, way}, {0.0, 0.0, 0.0, way}, hole);
        }
        return;
    }
    const double quarter = 0.5 * std::numbers::pi;
    for (int i = 0; i < cap_rings; ++i) {
        const double from = quarter * i / cap_rings;
        const double to = quarter * (i + 1) / cap_rings;
        const double flat = 0.6;  // rounder than a plane, and not so long as a ball
        add({radius * std::cos(from), way * flat * radius * std::sin(from), std::cos(from), way * std::sin(from)},
            {radius * std::cos(to), way * flat * radius * std::sin(to), std::cos(to), way * std::sin(to)}, part);
    }
}

void add_wire(const ToolWire& wire, const ToolShapePart& of, ToolMesh& mesh) {
    Part part;
    part.finish = of.finish;
    part.hinge = of.hinge;
    Part hole;
    hole.finish = ToolFinish::bore;
    hole.hinge = of.hinge;
    const std::vector<Frame3> frames = frames_along(wire.points);
    for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
        const double length = std::max(1e-9, (wire.points[i + 1] - wire.points[i]).norm());
        const double slope = (wire.radii[i] - wire.radii[i + 1]) / length;
        add_sections(wire, frames[i], {wire.radii[i], 0.0, 1.0, slope}, frames[i + 1],
                     {wire.radii[i + 1], 0.0, 1.0, slope}, part);
        const double wide = std::max(wire.section[0], wire.section[1]);
        mesh.bounds.push_back({wire.points[i], wire.points[i + 1], wide * wire.radii[i], wide * wire.radii[i + 1]});
    }
    add_end(wire, frames.front(), wire.radii.front(), -1.0, part, hole);
    add_end(wire, frames.back(), wire.radii.back(), 1.0, part, hole);
    mesh.parts.push_back(std::move(part));
    if (!hole.corners.empty()) {
        mesh.parts.push_back(std::move(hole));
    }
}

void add_flat(const std::vector<Vec3>& corners, Part& part) {
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        for (const std::size_t at : {std::size_t{0}, i, i + 1}) {
            part.corners.push_back({corners[at], normal});
        }
    }
}

/// Two faces, and an edge that is ground from both down to nothing.
void add_plate(const ToolPlate& plate, const ToolShapePart& of, ToolMesh& mesh) {
    Part part;
    part.finish = of.finish;
    part.hinge = of.hinge;
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : plate.outline) {
        middle += corner / static_cast<double>(plate.outline.size());
    }
    std::vector<Vec3> rim;
    std::array<std::vector<Vec3>, 2> faces;
    double reach = 0.0;
    for (const Vec2& corner : plate.outline) {
        const Vec2 in = middle - corner;
        const Vec2 ground = corner + std::min(plate.edge / std::max(in.norm(), 1e-9), 0.9) * in;
        rim.emplace_back(corner.x(), 0.0, corner.y());
        faces[0].emplace_back(ground.x(), 0.5 * plate.thickness, ground.y());
        faces[1].emplace_back(ground.x(), -0.5 * plate.thickness, ground.y());
        reach = std::max(reach, in.norm());
    }
    const std::size_t n = rim.size();
    add_flat(std::vector<Vec3>(faces[0].rbegin(), faces[0].rend()), part);
    add_flat(faces[1], part);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        add_flat({rim[i], faces[0][i], faces[0][next], rim[next]}, part);
        add_flat({rim[i], rim[next], faces[1][next], faces[1][i]}, part);
    }
    mesh.parts.push_back(std::move(part));
    const Vec3 centre(middle.x(), 0.0, middle.y());
    mesh.bounds.push_back({centre, centre, reach, reach});
}

/// Of a shape. tool: whose own parts it may take.
void add_shape(const ToolShape& shape, const ToolModel& tool, ToolMesh& mesh) {
    for (const ToolShapePart& one : shape.parts) {
        if (one.wire) {
            add_wire(*one.wire, one, mesh);
        } else if (one.plate) {
            add_plate(*one.plate, one, mesh);
        } else if (one.own_part >= 0 && one.own_part < static_cast<int>(tool.parts.size())) {
            const RoundedCone& cone = tool.parts[static_cast<std::size_t>(one.own_part)];
            const Vec3 along = (cone.b - cone.a).normalized();
            // a round end of the cone reaches beyond its middle: a flat one stands where that ends
            const Vec3 from = one.own_part == 0 ? Vec3(cone.a - cone.radius_a * along) : cone.a;
            const double bore = 0.88 * cone.radius_a;
            add_wire({{from, cone.b}, {cone.radius_a, cone.radius_b}, {1.0, 1.0}, one.own_ends, bore}, one, mesh);
        }
    }
}

/// What light comes through is drawn over the rest.
void clear_last(ToolMesh& mesh) {
    std::stable_partition(mesh.parts.begin(), mesh.parts.end(),
                          [](const Part& part) { return !is_clear(part.finish); });
}

/// How far a place lies outside of a cone as thick as its thicker end. [mm]
double outside_of(const RoundedCone& cone, const Vec3& place) {
    const Vec3 along = cone.b - cone.a;
    const double share =
        along.squaredNorm() > 0.0 ? std::clamp((place - cone.a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
    return (place - cone.a - share * along).norm() - std::max(cone.radius_a, cone.radius_b);
}

/// Bevels, edges and ends reach beyond the cones that parts were made along: the nearest grows until it holds them.
void grow_bounds(ToolMesh& mesh) {
    for (const Part& part : mesh.parts) {
        for (const Vertex& corner : part.corners) {
            const auto nearest = std::min_element(mesh.bounds.begin(), mesh.bounds.end(),
                                                  [&](const RoundedCone& a, const RoundedCone& b) {
                                                      return outside_of(a, corner.place) < outside_of(b, corner.place);
                                                  });
            const double outside = outside_of(*nearest, corner.place);
            if (outside > 0.0) {
                nearest->radius_a += outside;
                nearest->radius_b += outside;
            }
        }
    }
}

ToolMesh finished(ToolMesh mesh) {
    clear_last(mesh);
    grow_bounds(mesh);
    return mesh;
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

Pose pose_of(const ToolMesh::Part& part, const ToolState& tool) {
    if (!part.hinge) {
        return tool.pose;
    }
    const Quat turn(Eigen::AngleAxisd(part.hinge->open_rad * tool.jaw, part.hinge->axis));
    return {tool.pose.to_world(part.hinge->about - turn * part.hinge->about), tool.pose.orientation * turn};
}

ToolMesh tool_mesh(const ToolModel& tool) {
    const std::optional<ToolShape> shape = shape_of_instrument(tool.name);
    ToolMesh mesh;
    if (shape) {
        add_shape(*shape, tool, mesh);
    }
    if (!shape || shape->with_own_parts) {
        add_own_parts(tool, mesh);
    }
    return finished(std::move(mesh));
}

ToolMesh tool_mesh(const ToolShape& shape) {
    ToolMesh mesh;
    add_shape(shape, ToolModel{}, mesh);
    return finished(std::move(mesh));
}

}  // namespace rhexis
