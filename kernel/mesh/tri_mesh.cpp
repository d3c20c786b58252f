// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tri_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/index.hpp"
#include "base/numbers.hpp"

namespace rhexis {
namespace {

/// A directed edge of a triangle.
struct HalfEdge {
    int from;
    int to;
    int triangle;

    [[nodiscard]] std::array<int, 2> key() const { return {std::min(from, to), std::max(from, to)}; }
};

/// Sorted so that the sides of an edge stand together, in the order of their triangles.
std::vector<HalfEdge> sorted_half_edges(const TriMesh& mesh) {
    std::vector<HalfEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        for (int k = 0; k < 3; ++k) {
            edges.push_back({mesh.triangles[at(t)][at((k + 1) % 3)], mesh.triangles[at(t)][at((k + 2) % 3)], t});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return a.key() != b.key() ? a.key() < b.key() : a.triangle < b.triangle;
    });
    return edges;
}

std::string edge_name(const HalfEdge& e) { return "edge " + std::to_string(e.from) + "-" + std::to_string(e.to); }

/// The first triangle that runs from one node to another, or -1.
int triangle_with(const TriMesh& mesh, const TriNeighbours& around, int from, int to) {
    for (int i = around.offset[at(from)]; i < around.offset[at(from) + 1]; ++i) {
        const std::array<int, 3>& n = mesh.triangles[at(around.triangles[at(i)])];
        if ((n[0] == from && n[1] == to) || (n[1] == from && n[2] == to) || (n[2] == from && n[0] == to)) {
            return around.triangles[at(i)];
        }
    }
    return -1;
}

Status check_nodes(const TriMesh& mesh, const std::string& where, UnusedNodes unused) {
    std::vector<std::uint8_t> used(mesh.nodes.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::array<int, 3>& nodes = mesh.triangles[t];
        for (const int node : nodes) {
            if (node < 0 || node >= static_cast<int>(mesh.nodes.size())) {
                return Error{"triangle " + std::to_string(t) + " has node " + std::to_string(node), where,
                             "0 to " + std::to_string(mesh.nodes.size() - 1)};
            }
            used[at(node)] = 1;
        }
        if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]) {
            return Error{"triangle " + std::to_string(t) + " has the same node twice", where, "three different nodes"};
        }
    }
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (!mesh.nodes[n].allFinite()) {
            return Error{"node " + std::to_string(n) + " is not finite", where, "numbers"};
        }
        if (used[n] == 0 && unused == UnusedNodes::refused) {
            return Error{"node " + std::to_string(n) + " belongs to no triangle", where, "nodes that are used"};
        }
    }
    return success();
}

Status check_areas(const TriMesh& mesh, const std::string& where) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::array<int, 3>& n = mesh.triangles[t];
        const Vec3& a = mesh.nodes[at(n[0])];
        const Vec3& b = mesh.nodes[at(n[1])];
        const Vec3& c = mesh.nodes[at(n[2])];
        const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        if (!(triangle_area(a, b, c) > 1e-6 * longest * longest)) {
            return Error{"triangle " + std::to_string(t) + " is flat", where, "triangles with an area"};
        }
    }
    return success();
}

Status check_edges(const TriMesh& mesh, const std::string& where) {
    const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i + 2 < edges.size() && edges[i].key() == edges[i + 2].key()) {
            return Error{edge_name(edges[i]) + " is shared by triangles " + std::to_string(edges[i].triangle) + ", " +
                             std::to_string(edges[i + 1].triangle) + " and " + std::to_string(edges[i + 2].triangle),
                         where, "at most two triangles at an edge"};
        }
        if (i + 1 < edges.size() && edges[i].key() == edges[i + 1].key() && edges[i].from == edges[i + 1].from) {
            return Error{"triangles " + std::to_string(edges[i].triangle) + " and " +
                             std::to_string(edges[i + 1].triangle) + " at " + edge_name(edges[i]) +
                             " face opposite ways: one of them is flipped",
                         where, "all triangles counter-clockwise seen from the front"};
        }
    }
    return success();
}

/// The triangles around a node must hang together by edges.
Status check_stars(const TriMesh& mesh, const std::string& where) {
    const TriNeighbours neighbours = tri_neighbours(mesh);
    for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
        int ends = 0;  // edges at the node with nothing beyond, seen from one side
        for (int i = neighbours.offset[at(node)]; i < neighbours.offset[at(node) + 1]; ++i) {
            const int t = neighbours.triangles[at(i)];
            for (int k = 0; k < 3; ++k) {
                if (mesh.triangles[at(t)][at((k + 1) % 3)] == node && neighbours.across[at(t)][at(k)] < 0) {
                    ++ends;
                }
            }
        }
        if (ends > 1) {
            return Error{"at node " + std::to_string(node) + " parts of the sheet only touch", where,
                         "parts that share an edge, or no node"};
        }
    }
    return success();
}

/// Everything but who is across an edge.
TriNeighbours stars_of(const TriMesh& mesh) {
    TriNeighbours result;
    result.offset.assign(mesh.nodes.size() + 1, 0);
    for (const std::array<int, 3>& triangle : mesh.triangles) {
        for (const int node : triangle) {
            ++result.offset[at(node) + 1];
        }
    }
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        result.offset[n + 1] += result.offset[n];
    }
    result.triangles.resize(3 * mesh.triangles.size());
    std::vector<int> next(result.offset.begin(), result.offset.end() - 1);
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        for (const int node : mesh.triangles[at(t)]) {
            result.triangles[at(next[at(node)]++)] = t;
        }
    }
    return result;
}

void look_across(const TriMesh& mesh, std::size_t t, TriNeighbours& neighbours) {
    for (std::size_t k = 0; k < 3; ++k) {
        neighbours.across[t][k] =
            triangle_with(mesh, neighbours, mesh.triangles[t][(k + 2) % 3], mesh.triangles[t][(k + 1) % 3]);
    }
}

}  // namespace

TriNeighbours tri_neighbours(const TriMesh& mesh) {
    TriNeighbours result = stars_of(mesh);
    result.across.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        look_across(mesh, t, result);
    }
    return result;
}

TriNeighbours tri_neighbours(const TriMesh& mesh, const TriNeighbours& before, std::span<const int> changed) {
    TriNeighbours result = stars_of(mesh);
    result.across = before.across;
    result.across.resize(mesh.triangles.size(), {-1, -1, -1});
    const auto look = [&](const std::array<int, 3>& triangles) {
        for (const int t : triangles) {
            if (t >= 0) {
                look_across(mesh, at(t), result);
            }
        }
    };
    for (const int t : changed) {
        look(at(t) < before.across.size() ? before.across[at(t)] : std::array{-1, -1, -1});
        look_across(mesh, at(t), result);
        look(result.across[at(t)]);
    }
    return result;
}

std::vector<std::uint8_t> on_boundary(const TriMesh& mesh, const TriNeighbours& neighbours) {
    std::vector<std::uint8_t> result(mesh.nodes.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (neighbours.across[t][k] < 0) {
                result[at(mesh.triangles[t][(k + 1) % 3])] = 1;
                result[at(mesh.triangles[t][(k + 2) % 3])] = 1;
            }
        }
    }
    return result;
}

Vec3 triangle_middle(const TriMesh& mesh, int triangle) {
    const std::array<int, 3>& n = mesh.triangles[at(triangle)];
    return (mesh.nodes[at(n[0])] + mesh.nodes[at(n[1])] + mesh.nodes[at(n[2])]) / 3.0;
}

int nearest_triangle(const TriMesh& mesh, const Vec3& place) {
    int nearest = 0;
    double least = HUGE_VAL;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const double distance = (triangle_middle(mesh, t) - place).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = t;
        }
    }
    return nearest;
}

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) { return 0.5 * (b - a).cross(c - a).norm(); }

double mesh_area(const TriMesh& mesh) {
    double sum = 0.0;
    for (const std::array<int, 3>& t : mesh.triangles) {
        sum += triangle_area(mesh.nodes[at(t[0])], mesh.nodes[at(t[1])], mesh.nodes[at(t[2])]);
    }
    return sum;
}

double largest_cosine(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto cosine = [](const Vec3& u, const Vec3& v) {
        return u.dot(v) / std::sqrt(u.squaredNorm() * v.squaredNorm());
    };
    return std::max({cosine(b - a, c - a), cosine(c - b, a - b), cosine(a - c, b - c)});
}

double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::acos(std::min(1.0, largest_cosine(a, b, c)));
}

double smallest_angle(const TriMesh& mesh) {
    double least = M_PI;
    for (const std::array<int, 3>& t : mesh.triangles) {
        least = std::min(least, smallest_angle(mesh.nodes[at(t[0])], mesh.nodes[at(t[1])], mesh.nodes[at(t[2])]));
    }
    return least;
}

double mean_edge(const TriMesh& mesh) {
    double sum = 0.0;
    for (const std::array<int, 3>& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            sum += (mesh.nodes[at(t[k])] - mesh.nodes[at(t[(k + 1) % 3])]).norm();
        }
    }
    return mesh.triangles.empty() ? 0.0 : sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

Status validate_tri_mesh(const TriMesh& mesh, const std::string& where, UnusedNodes unused) {
    if (mesh.triangles.empty()) {
        return Error{"there is no triangle", where, "at least one"};
    }
    if (Status status = check_nodes(mesh, where, unused); !status) {
        return status;
    }
    for (const auto& check : {check_areas, check_edges, check_stars}) {
        if (Status status = check(mesh, where); !status) {
            return status;
        }
    }
    return success();
}

std::vector<std::vector<int>> boundary_loops(const TriMesh& mesh, const TriNeighbours& neighbours) {
    std::vector<int> next(mesh.nodes.size(), -1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (neighbours.across[t][k] < 0) {
                next[at(mesh.triangles[t][(k + 1) % 3])] = mesh.triangles[t][(k + 2) % 3];
            }
        }
    }
    std::vector<std::vector<int>> loops;
    for (int start = 0; start < static_cast<int>(next.size()); ++start) {
        if (next[at(start)] < 0) {
            continue;
        }
        std::vector<int>& loop = loops.emplace_back();
        for (int node = start; next[at(node)] >= 0;) {
            loop.push_back(node);
            const int following = next[at(node)];
            next[at(node)] = -1;
            node = following;
        }
    }
    return loops;
}

std::vector<int> sheet_parts(const TriNeighbours& neighbours) {
    std::vector<int> part(neighbours.across.size(), -1);
    std::vector<int> waiting;
    int count = 0;
    for (int first = 0; first < static_cast<int>(part.size()); ++first) {
        if (part[at(first)] >= 0) {
            continue;
        }
        part[at(first)] = count;
        waiting.push_back(first);
        while (!waiting.empty()) {
            const int t = waiting.back();
            waiting.pop_back();
            for (const int other : neighbours.across[at(t)]) {
                if (other >= 0 && part[at(other)] < 0) {
                    part[at(other)] = count;
                    waiting.push_back(other);
                }
            }
        }
        ++count;
    }
    return part;
}

}  // namespace rhexis
