// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/raw_mesh.hpp"

#include <algorithm>
#include <utility>

namespace rhexis {

namespace {

bool indices_exist(const RawMesh& raw) {
    const int count = static_cast<int>(raw.nodes.size());
    return std::all_of(raw.tets.begin(), raw.tets.end(), [count](const std::array<int, 4>& tet) {
        return std::all_of(tet.begin(), tet.end(), [count](int node) { return node >= 0 && node < count; });
    });
}

/// Leaves out the nodes that no tetrahedron uses. Returns how many of them belong to no cell at all.
int drop_unused_nodes(RawMesh& raw) {
    std::vector<std::uint8_t> keep(raw.nodes.size(), 0);
    for (const std::array<int, 4>& tet : raw.tets) {
        for (int node : tet) {
            keep[static_cast<std::size_t>(node)] = 1;
        }
    }
    std::vector<int> new_index(raw.nodes.size(), -1);
    std::size_t kept = 0;
    int of_no_cell = 0;
    for (std::size_t n = 0; n < keep.size(); ++n) {
        of_no_cell += keep[n] == 0 && raw.in_lower_cell[n] == 0 ? 1 : 0;
        if (keep[n] != 0) {
            new_index[n] = static_cast<int>(kept);
            raw.nodes[kept] = raw.nodes[n];
            raw.node_line[kept] = raw.node_line[n];
            raw.node_number[kept] = raw.node_number[n];
            ++kept;
        }
    }
    raw.nodes.resize(kept);
    raw.node_line.resize(kept);
    raw.node_number.resize(kept);
    for (std::array<int, 4>& tet : raw.tets) {
        for (int& node : tet) {
            node = new_index[static_cast<std::size_t>(node)];
        }
    }
    return of_no_cell;
}

std::vector<int> distinct(std::vector<int> values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

constexpr int most_region = 999;

/// Regions from tags, and the tag of each region.
std::vector<int> make_regions(const std::vector<int>& tags, bool rank_tags, std::vector<int>& region) {
    std::vector<int> used = distinct(tags);
    if (rank_tags || (!used.empty() && (used.front() < 0 || used.back() > most_region))) {
        for (int tag : tags) {
            region.push_back(static_cast<int>(std::lower_bound(used.begin(), used.end(), tag) - used.begin()));
        }
        return used;
    }
    region = tags;
    std::vector<int> own(static_cast<std::size_t>(used.empty() ? 0 : used.back() + 1));
    for (std::size_t r = 0; r < own.size(); ++r) {
        own[r] = static_cast<int>(r);
    }
    return own;
}

}  // namespace

bool add_cell(const CellKind* kind, std::int64_t code, std::span<const int> nodes, CellPlace place, RawMesh& raw,
              TokenReader& reader) {
    if (kind == nullptr || kind->dimension == 3) {
        if (kind == nullptr || kind->nodes != 4 || nodes.size() != 4) {
            reader.fail("cell " + std::to_string(place.number) + " is of type " + std::to_string(code) + " with " +
                            std::to_string(nodes.size()) + " nodes",
                        "tetrahedra of 4 nodes, and points, lines and surfaces, which are left out");
            return false;
        }
        raw.tets.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
        raw.tet_line.push_back(place.line);
        raw.tet_number.push_back(place.number);
        return true;
    }
    if (kind->nodes > 0 && nodes.size() != static_cast<std::size_t>(kind->nodes)) {
        reader.fail("cell " + std::to_string(place.number) + " of type " + std::to_string(code) + " has " +
                        std::to_string(nodes.size()) + " nodes",
                    std::to_string(kind->nodes));
        return false;
    }
    for (int node : nodes) {
        if (node < 0 || static_cast<std::size_t>(node) >= raw.nodes.size()) {
            reader.fail("cell " + std::to_string(place.number) + " uses node " + std::to_string(node),
                        "0 to " + std::to_string(raw.nodes.size() - 1));
            return false;
        }
        raw.in_lower_cell[static_cast<std::size_t>(node)] = 1;
    }
    if (kind->dimension == 2 && kind->nodes == 3) {
        raw.triangles.push_back({nodes[0], nodes[1], nodes[2]});
    }
    return false;
}

Result<MeshFile> finish_mesh(RawMesh raw, bool rank_tags, const std::string& path) {
    MeshFile file;
    if (indices_exist(raw)) {
        file.nodes_of_no_cell = drop_unused_nodes(raw);
    }
    raw.tag.resize(raw.tets.size(), 0);
    file.region_tags = make_regions(raw.tag, rank_tags, file.mesh.region);
    file.mesh.nodes = std::move(raw.nodes);
    file.mesh.tets = std::move(raw.tets);
    const MeshSource source{path, std::move(raw.node_line), std::move(raw.tet_line), std::move(raw.node_number),
                            std::move(raw.tet_number)};
    if (const Status status = validate_mesh(file.mesh, &source); !status.ok()) {
        return status.error();
    }
    return file;
}

Result<TriMesh> finish_sheet(RawMesh raw, const std::string& path) {
    std::vector<int> new_index(raw.nodes.size(), -1);
    for (const std::array<int, 3>& triangle : raw.triangles) {
        for (const int node : triangle) {
            new_index[static_cast<std::size_t>(node)] = 0;
        }
    }
    TriMesh mesh;
    for (std::size_t n = 0; n < raw.nodes.size(); ++n) {
        if (new_index[n] == 0) {
            new_index[n] = static_cast<int>(mesh.nodes.size());
            mesh.nodes.push_back(raw.nodes[n]);
        }
    }
    for (std::array<int, 3>& triangle : raw.triangles) {
        for (int& node : triangle) {
            node = new_index[static_cast<std::size_t>(node)];
        }
    }
    mesh.triangles = std::move(raw.triangles);
    if (const Status status = validate_tri_mesh(mesh, path); !status.ok()) {
        return status.error();
    }
    return mesh;
}

}  // namespace rhexis
