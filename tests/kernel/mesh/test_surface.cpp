// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "base/rng.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/shapes.hpp"
#include "mesh/surface.hpp"

using namespace rhexis;

namespace {

/// Volume inside an outward-oriented closed surface.
double enclosed(const Surface& surface, const std::vector<Vec3>& x) {
    double sum = 0.0;
    for (const std::array<int, 3>& triangle : surface.triangles) {
        sum += x[static_cast<std::size_t>(triangle[0])].dot(
            x[static_cast<std::size_t>(triangle[1])].cross(x[static_cast<std::size_t>(triangle[2])]));
    }
    return sum / 6.0;
}

/// Every directed edge is met as often as its opposite.
bool closed(const Surface& surface) {
    std::map<std::pair<int, int>, int> balance;
    for (const std::array<int, 3>& triangle : surface.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = triangle[i];
            const int b = triangle[(i + 1) % 3];
            balance[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    }
    return std::all_of(balance.begin(), balance.end(), [](const auto& entry) { return entry.second == 0; });
}

}  // namespace

TEST_SUITE("mesh") {
    TEST_CASE("the surface of a whole mesh is closed, faces outward and encloses its volume") {
        const TetMesh mesh = lens_body({4.8, 1.95, 2.8}, 500);
        const Surface surface = surface_of(mesh);
        CHECK(closed(surface));
        CHECK(enclosed(surface, mesh.nodes) == doctest::Approx(mesh_volume(mesh)).epsilon(1e-12));
        CHECK(std::is_sorted(surface.vertices.begin(), surface.vertices.end()));
    }

    TEST_CASE("whatever is taken away, the surface encloses what is left") {
        const TetMesh mesh = bar(3, 3, 3, 1.0);
        const FineMesh fine = subdivide(mesh);
        std::vector<Vec3> x;
        fine_positions(fine, mesh.nodes, x);
        std::vector<double> left(fine.tets.size(), 1.0);
        Rng rng(9);
        for (int round = 0; round < 40; ++round) {
            for (int i = 0; i < 27; ++i) {
                left[static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(left.size()) - 1))] =
                    rng.uniform() < 0.7 ? 0.0 : 0.4;
            }
            double volume = 0.0;
            for (std::size_t t = 0; t < left.size(); ++t) {
                volume += left[t] > 0.0 ? 1.0 / 6.0 / 8.0 * ((t / 8) % 5 == 4 ? 2.0 : 1.0) : 0.0;
            }
            const Surface surface = surface_of(fine.tets, fine.neighbours, left);
            CHECK(closed(surface));
            CHECK(enclosed(surface, x) == doctest::Approx(volume).epsilon(1e-12));
            for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
                CHECK(left[static_cast<std::size_t>(surface.tet[i])] > 0.0);
            }
        }
    }

    TEST_CASE("a mask with nothing left has no surface") {
        const TetMesh mesh = bar(1, 1, 1, 1.0);
        const std::vector<std::uint8_t> none(mesh.tets.size(), 0);
        const Surface surface = surface_of(mesh.tets, face_neighbours(mesh.tets), std::span(none));
        CHECK(surface.triangles.empty());
        CHECK(surface.vertices.empty());
    }
}
