// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/shapes.hpp"
#include "mesh/tet_mesh.hpp"

using namespace rhexis;

namespace {

double fine_volume(const FineMesh& fine, const std::vector<Vec3>& x, std::size_t t) {
    const std::array<int, 4>& tet = fine.tets[t];
    return tet_volume(x[static_cast<std::size_t>(tet[0])], x[static_cast<std::size_t>(tet[1])],
                      x[static_cast<std::size_t>(tet[2])], x[static_cast<std::size_t>(tet[3])]);
}

/// Number of faces that belong to one tetrahedron only.
int open_faces(const std::vector<std::array<int, 4>>& neighbours) {
    int count = 0;
    for (const std::array<int, 4>& row : neighbours) {
        for (int other : row) {
            count += other < 0 ? 1 : 0;
        }
    }
    return count;
}

TetMesh single_tet() {
    return {{Vec3(0, 0, 0), Vec3(2, 0.1, 0), Vec3(0.3, 1.5, 0.2), Vec3(0.4, 0.3, 1)}, {{0, 1, 2, 3}}, {0}};
}

}  // namespace

TEST_SUITE("mesh") {
    TEST_CASE("the faces of a tetrahedron point out of it") {
        const TetMesh mesh = single_tet();
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3& a = mesh.nodes[static_cast<std::size_t>(tet_faces[k][0])];
            const Vec3& b = mesh.nodes[static_cast<std::size_t>(tet_faces[k][1])];
            const Vec3& c = mesh.nodes[static_cast<std::size_t>(tet_faces[k][2])];
            CHECK((b - a).cross(c - a).dot(mesh.nodes[k] - a) < 0.0);
        }
    }

    TEST_CASE("each of the 8 children has an eighth of the volume, positively oriented") {
        for (const TetMesh& mesh : {single_tet(), lens_body({4.6, 1.9, 2.7}, 500)}) {
            const FineMesh fine = subdivide(mesh);
            REQUIRE(fine.tets.size() == 8 * mesh.tets.size());
            std::vector<Vec3> x;
            fine_positions(fine, mesh.nodes, x);
            for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
                const std::array<int, 4>& tet = mesh.tets[t];
                const double whole =
                    tet_volume(x[static_cast<std::size_t>(tet[0])], x[static_cast<std::size_t>(tet[1])],
                               x[static_cast<std::size_t>(tet[2])], x[static_cast<std::size_t>(tet[3])]);
                for (std::size_t child = 8 * t; child < 8 * t + 8; ++child) {
                    CHECK(fine_volume(fine, x, child) == doctest::Approx(whole / 8).epsilon(1e-12));
                }
                for (std::size_t corner = 0; corner < 4; ++corner) {
                    CHECK(fine.tets[8 * t + corner][corner] == tet[corner]);
                }
            }
        }
    }

    TEST_CASE("the inner octahedron is cut along its shortest diagonal") {
        // A tall thin tetrahedron: the middles of its two long opposite edges are far closer than the others.
        const TetMesh mesh{{Vec3(-4, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0.5), Vec3(0, -4, 0.5)}, {{0, 1, 2, 3}}, {0}};
        const FineMesh fine = subdivide(mesh);
        std::vector<Vec3> x;
        fine_positions(fine, mesh.nodes, x);
        for (std::size_t child = 4; child < 8; ++child) {
            const std::set<int> nodes(fine.tets[child].begin(), fine.tets[child].end());
            int on_axis = 0;
            for (int n : nodes) {
                on_axis += x[static_cast<std::size_t>(n)].head<2>().norm() < 1e-12 ? 1 : 0;
            }
            CHECK(on_axis == 2);
        }
    }

    TEST_CASE("neighbours of a refined mesh are mutual and its surface has 4 faces for each coarse one") {
        const TetMesh mesh = bar(3, 2, 2, 0.5);
        const FineMesh fine = subdivide(mesh);
        for (std::size_t t = 0; t < fine.tets.size(); ++t) {
            for (std::size_t k = 0; k < 4; ++k) {
                const int other = fine.neighbours[t][k];
                if (other >= 0) {
                    const std::array<int, 4>& back = fine.neighbours[static_cast<std::size_t>(other)];
                    CHECK(std::count(back.begin(), back.end(), static_cast<int>(t)) == 1);
                    const std::array<int, 4>& nodes = fine.tets[static_cast<std::size_t>(other)];
                    CHECK(std::count(nodes.begin(), nodes.end(), fine.tets[t][k]) == 0);
                }
            }
        }
        CHECK(open_faces(fine.neighbours) == 4 * open_faces(face_neighbours(mesh.tets)));
    }

    TEST_CASE("fine positions follow the coarse ones") {
        TetMesh mesh = single_tet();
        const FineMesh fine = subdivide(mesh);
        mesh.nodes[2] += Vec3(0.1, 0.2, 0.3);
        std::vector<Vec3> x;
        fine_positions(fine, mesh.nodes, x);
        REQUIRE(x.size() == 10);
        for (std::size_t e = 0; e < 6; ++e) {
            const Vec3 middle = 0.5 * (mesh.nodes[static_cast<std::size_t>(fine.edges[e][0])] +
                                       mesh.nodes[static_cast<std::size_t>(fine.edges[e][1])]);
            CHECK((x[4 + e] - middle).norm() == 0.0);
        }
    }

    TEST_CASE("the tetrahedra around a node are those that list it") {
        const TetMesh mesh = bar(2, 2, 2, 1.0);
        const NodeTets around = node_tets(mesh.tets, static_cast<int>(mesh.nodes.size()));
        CHECK(around.tets.size() == 4 * mesh.tets.size());
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            CHECK(around.offset[n] < around.offset[n + 1]);
            for (int i = around.offset[n]; i < around.offset[n + 1]; ++i) {
                const std::array<int, 4>& tet =
                    mesh.tets[static_cast<std::size_t>(around.tets[static_cast<std::size_t>(i)])];
                CHECK(std::count(tet.begin(), tet.end(), static_cast<int>(n)) == 1);
            }
        }
    }
}
