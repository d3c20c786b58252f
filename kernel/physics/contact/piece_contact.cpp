// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/piece_contact.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/nearest_place.hpp"
#include "physics/contact/box_grid.hpp"

namespace rhexis {

namespace {

constexpr double pair_reach = 0.35;   ///< pairs are sought this far, the size of a fine tetrahedron [mm]
constexpr double facing = -0.2;       ///< cosine between normals above which surfaces do not face each other
constexpr double most_beside = 0.05;  ///< a vertex farther beside a triangle is not before it [mm]

/// A triangle of the surface where the nodes are now.
struct Face {
    std::array<Vec3, 3> corners;
    Vec3 normal = Vec3::Zero();  ///< unit, outward; zero if it has no area
    int piece = 0;
};

/// What a vertex meets, so far.
struct Meeting {
    int face = -1;
    double rank = HUGE_VAL;
    std::array<double, 3> weights{};
};

std::vector<Face> faces_of(const ContactSurface& surface, const std::vector<Vec3>& points) {
    std::vector<Face> faces;
    faces.reserve(surface.faces().size());
    for (const std::array<int, 3>& corners : surface.faces()) {
        Face face;
        face.corners = {points[corners[0]], points[corners[1]], points[corners[2]]};
        const Vec3 area = (face.corners[1] - face.corners[0]).cross(face.corners[2] - face.corners[0]);
        const double size = area.norm();
        face.normal = size > 0.0 ? Vec3(area / size) : Vec3(Vec3::Zero());
        face.piece = surface.vertices()[corners[0]].piece;
        faces.push_back(face);
    }
    return faces;
}

/// Takes a face that is nearer. Of those that are equally near, as around a corner, the one that faces the vertex most
/// counts as the nearer one, and then the lower: in which order they are visited does not matter.
void meet(const Face& face, int index, const Vec3& point, const Vec3& normal, Meeting& best) {
    const double opposite = normal.dot(face.normal);
    if (!(opposite < facing) || !(std::abs(face.normal.dot(point - face.corners[0])) < pair_reach)) {
        return;
    }
    const std::array<double, 3> weights = nearest_to_point(face.corners, point);
    const Vec3 from_foot = point - place_in(face.corners, weights);
    const double above = face.normal.dot(from_foot);
    const double beside = (from_foot - above * face.normal).norm();
    const double rank = std::abs(above) + beside + most_beside * (1.0 + opposite);
    if (std::abs(above) < pair_reach && beside < most_beside &&
        (rank < best.rank || (rank == best.rank && index < best.face))) {
        best = {index, rank, weights};
    }
}

/// A place of a triangle, by its coarse nodes: no more than four, those of one tetrahedron.
ContactPoint foot_of(const ContactSurface& surface, const Meeting& meeting) {
    ContactPoint foot;
    foot.weights = {0.0, 0.0, 0.0, 0.0};
    std::size_t count = 0;
    const auto add = [&](int node, double weight) {
        const auto end = foot.nodes.begin() + static_cast<std::ptrdiff_t>(count);
        const auto found = std::find(foot.nodes.begin(), end, node);
        count += found == end ? 1 : 0;
        *found = node;
        foot.weights[static_cast<std::size_t>(found - foot.nodes.begin())] += weight;
    };
    for (std::size_t k = 0; k < 3; ++k) {
        const SurfaceVertex& corner = surface.vertices()[surface.faces()[meeting.face][k]];
        for (const int node : corner.nodes) {
            if (node >= 0 && meeting.weights[k] > 0.0) {
                add(node, corner.weight * meeting.weights[k]);
            }
        }
    }
    std::fill(foot.nodes.begin() + static_cast<std::ptrdiff_t>(count), foot.nodes.end(), foot.nodes[0]);
    return foot;
}

}  // namespace

void find_piece_pairs(const ContactSurface& surface, const std::vector<Vec3>& nodes, std::vector<PiecePair>& pairs) {
    pairs.clear();
    if (!surface.in_pieces()) {
        return;
    }
    const std::vector<SurfaceVertex>& vertices = surface.vertices();
    std::vector<Vec3> points;
    points.reserve(vertices.size());
    for (const SurfaceVertex& vertex : vertices) {
        points.push_back(point_of(vertex, nodes));
    }
    std::vector<Vec3> normals;
    surface.normals(nodes, normals);
    const std::vector<Face> faces = faces_of(surface, points);
    std::vector<Box> boxes(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (const Vec3& corner : faces[f].corners) {
            boxes[f].add(corner, 0.0);
        }
    }
    BoxGrid grid;
    grid.fill(boxes);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (vertices[v].between) {  // its two nodes are there for it
            continue;
        }
        Meeting best;
        grid.near(points[v], pair_reach, [&](int f) {
            if (faces[f].piece != vertices[v].piece) {
                meet(faces[f], f, points[v], normals[v], best);
            }
        });
        if (best.face >= 0) {
            pairs.push_back({contact_point(vertices[v]), foot_of(surface, best), faces[best.face].normal});
        }
    }
}

}  // namespace rhexis
