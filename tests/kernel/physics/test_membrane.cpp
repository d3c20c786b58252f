// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "base/rng.hpp"
#include "mesh/shapes.hpp"
#include "scenes/membranes.hpp"

using namespace rhexis;
using namespace rhexis::scenes;

namespace {

const Orthotropic fibrous{1.0e6, 2.5e5, 0.45, 0.0};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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
            MembraneModel model = membrane("taut", square_sheet(4.0, 400), isotropic(1e6, 0.45));
            const TriMesh& mesh = model.sheet->mesh;
            for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
                const Vec3& x = mesh.nodes[at(n)];
                if (x.x() == 0.0 || x.x() == 4.0 || x.y() == 0.0 || x.y() == 4.0) {
                    model.fixed_nodes.push_back(n);
                }
            }
            HeldSheet sheet(std::move(model));
            Rng rng(3, "taut");
            double start = 0.0;
            for (std::size_t n = 0; n < sheet.state().position.size(); ++n) {
                sheet.state().position[n] *= 1.1;  // 10 % prestrain
            }
            for (std::size_t n = 0; n < sheet.state().position.size(); ++n) {
                if (!std::binary_search(sheet.model().fixed_nodes.begin(), sheet.model().fixed_nodes.end(),
                                        static_cast<int>(n))) {
                    sheet.state().position[n].z() += 0.01 * (2.0 * rng.uniform() - 1.0);
                    start = std::max(start, std::abs(sheet.state().position[n].z()));
                }
            }
            double most = 0.0;
            for (int i = 0; i < 200; ++i) {
                const ImplicitReport report = sheet.step(dt);
                CHECK(std::isfinite(report.newton_residual));
                for (const Vec3& x : sheet.state().position) {
                    most = std::max(most, std::abs(x.z()));
                }
            }
            CHECK(most <= start * 1.001);
        }
    }

    TEST_CASE("a slack and crumpled sheet: the system stays definite, energy falls (T6)") {
        MembraneModel model = membrane("slack", square_sheet(4.0, 400), fibrous, Vec3(1.0, 0.7, 0.0));
        model.fixed_nodes = nodes_at(model.sheet->mesh, 0, 0.0);
        HeldSheet sheet(std::move(model));
        Rng rng(4, "slack");
        for (Vec3& x : sheet.state().position) {
            x = Vec3(0.4 * x.x(), x.y(), 0.05 * (2.0 * rng.uniform() - 1.0));
        }
        const double start = sheet.energy();
        for (int i = 0; i < 100; ++i) {
            const ImplicitReport report = sheet.step(0.01, {}, {.max_newton = 6});
            CHECK(report.residual <= 1e-6);  // of the last linear solve: conjugate gradients met no negative curvature
            CHECK(sheet.energy() < start);
        }
        CHECK(sheet.energy() < 0.02 * start);
        for (const Vec3& x : sheet.state().position) {
            CHECK(x.allFinite());
        }
    }

    TEST_CASE("renumbered and turned sheets have the same energy") {
        const TriMesh mesh = jittered(square_sheet(2.0, 200), 0.2, 1);
        HeldSheet sheet(membrane("sheet", mesh, fibrous, Vec3(1.0, 0.4, 0.0)));
        Rng rng(5, "moved");
        for (Vec3& x : sheet.state().position) {
            x += 0.05 * Vec3(rng.uniform(), rng.uniform(), rng.uniform());
        }
        const double energy = sheet.energy();
        TriMesh other = mesh;
        for (std::array<int, 3>& t : other.triangles) {
            std::rotate(t.begin(), t.begin() + 1, t.end());
        }
        std::reverse(other.triangles.begin(), other.triangles.end());
        HeldSheet again(membrane("again", other, fibrous, Vec3(1.0, 0.4, 0.0)));
        again.state().position = sheet.state().position;
        CHECK(again.energy() == doctest::Approx(energy).epsilon(1e-12));
        const Mat3 turn = Eigen::AngleAxisd(2.1, Vec3(1.0, 0.5, -0.3).normalized()).toRotationMatrix();
        TriMesh turned = mesh;
        for (Vec3& x : turned.nodes) {
            x = turn * x;
        }
        HeldSheet third(membrane("third", turned, fibrous, turn * Vec3(1.0, 0.4, 0.0)));
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            third.state().position[n] = turn * sheet.state().position[n];
        }
        CHECK(third.energy() == doctest::Approx(energy).epsilon(1e-12));
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
        bad.sheet = nullptr;
        refused(bad, "no sheet");
    }
}
