// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "base/index.hpp"
#include "mesh/shapes.hpp"
#include "scenes/membrane_trials.hpp"
#include "scenes/membranes.hpp"

using namespace rhexis;
using namespace rhexis::scenes;

namespace {

const Orthotropic fibrous{1.0e6, 2.5e5, 0.45, 0.0};

}  // namespace

TEST_SUITE("membrane") {
    TEST_CASE("a coupon pulled off its fibres' axis has the modulus of the closed form") {
        // roller grips: both ends may contract and shear, so the stress is the same everywhere
        for (int degrees = 0; degrees <= 90; degrees += 15) {
            const double angle = degrees * M_PI / 180.0;
            MembraneModel model =
                membrane("coupon", square_sheet(2.0, 300), fibrous, Vec3(std::cos(angle), std::sin(angle), 0.0));
            model.damping_mass = 50.0;
            const TriMesh& mesh = model.sheet->mesh;
            const double stress = 100.0;  // small strain: the formula is linear
            std::vector<Vec3> load(mesh.nodes.size(), Vec3::Zero());
            for (const double side : {0.0, 2.0}) {
                for (const int node : nodes_at(mesh, 0, side)) {
                    double width = 0.0;  // of the edge that hangs on the node
                    for (const std::array<int, 3>& t : mesh.triangles) {
                        for (std::size_t k = 0; k < 3; ++k) {
                            const Vec3& a = mesh.nodes[at(t[k])];
                            const Vec3& b = mesh.nodes[at(t[(k + 1) % 3])];
                            const bool own = t[k] == node || t[(k + 1) % 3] == node;
                            if (own && a.x() == side && b.x() == side) {
                                width += 0.5 * std::abs(a.y() - b.y());
                            }
                        }
                    }
                    load[at(node)].x() = (side > 1.0 ? 1.0 : -1.0) * stress * 0.01 * width;
                }
            }
            HeldSheet sheet(std::move(model));
            CHECK(sheet.settle(load, 1e-7, 2000, 0.02));
            const std::vector<int> left = nodes_at(sheet.model().sheet->mesh, 0, 0.0);
            const std::vector<int> right = nodes_at(sheet.model().sheet->mesh, 0, 2.0);
            double stretch = 0.0;
            for (const int node : left) {
                stretch -= sheet.state().position[at(node)].x() / static_cast<double>(left.size());
            }
            for (const int node : right) {
                stretch += sheet.state().position[at(node)].x() / static_cast<double>(right.size());
            }
            CHECK(stress / (stretch / 2.0 - 1.0) == doctest::Approx(off_axis_modulus(fibrous, angle)).epsilon(5e-3));
        }
    }

    TEST_CASE("a taut sheet is quiet at every step (T5)") {
        for (const double dt : {1e-4, 1e-3, 1e-2}) {
            CHECK(shake_taut(dt, 200).swing <= 1.001);
        }
    }

    TEST_CASE("a slack and crumpled sheet: the system stays definite, energy falls (T6)") {
        const Slackness found = crumple(100);
        CHECK(found.residual <= 1e-6);  // conjugate gradients met no negative curvature
        CHECK(found.least >= -1e-9);
        CHECK(found.rise <= 1e-9);
        CHECK(found.left < 0.02);
    }

    TEST_CASE("renumbered and turned sheets have the same energy (T8)") {
        const Renumbering found = renumber();
        CHECK(found.renumbered < 1e-12);
        CHECK(found.turned < 1e-12);
    }

    TEST_CASE("models that cannot be are refused") {
        const auto refused = [](MembraneModel model, const std::string& part) {
            const Result<MembraneStepper> made = MembraneStepper::create(model);
            CHECK_FALSE(made.ok());
            if (!made.ok()) {
                CHECK_MESSAGE(made.error().text().find(part) != std::string::npos, made.error().text());
            }
        };
        MembraneModel model = membrane("sheet", square_sheet(2.0, 50), fibrous);
        CHECK(MembraneStepper::create(model).ok());
        MembraneModel bad = model;
        bad.material.poisson_ratio = 3.0;
        refused(bad, "poisson_ratio");
        refused(membrane("sheet", square_sheet(2.0, 50), fibrous, Vec3::Zero()), "fibre of triangle 0");
        refused(membrane("sheet", square_sheet(2.0, 50), fibrous, Vec3::UnitZ()), "fibre of triangle 0");
        bad = model;
        bad.fixed_nodes = {-1};
        refused(bad, "node -1");
        bad.fixed_nodes = {3, 1};
        refused(bad, "out of order");
        bad = model;
        bad.toughness.along = std::nan("");
        refused(bad, "toughness along");
        bad = model;
        MembraneSheet thin = *model.sheet;
        thin.thickness[3] = 0.0;
        bad.sheet = std::make_shared<const MembraneSheet>(thin);
        refused(bad, "thickness of triangle 3");
        MembraneSheet flipped = *model.sheet;
        std::swap(flipped.mesh.triangles[7][0], flipped.mesh.triangles[7][1]);
        bad.sheet = std::make_shared<const MembraneSheet>(flipped);
        refused(bad, "flipped");
        MembraneSheet crossed = *model.sheet;
        const std::array<int, 3> shared = crossed.mesh.triangles[7];
        crossed.mesh.nodes.emplace_back(1.0, 1.0, 0.5);
        crossed.mesh.triangles.push_back({shared[0], shared[1], static_cast<int>(crossed.mesh.nodes.size()) - 1});
        crossed.mesh.triangles.push_back({shared[1], shared[0], static_cast<int>(crossed.mesh.nodes.size()) - 1});
        bad.sheet = std::make_shared<const MembraneSheet>(crossed);
        refused(bad, "is shared by triangles");
        MembraneSheet bare = *model.sheet;
        bare.fibre[5] = Vec3::Zero();
        bad.sheet = std::make_shared<const MembraneSheet>(bare);
        refused(bad, "fibre of triangle 5");
        bad.sheet = nullptr;
        refused(bad, "no sheet");
    }
}
