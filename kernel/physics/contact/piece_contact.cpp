// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/piece_contact.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "mesh/nearest_place.hpp"
#include "physics/contact/box_grid.hpp"

namespace rhexis {

namespace {

constexpr double pair_reach = 0.35;   ///< pairs are sought this far, the size of a fine tetrahedron [mm]
constexpr double facing = -0.2;       ///< cosine between normals above which surfaces do not face each other
constexpr double most_beside = 0.05;  ///< a vertex farther beside a triangle is not before it [mm]
constexpr double farthest = pair_reach + most_beside;  ///< that a triangle which a vertex meets lies from it [mm]

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

/// Where points lie that may meet a triangle: most that are asked for do not, and this is all that is read for them.
struct Reach {
    Vec3 centre = Vec3::Zero();
    double square = 0.0;  ///< of the radius [mm^2]

    [[nodiscard]] bool holds(const Vec3& point) const { return (point - centre).squaredNorm() <= square; }
};

Reach reach_of(const Face& face) {
    const auto& [a, b, c] = face.corners;
    Reach reach;
    reach.centre = (a + b + c) / 3.0;
    const double square = std::max(
        {(a - reach.centre).squaredNorm(), (b - reach.centre).squaredNorm(), (c - reach.centre).squaredNorm()});
    reach.square = (std::sqrt(square) + farthest) * (std::sqrt(square) + farthest);
    return reach;
}

/// The triangles of one piece.
struct Piece {
    int id = 0;
    Box box;
    std::vector<int> faces;
    std::vector<Reach> reaches;  ///< of each
    BoxGrid grid;                ///< by place in `faces`
};

std::vector<Piece> pieces_of(const std::vector<Face>& faces) {
    std::vector<int> order(faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return faces[a].piece < faces[b].piece; });
    std::vector<Piece> pieces;
    std::vector<Box> boxes;
    for (auto first = order.begin(); first != order.end();) {
        const int id = faces[*first].piece;
        const auto last = std::find_if(first, order.end(), [&](int f) { return faces[f].piece != id; });
        Piece& piece = pieces.emplace_back();
        piece.id = id;
        piece.faces.assign(first, last);
        boxes.assign(piece.faces.size(), Box{});
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            for (const Vec3& corner : faces[piece.faces[i]].corners) {
                boxes[i].add(corner, 0.0);
                piece.box.add(corner, farthest);
            }
        }
        piece.grid.fill(boxes);
        std::transform(first, last, std::back_inserter(piece.reaches), [&](int f) { return reach_of(faces[f]); });
        first = last;
    }
    return pieces;
}

/// What a vertex meets of the pieces that are not its own.
Meeting meet_others(const std::vector<Piece>& pieces, const std::vector<Face>& faces, int own, const Vec3& point,
                    const Vec3& normal) {
    Meeting best;
    for (const Piece& piece : pieces) {
        if (piece.id != own && piece.box.holds(point)) {
            piece.grid.near(point, farthest, [&](int i) {
                const std::size_t place = static_cast<std::size_t>(i);
                if (piece.reaches[place].holds(point)) {
                    meet(faces[piece.faces[place]], piece.faces[place], point, normal, best);
                }
            });
        }
    }
    return best;
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
    const std::vector<Piece> pieces = pieces_of(faces);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (vertices[v].between) {  // its two nodes are there for it
            continue;
        }
        const Meeting best = meet_others(pieces, faces, vertices[v].piece, points[v], normals[v]);
        if (best.face >= 0) {
            pairs.push_back({contact_point(vertices[v]), foot_of(surface, best), faces[best.face].normal});
        }
    }
}

}  // namespace rhexis
