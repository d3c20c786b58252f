// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bare_surface.hpp"

#include <array>

#include "mesh/adjacency.hpp"
#include "render/shell_surface.hpp"

namespace rhexis {

namespace {

constexpr double crease = 0.77;  ///< cosine of the angle between faces above which an edge stays sharp

const std::array<Vec3, 6> palette{Vec3(0.80, 0.52, 0.40), Vec3(0.84, 0.66, 0.42), Vec3(0.76, 0.72, 0.62),
                                  Vec3(0.50, 0.62, 0.70), Vec3(0.62, 0.56, 0.70), Vec3(0.56, 0.66, 0.50)};

struct Face {
    std::array<int, 3> nodes;
    Vec3 normal;  ///< twice the area long
    int colour;
};

struct Surface {
    std::vector<Vec3> nodes;
    std::vector<Face> faces;
};

template <typename IsThere, typename ColourOf>
Surface collect(const std::vector<std::array<int, 4>>& tets, const std::vector<std::array<int, 4>>& neighbours,
                std::vector<Vec3> nodes, const IsThere& is_there, const ColourOf& colour_of) {
    Surface surface{std::move(nodes), {}};
    const int count = static_cast<int>(tets.size());
    for (int t = 0; t < count; ++t) {
        for (int k = 0; k < 4 && is_there(t); ++k) {
            const int other = neighbours[t][k];
            if (other >= 0 && is_there(other)) {
                continue;
            }
            Face face{{tets[t][tet_faces[k][0]], tets[t][tet_faces[k][1]], tets[t][tet_faces[k][2]]},
                      Vec3::Zero(),
                      colour_of(t)};
            const Vec3& a = surface.nodes[face.nodes[0]];
            face.normal = (surface.nodes[face.nodes[1]] - a).cross(surface.nodes[face.nodes[2]] - a);
            if (face.normal.allFinite()) {
                surface.faces.push_back(face);
            }
        }
    }
    return surface;
}

Surface surface_of(const SolidModel& model, const SolidState& state, int solid) {
    const auto colour_of = [&](int coarse) { return solid + model.coarse.region[coarse]; };
    if (model.fine.tets.empty()) {
        return collect(
            model.coarse.tets, face_neighbours(model.coarse.tets), state.position,
            [&](int t) { return state.present[t] != 0; }, colour_of);
    }
    std::vector<Vec3> fine;
    fine_positions(model.fine, state.position, fine);
    return collect(
        model.fine.tets, model.fine.neighbours, std::move(fine), [&](int t) { return state.fraction[t] > still_there; },
        [&](int t) { return colour_of(t / 8); });
}

std::vector<std::vector<int>> faces_of_nodes(const Surface& surface) {
    std::vector<std::vector<int>> faces(surface.nodes.size());
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
        for (int node : surface.faces[f].nodes) {
            faces[node].push_back(static_cast<int>(f));
        }
    }
    return faces;
}

Vec3 normal_at(const Surface& surface, const std::vector<int>& around, const Face& face) {
    const Vec3 own = face.normal.normalized();
    Vec3 sum = Vec3::Zero();
    for (int f : around) {
        const Vec3& other = surface.faces[f].normal;
        if (own.dot(other) > crease * other.norm()) {
            sum += other;
        }
    }
    return sum.norm() > 0.0 ? Vec3(sum.normalized()) : own;
}

}  // namespace

namespace {

void append(const Surface& surface, std::vector<float>& stream) {
    const std::vector<std::vector<int>> around = faces_of_nodes(surface);
    for (const Face& face : surface.faces) {
        const Vec3& tint = palette[face.colour % palette.size()];
        for (int corner = 0; corner < 3; ++corner) {
            const int node = face.nodes[corner];
            const Vec3 normal = normal_at(surface, around[node], face);
            const Vec3 from_edges = Vec3::Unit(corner);
            for (const Vec3* triple : {&surface.nodes[node], &normal, &tint, &from_edges}) {
                for (int i = 0; i < 3; ++i) {
                    stream.push_back(static_cast<float>((*triple)[i]));
                }
            }
        }
    }
}

}  // namespace

void append_surface(const SolidModel& model, const SolidState& state, int solid, std::vector<float>& stream) {
    append(surface_of(model, state, solid), stream);
}

void append_sheet(const MembraneState& state, std::vector<float>& stream) {
    constexpr int sheet_colour = 2;
    Surface surface{state.position, {}};
    for (const std::array<int, 3>& nodes : state.sheet->mesh.triangles) {
        const Vec3& a = state.position[nodes[0]];
        const Face face{nodes, (state.position[nodes[1]] - a).cross(state.position[nodes[2]] - a), sheet_colour};
        if (face.normal.allFinite()) {
            surface.faces.push_back(face);
        }
    }
    append(surface, stream);
}

void append_shell(const ShellModel& model, const ShellState& state, std::vector<float>& stream) {
    constexpr int shell_colour = 3;
    const ShellSurface closed(model);
    Surface surface{closed.places(state), {}};
    for (const std::array<int, 3>& nodes : closed.triangles()) {
        const Vec3& a = surface.nodes[nodes[0]];
        const Face face{nodes, (surface.nodes[nodes[1]] - a).cross(surface.nodes[nodes[2]] - a), shell_colour};
        if (face.normal.allFinite()) {
            surface.faces.push_back(face);
        }
    }
    append(surface, stream);
}

}  // namespace rhexis
