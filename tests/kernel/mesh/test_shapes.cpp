// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/quality.hpp"
#include "mesh/shapes.hpp"

using namespace rhexis;

namespace {

const HalfEllipsoids lens_shape{4.8, 1.95, 2.8};

std::vector<std::uint8_t> surface_nodes(const TetMesh& mesh) {
    std::vector<std::uint8_t> on_surface(mesh.nodes.size(), 0);
    const std::vector<std::array<int, 4>> neighbours = face_neighbours(mesh.tets);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        for (std::size_t k = 0; k < 4; ++k) {
            if (neighbours[t][k] < 0) {
                for (int local : tet_faces[k]) {
                    on_surface[static_cast<std::size_t>(mesh.tets[t][static_cast<std::size_t>(local)])] = 1;
                }
            }
        }
    }
    return on_surface;
}

}  // namespace

TEST_SUITE("mesh") {
    TEST_CASE("a bar fills its block with 5 tetrahedra a cell whose faces meet") {
        const TetMesh mesh = bar(4, 3, 2, 0.5, Vec3(1, 2, 3));
        CHECK(mesh.tets.size() == 5 * 24);
        CHECK(mesh.region.size() == mesh.tets.size());
        CHECK(mesh_volume(mesh) == doctest::Approx(24 * 0.125).epsilon(1e-13));
        CHECK(mesh_quality(mesh).min_ratio > 0.6);
        // Only faces on the block's sides are open: two triangles for each square.
        int open = 0;
        for (const std::array<int, 4>& row : face_neighbours(mesh.tets)) {
            open += static_cast<int>(std::count(row.begin(), row.end(), -1));
        }
        CHECK(open == 2 * 2 * (4 * 3 + 3 * 2 + 4 * 2));
        CHECK(nodes_on_plane(mesh, Vec3(1, 2, 3), Vec3::UnitX()).size() == 4 * 3);
        CHECK(nodes_on_plane(mesh, Vec3(0, 0, 4), Vec3::UnitZ()).size() == 5 * 4);
        CHECK(nodes_on_plane(mesh, Vec3(0, 0, 9), Vec3::UnitZ()).empty());
    }

    TEST_CASE("the radius ratio is 1 for the regular tetrahedron, 0 for a flat one, negative for an inverted one") {
        const Vec3 a(1, 1, 1);
        const Vec3 b(1, -1, -1);
        const Vec3 c(-1, 1, -1);
        const Vec3 d(-1, -1, 1);
        CHECK(std::abs(radius_ratio(a, b, c, d)) == doctest::Approx(1.0).epsilon(1e-14));
        CHECK(radius_ratio(a, b, c, d) == -radius_ratio(a, c, b, d));
        CHECK(radius_ratio(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)) == 0.0);
        CHECK(std::abs(shortest_height(a, b, c, d)) == doctest::Approx(4.0 / std::sqrt(3.0)).epsilon(1e-14));
    }

    TEST_CASE("a lens body has the requested number of tetrahedra, within 3 %, from 500 to 24,000") {
        for (int wanted : {500, 700, 1000, 1700, 3000, 5000, 8000, 12000, 24000}) {
            CAPTURE(wanted);
            const TetMesh mesh = lens_body(lens_shape, wanted);
            CHECK(std::abs(static_cast<double>(mesh.tets.size()) / wanted - 1.0) < 0.03);
        }
    }

    TEST_CASE("lens bodies of every age's shape are well shaped and have their surface nodes on the surface") {
        for (const HalfEllipsoids& shape : {lens_shape, HalfEllipsoids{4.5, 1.7, 2.5}, HalfEllipsoids{5.0, 2.1, 3.0},
                                            HalfEllipsoids{4.6, 2.2, 2.2}}) {
            const TetMesh mesh = lens_body(shape, 3000);
            CHECK(mesh.tets.size() >= 2900);
            CHECK(mesh.tets.size() <= 3100);
            const MeshQuality quality = mesh_quality(mesh);
            CHECK(quality.min_ratio >= 0.2);
            CHECK(quality.mean_ratio >= 0.8);
            CHECK(quality.min_height >= 0.15);
            CHECK(std::abs(quality.volume / shape_volume(shape) - 1.0) < 0.025);
            const std::vector<std::uint8_t> on_surface = surface_nodes(mesh);
            for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
                const double level = surface_level(shape, mesh.nodes[n]);
                CHECK((on_surface[n] != 0 ? std::abs(level - 1.0) < 1e-12 : level < 0.99));
            }
        }
    }

    TEST_CASE("the surface of a lens body is closed, in one piece and without handles") {
        const TetMesh mesh = lens_body(lens_shape, 3000);
        int faces = 0;
        for (const std::array<int, 4>& row : face_neighbours(mesh.tets)) {
            faces += static_cast<int>(std::count(row.begin(), row.end(), -1));
        }
        int nodes = 0;
        for (std::uint8_t flag : surface_nodes(mesh)) {
            nodes += flag;
        }
        CHECK(nodes - faces / 2 == 2);  // Euler: V - E + F with E = 3 F / 2
    }

    TEST_CASE("a ball's volume deficit falls with the square of the element size") {
        const double exact = 4.0 / 3.0 * std::numbers::pi * 8.0;
        const double coarse = 1.0 - mesh_volume(ball(2.0, 1000)) / exact;
        const double fine = 1.0 - mesh_volume(ball(2.0, 8000)) / exact;
        CHECK(coarse > 0.0);
        CHECK(fine / coarse == doctest::Approx(0.25).epsilon(0.3));
    }

    TEST_CASE("the same request gives the same mesh, bit for bit") {
        const TetMesh a = lens_body(lens_shape, 1000);
        const TetMesh b = lens_body(lens_shape, 1000);
        CHECK(a.tets == b.tets);
        CHECK(a.nodes == b.nodes);
    }
}
