// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "base/index.hpp"
#include "mesh/shapes.hpp"
#include "mesh/tet_patches.hpp"

namespace rhexis {
namespace {

std::set<int> nodes_of(const TetMesh& mesh, const std::vector<int>& patch) {
    std::set<int> nodes;
    for (const int t : patch) {
        nodes.insert(mesh.tets[at(t)].begin(), mesh.tets[at(t)].end());
    }
    return nodes;
}

TEST_CASE("each tetrahedron is in one patch, and patches are compact") {
    const TetMesh mesh = bar(6, 3, 3, 1.0);
    const std::vector<std::vector<int>> patches = tet_patches(mesh.tets, 4);
    std::vector<int> times(mesh.tets.size(), 0);
    std::size_t nodes = 0;
    for (const std::vector<int>& patch : patches) {
        CHECK(patch.size() >= 2);
        CHECK(patch.size() <= 6);
        nodes += nodes_of(mesh, patch).size();
        for (const int t : patch) {
            ++times[at(t)];
        }
    }
    CHECK(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
    CHECK(static_cast<double>(nodes) / static_cast<double>(patches.size()) < 8.0);  // four apart would have 16
}

TEST_CASE("patches of one are the tetrahedra, and what touches nothing stays alone") {
    const TetMesh mesh = bar(2, 1, 1, 1.0);
    CHECK(tet_patches(mesh.tets, 1).size() == mesh.tets.size());
    const std::vector<std::array<int, 4>> apart{{0, 1, 2, 3}, {4, 5, 6, 7}};
    CHECK(tet_patches(apart, 4).size() == 2);
    CHECK(tet_patches({}, 4).empty());
}

}  // namespace
}  // namespace rhexis
