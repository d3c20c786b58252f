// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "eye/implant.hpp"
#include "eye/implant_outline.hpp"

using namespace rhexis;

namespace {

double smallest_degrees(const TriMesh& mesh) { return smallest_angle(mesh) * 180.0 / M_PI; }

double farthest(const TriMesh& mesh) {
    double most = 0.0;
    for (const Vec3& x : mesh.nodes) {
        most = std::max(most, x.norm());
    }
    return most;
}

}  // namespace

TEST_SUITE("implant") {
    TEST_CASE("the default lens has about 743 triangles, one part, and well-shaped ones") {
        const Implant implant = std::move(make_implant({})).value();
        const TriMesh& mesh = implant.model.mesh;
        CHECK(validate_tri_mesh(mesh).ok());
        CHECK(check_shell(implant.model).ok());
        CHECK(std::abs(static_cast<int>(mesh.triangles.size()) - 743) <= 10);
        CHECK(std::abs(static_cast<int>(mesh.nodes.size()) - 473) <= 15);
        CHECK(smallest_degrees(mesh) > 25.0);
        const std::vector<int> parts = sheet_parts(tri_neighbours(mesh));
        CHECK(*std::max_element(parts.begin(), parts.end()) == 0);
        CHECK(boundary_loops(mesh, tri_neighbours(mesh)).size() == 1);
        CHECK(farthest(mesh) == doctest::Approx(6.5).epsilon(1e-3));
        CHECK(shell_mass(implant.model) == doctest::Approx(0.0216).epsilon(0.02));
        // seen from the front, every triangle runs anticlockwise
        for (const std::array<int, 3>& t : mesh.triangles) {
            CHECK((mesh.nodes[at(t[1])] - mesh.nodes[at(t[0])]).cross(mesh.nodes[at(t[2])] - mesh.nodes[at(t[0])]).z() >
                  0.0);
        }
    }

    TEST_CASE("half a turn brings it onto itself, to rounding") {
        const Implant implant = std::move(make_implant({})).value();
        const std::vector<Vec3>& nodes = implant.model.mesh.nodes;
        for (const Vec3& x : nodes) {
            CHECK(std::any_of(nodes.begin(), nodes.end(), [&](const Vec3& y) { return (x + y).norm() < 1e-12; }));
        }
        CHECK((nodes[at(implant.tip[0])] + nodes[at(implant.tip[1])]).norm() < 1e-12);
        const std::ptrdiff_t upper = std::count(implant.part.begin(), implant.part.end(), ImplantPart::upper_haptic);
        CHECK(upper == std::count(implant.part.begin(), implant.part.end(), ImplantPart::lower_haptic));
        CHECK(upper > 100);
    }

    TEST_CASE("it lies the right way up: the upper haptic leaves on the right and ends on the left") {
        const Implant implant = std::move(make_implant({})).value();
        const std::vector<Vec3>& x = implant.model.mesh.nodes;
        for (const int node : implant.root[0]) {
            CHECK(x[at(node)].x() > 0.0);
            CHECK(x[at(node)].head<2>().norm() == doctest::Approx(3.0).epsilon(0.03));
        }
        CHECK(x[at(implant.tip[0])].y() > 4.0);
        CHECK(x[at(implant.tip[0])].x() < -2.0);
    }

    TEST_CASE("triangles are finest where the haptics meet the optic, and thick as their part is") {
        const Implant implant = std::move(make_implant({})).value();
        const TriMesh& mesh = implant.model.mesh;
        const Vec3 root = 0.5 * (mesh.nodes[at(implant.root[0].front())] + mesh.nodes[at(implant.root[0].back())]);
        double near = 0.0;
        double middle = 0.0;
        int near_count = 0;
        int middle_count = 0;
        for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
            const std::array<int, 3>& n = mesh.triangles[at(t)];
            const double area = triangle_area(mesh.nodes[at(n[0])], mesh.nodes[at(n[1])], mesh.nodes[at(n[2])]);
            const Vec3 place = triangle_middle(mesh, t);
            if ((place - root).norm() < 0.5) {
                near += area;
                ++near_count;
            }
            if (place.norm() < 1.5) {
                middle += area;
                ++middle_count;
                CHECK(implant.model.thickness[at(t)] > 0.55);
            }
            if (implant.part[at(t)] != ImplantPart::optic) {
                CHECK(implant.model.thickness[at(t)] == 0.4);
            }
        }
        CHECK(near / near_count < 0.5 * middle / middle_count);
        CHECK(optic_thickness({}, 0.0) == 0.7);
        CHECK(optic_thickness({}, 3.0) == doctest::Approx(0.25));
    }

    TEST_CASE("other sizes and finenesses are well shaped too") {
        for (const auto& sizes : {std::array{400.0, 13.0, 6.0, 0.5},
                                  {1500.0, 13.0, 6.0, 0.5},
                                  {8000.0, 13.0, 6.0, 0.5},
                                  {743.0, 14.0, 7.5, 0.8},
                                  {743.0, 10.0, 4.0, 0.2},
                                  {400.0, 10.5, 7.0, 0.2},
                                  {400.0, 10.0, 5.4, 0.8}}) {
            ImplantShape shape;
            shape.triangles = static_cast<int>(sizes[0]);
            shape.overall_diameter = sizes[1];
            shape.optic_diameter = sizes[2];
            shape.haptic_width = sizes[3];
            const Result<Implant> implant = make_implant(shape);
            REQUIRE(implant.ok());
            const TriMesh& mesh = implant.value().model.mesh;
            CAPTURE(shape.triangles);
            CAPTURE(shape.overall_diameter);
            CHECK(validate_tri_mesh(mesh).ok());
            CHECK(smallest_degrees(mesh) > 15.0);
            CHECK(std::abs(static_cast<double>(mesh.triangles.size()) / sizes[0] - 1.0) < 0.06);
            CHECK(farthest(mesh) == doctest::Approx(0.5 * sizes[1]).epsilon(2e-3));
        }
    }

    TEST_CASE("what is no lens is refused, with field and range") {
        const auto refused = [](const auto& change, const std::string& part) {
            ImplantShape shape;
            change(shape);
            const Result<Implant> implant = make_implant(shape);
            CHECK_FALSE(implant.ok());
            if (!implant.ok()) {
                CHECK(implant.error().text().find(part) != std::string::npos);
            }
        };
        refused([](ImplantShape& s) { s.haptic_thickness = -0.1; }, "haptic_thickness");
        refused([](ImplantShape& s) { s.centre_thickness = std::nan(""); }, "centre_thickness");
        refused([](ImplantShape& s) { s.edge_thickness = 0.8; }, "edge_thickness is 0.8 (0.05 to 0.7 mm)");
        refused([](ImplantShape& s) { s.optic_diameter = 9.0; }, "optic_diameter");
        refused([](ImplantShape& s) { s.overall_diameter = 9.5; }, "overall_diameter");
        refused(
            [](ImplantShape& s) {
                s.overall_diameter = 10.2;
                s.optic_diameter = 7.0;
            },
            "overall_diameter");
        refused([](ImplantShape& s) { s.haptic_width = 0.0; }, "haptic_width");
        refused([](ImplantShape& s) { s.triangles = 10; }, "triangles");
    }

    TEST_CASE("directions come without the C library's trigonometry, and are right to 1e-8") {
        for (double angle = -6.5; angle < 6.5; angle += 0.37) {
            CHECK((direction_at(angle) - Vec2(std::cos(angle), std::sin(angle))).norm() < 1e-8);
        }
    }
}
