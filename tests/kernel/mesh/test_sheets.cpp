// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "mesh/io.hpp"
#include "mesh/shapes.hpp"

using namespace rhexis;

namespace {

constexpr double degree = M_PI / 180.0;

void check_refused(const TriMesh& mesh, const std::string& part) {
    const Status status = validate_tri_mesh(mesh, "sheet");
    CHECK_FALSE(status.ok());
    if (!status.ok()) {
        CHECK_MESSAGE(status.error().text().find(part) != std::string::npos, status.error().text());
    }
}

}  // namespace

TEST_SUITE("sheets") {
    TEST_CASE("square and round sheets: valid, of the size asked for, no slivers") {
        for (const int count : {100, 1500, 6000}) {
            const TriMesh square = square_sheet(10.0, count);
            CHECK(validate_tri_mesh(square).ok());
            CHECK(mesh_area(square) == doctest::Approx(100.0));
            CHECK(static_cast<double>(square.triangles.size()) == doctest::Approx(count).epsilon(0.2));
            CHECK(smallest_angle(square) > 28.0 * degree);
            const TriMesh round = round_sheet(4.6, count);
            CHECK(validate_tri_mesh(round).ok());
            CHECK(mesh_area(round) == doctest::Approx(M_PI * 4.6 * 4.6).epsilon(0.12));
            CHECK(static_cast<double>(round.triangles.size()) == doctest::Approx(count).epsilon(0.12));
            CHECK(smallest_angle(round) > 40.0 * degree);
            CHECK(validate_tri_mesh(jittered(square, 0.25, 3)).ok());
        }
        for (const std::array<int, 3>& t : round_sheet(1.0, 600).triangles) {
            const TriMesh round = round_sheet(1.0, 600);
            const Vec3 a = round.nodes[static_cast<std::size_t>(t[1])] - round.nodes[static_cast<std::size_t>(t[0])];
            const Vec3 b = round.nodes[static_cast<std::size_t>(t[2])] - round.nodes[static_cast<std::size_t>(t[0])];
            CHECK(a.cross(b).z() > 0.0);
        }
    }

    TEST_CASE("neighbours, boundary and parts") {
        const TriMesh mesh = round_sheet(2.0, 600);
        const TriNeighbours neighbours = tri_neighbours(mesh);
        for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
            for (const int other : neighbours.across[static_cast<std::size_t>(t)]) {
                if (other >= 0) {
                    const std::array<int, 3>& back = neighbours.across[static_cast<std::size_t>(other)];
                    CHECK((back[0] == t || back[1] == t || back[2] == t));
                }
            }
        }
        const std::vector<std::vector<int>> loops = boundary_loops(mesh, neighbours);
        CHECK(loops.size() == 1);
        CHECK(loops[0].size() == 60);
        const std::vector<int> parts = sheet_parts(neighbours);
        CHECK(*std::max_element(parts.begin(), parts.end()) == 0);
    }

    TEST_CASE("unfit sheets are refused with the number of what is wrong") {
        TriMesh mesh = square_sheet(1.0, 8);
        check_refused(TriMesh{}, "no triangle");
        TriMesh bad = mesh;
        std::swap(bad.triangles[3][0], bad.triangles[3][1]);
        check_refused(bad, "flipped");
        bad = mesh;
        bad.nodes.emplace_back(0.5, 0.5, 1.0);
        check_refused(bad, "belongs to no triangle");
        bad.triangles.push_back({bad.triangles[2][0], bad.triangles[2][1], static_cast<int>(bad.nodes.size()) - 1});
        check_refused(bad, "edge");
        bad = mesh;
        bad.triangles[1][2] = 77;
        check_refused(bad, "node 77");
        bad = mesh;
        bad.triangles[1][2] = bad.triangles[1][1];
        check_refused(bad, "twice");
        bad = mesh;
        bad.nodes[2].x() = std::nan("");
        check_refused(bad, "not finite");
        bad = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 1e-9, 0)}, {{0, 1, 2}}};
        check_refused(bad, "flat");
        bad = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)}, {{0, 1, 2}, {0, 3, 4}}};
        check_refused(bad, "only touch");
    }
}
