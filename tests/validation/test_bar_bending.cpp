// SPDX-License-Identifier: GPL-3.0-or-later
// A bar of 4 x 1 x 1 mm, E 3000 Pa, clamped at one end, bent by its own weight of 1 uN/mm^3. Reference: quadratic
// tetrahedra (CalculiX C3D10, 7,251 unknowns). Linear tetrahedra are too stiff, by a known amount that depends on how
// many of them share the thickness; the amount is what is checked.
#include <doctest/doctest.h>

#include <Eigen/SparseCholesky>
#include <cmath>

#include "base/index.hpp"
#include "energy/corotational_tet.hpp"
#include "physics/solid/explicit_solid.hpp"
#include "physics/solid/solid_share.hpp"
#include "scenes/bodies.hpp"
#include "scenes/measures.hpp"

using namespace rhexis;

namespace {

SolidModel bar_of(int thick, double nu) {
    SolidModel model = scenes::clamped_bar(4 * thick, thick, thick, 1.0 / thick, 3000.0, nu);
    model.fine = FineMesh{};
    return model;
}

/// Static equilibrium by one solve with the consistent tangent at rest.
double linear_tip(const SolidModel& model) {
    const SolidState rest = rest_state(model);
    const std::vector<TetStiffness> stiffness = tet_stiffness(model, rest);
    const NodeMass mass = node_mass(model, rest, stiffness);
    std::vector<int> row(rest.position.size(), 0);
    for (const int node : model.fixed_nodes) {
        row[at(node)] = -1;
    }
    int free_nodes = 0;
    for (int& r : row) {
        r = r < 0 ? -1 : free_nodes++;
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t t = 0; t < stiffness.size(); ++t) {
        const std::array<int, 4>& tet = model.coarse.tets[t];
        const TetPoints x{rest.position[at(tet[0])], rest.position[at(tet[1])], rest.position[at(tet[2])],
                          rest.position[at(tet[3])]};
        const Mat12 k =
            corotational_tet_hessian(rest_tet(x), {stiffness[t].lambda, stiffness[t].mu}, x, Tangent::consistent);
        for (int i = 0; i < 12; ++i) {
            for (int j = 0; j < 12; ++j) {
                const int a = row[at(tet[at(i / 3)])];
                const int b = row[at(tet[at(j / 3)])];
                if (a >= 0 && b >= 0) {
                    entries.emplace_back(3 * a + i % 3, 3 * b + j % 3, k(i, j));
                }
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(3 * free_nodes, 3 * free_nodes);
    matrix.setFromTriplets(entries.begin(), entries.end());
    VecX load = VecX::Zero(3 * free_nodes);
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] >= 0) {
            load[3 * row[i] + 2] = -mass.inertia[i] / model.materials[0].density;
        }
    }
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    REQUIRE(solver.info() == Eigen::Success);
    const VecX u = solver.solve(load);
    std::vector<Vec3> position = rest.position;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] >= 0) {
            position[i] += u.segment<3>(3 * row[i]);
        }
    }
    return scenes::tip_sag(model, position);
}

/// The same by letting the explicit solid ring out.
double relaxed_tip(SolidModel model) {
    model.damping_mass = 200.0;  // [1/s], about twice the first bending frequency
    ExplicitSolid solid = ExplicitSolid::create(model, "").value();
    const double dt = 0.8 * solid.stable_step();
    const Vec3 gravity(0.0, 0.0, -1.0 / model.materials[0].density);
    for (double time = 0.0; time < 0.3; time += dt) {
        solid.predict(dt, gravity, {});
        solid.move(dt);
    }
    SolidState state = rest_state(model);
    solid.store(state);
    return scenes::tip_sag(model, state.position);
}

struct Row {
    double nu;
    double reference;  ///< [mm]
    std::array<double, 5> ratio;
};
constexpr std::array<int, 5> thick{2, 3, 4, 6, 8};
constexpr std::array<Row, 3> table{{{0.3, 0.13284, {0.668, 0.817, 0.886, 0.946, 0.970}},
                                    {0.45, 0.12847, {0.602, 0.762, 0.846, 0.923, 0.957}},
                                    {0.49, 0.12595, {0.5127, 0.687, 0.786, 0.884, 0.931}}}};

}  // namespace

TEST_SUITE("validation") {
    TEST_CASE("linear tetrahedra bend a bar by the known share of what quadratic ones do") {
        for (const Row& row : table) {
            for (std::size_t k = 0; k < thick.size(); ++k) {
                CAPTURE(row.nu);
                CAPTURE(thick[k]);
                const double ratio = linear_tip(bar_of(thick[k], row.nu)) / row.reference;
                CHECK(std::abs(ratio / row.ratio[k] - 1.0) < 0.01);
            }
        }
    }

    TEST_CASE("linear tetrahedra give what an independent code gives on the same mesh, to five digits") {
        // CalculiX 2.20, C3D4, *DLOAD GRAV, mean of U3 over the end face [mm]
        CHECK(linear_tip(bar_of(2, 0.3)) == doctest::Approx(0.0894573).epsilon(1e-5));
        CHECK(linear_tip(bar_of(2, 0.45)) == doctest::Approx(0.0772982).epsilon(1e-5));
        CHECK(linear_tip(bar_of(2, 0.49)) == doctest::Approx(0.0645804).epsilon(1e-5));
        CHECK(linear_tip(bar_of(3, 0.49)) == doctest::Approx(0.0865).epsilon(1e-5));
    }

    TEST_CASE("the explicit solid comes to rest where the static solution is") {
        for (const double nu : {0.3, 0.49}) {
            const SolidModel model = bar_of(4, nu);
            CHECK(relaxed_tip(model) == doctest::Approx(linear_tip(model)).epsilon(0.01));
        }
    }
}
