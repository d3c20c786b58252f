// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "base/rng.hpp"
#include "mesh/shapes.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "scenes/membranes.hpp"
#include "topology/tear.hpp"

using namespace rhexis;
using namespace rhexis::scenes;

namespace {

constexpr double degree = M_PI / 180.0;
const Orthotropic fibrous{1.0e6, 2.5e5, 0.45, 0.0};

void check_sound(const MembraneState& state) {
    const Status status = validate_tri_mesh(state.sheet->mesh);
    CHECK_MESSAGE(status.ok(), (status.ok() ? std::string() : status.error().text()));
    CHECK(state.position.size() == state.sheet->mesh.nodes.size());
    CHECK(state.velocity.size() == state.sheet->mesh.nodes.size());
    CHECK(state.sheet->fibre.size() == state.sheet->mesh.triangles.size());
}

Vec3 at_angle(double degrees) { return {std::cos(degrees * degree), std::sin(degrees * degree), 0.0}; }

}  // namespace

TEST_SUITE("tear") {
    TEST_CASE("a puncture and a tear across the sheet part it; area, mass and energy stay") {
        const MembraneModel model = membrane("sheet", square_sheet(4.0, 600), fibrous, Vec3(1.0, 0.5, 0.0));
        MembraneState state = rest_state(model);
        for (Vec3& x : state.position) {
            x = Vec3(1.1 * x.x(), 0.95 * x.y() + 0.05 * x.x(), 0.1 * x.x() * x.y());
        }
        HeldSheet before(model);
        before.state() = state;
        const double energy = before.energy();
        Result<MembraneEdit> edit =
            puncture(model, state, nearest_triangle(model.sheet->mesh, Vec3(2, 2, 0)), Vec3(2, 2, 0), at_angle(33.0));
        REQUIRE(edit.ok());
        state = applied(state, edit.value());
        check_sound(state);
        CHECK(state.tips.size() == 2);
        CHECK(boundary_loops(state.sheet->mesh, state.sheet->neighbours).size() == 2);
        int steps = 0;
        for (; !state.tips.empty() && steps < 100; ++steps) {
            edit = tear(model, state, 0,
                        state.tips[0].direction.dot(at_angle(33.0)) > 0.0 ? at_angle(33.0) : -at_angle(33.0));
            REQUIRE(edit.ok());
            state = applied(state, edit.value());
            check_sound(state);
        }
        CHECK(state.tips.empty());
        const std::vector<int> parts = sheet_parts(state.sheet->neighbours);
        CHECK(*std::max_element(parts.begin(), parts.end()) == 1);
        CHECK(mesh_area(state.sheet->mesh) == doctest::Approx(16.0).epsilon(1e-12));
        CHECK(smallest_angle(state.sheet->mesh) >= 15.0 * degree - 1e-9);
        CHECK(state.torn_area == doctest::Approx(0.01 * 4.0 / std::cos(33.0 * degree)).epsilon(0.05));
        CHECK(state.torn_energy == doctest::Approx(1e6 * state.torn_area));
        HeldSheet after(model);
        after.state() = state;
        CHECK(after.energy() == doctest::Approx(energy).epsilon(1e-12));
    }

    TEST_CASE("the path keeps the direction within an element, whatever the mesh") {
        for (const double angle : {0.0, 17.0, 41.0, 78.0}) {
            for (const bool shaken : {false, true}) {
                const TriMesh mesh = shaken ? jittered(square_sheet(4.0, 1500), 0.2, 7) : square_sheet(4.0, 1500);
                const MembraneModel model = membrane("sheet", mesh, fibrous);
                MembraneState state = rest_state(model);
                const Result<MembraneEdit> start =
                    puncture(model, state, nearest_triangle(mesh, Vec3(2, 2, 0)), Vec3(2, 2, 0), at_angle(angle));
                REQUIRE(start.ok());
                state = applied(state, start.value());
                const Vec3 origin = state.sheet->mesh.nodes[at(start.value().nodes.back().a)];
                double off = 0.0;
                while (!state.tips.empty()) {
                    const Vec3 way =
                        state.tips[0].direction.dot(at_angle(angle)) > 0.0 ? at_angle(angle) : -at_angle(angle);
                    const Vec3 here = state.sheet->mesh.nodes[at(state.tips[0].node)] - origin;
                    const Vec3 aside = here - here.dot(way) * way;
                    const Result<MembraneEdit> edit = tear(model, state, 0, way);
                    REQUIRE(edit.ok());
                    off = std::max(off, aside.norm());
                    state = applied(state, edit.value());
                }
                CHECK(off < mean_edge(mesh));
            }
        }
    }

    TEST_CASE("along existing edges nothing is split") {
        const MembraneModel model = membrane("sheet", square_sheet(4.0, 600), fibrous);
        MembraneState state = rest_state(model);
        const TearRules rules{.existing_edges = true};
        Result<MembraneEdit> edit = puncture(model, state, nearest_triangle(model.sheet->mesh, Vec3(2, 2, 0)),
                                             Vec3(2, 2, 0), at_angle(20.0), rules);
        while (edit.ok() && !edit.value().tips.empty()) {
            state = applied(state, edit.value());
            check_sound(state);
            edit = tear(model, state, 0, state.tips[0].direction.x() > 0.0 ? at_angle(20.0) : Vec3(-at_angle(20.0)),
                        rules);
        }
        REQUIRE(edit.ok());
        state = applied(state, edit.value());
        CHECK(state.sheet->mesh.triangles.size() == model.sheet->mesh.triangles.size());
        CHECK(smallest_angle(state.sheet->mesh) == doctest::Approx(smallest_angle(model.sheet->mesh)));
    }

    TEST_CASE("random tears: no sliver, no fault, memory bounded by what was torn (T18)") {
        const MembraneModel model = membrane("sheet", jittered(round_sheet(4.0, 1500), 0.15, 5), fibrous);
        Rng rng(9, "tears");
        long splits = 0;
        for (int sheet = 0; sheet < 6; ++sheet) {
            MembraneState state = rest_state(model);
            for (int i = 0; i < 400; ++i) {
                const Vec3 way = at_angle(360.0 * rng.uniform());
                Result<MembraneEdit> edit = Error{};
                if (state.tips.empty() || rng.uniform() < 0.05) {
                    const int triangle = static_cast<int>(rng.uniform() * 0.999 *
                                                          static_cast<double>(state.sheet->mesh.triangles.size()));
                    edit = puncture(model, state, triangle,
                                    state.sheet->mesh.nodes[at(state.sheet->mesh.triangles[at(triangle)][0])], way);
                } else {
                    const int tip = static_cast<int>(rng.uniform() * 0.999 * static_cast<double>(state.tips.size()));
                    edit = tear(model, state, tip, state.tips[at(tip)].direction + 0.8 * way);
                }
                if (edit.ok()) {
                    state = applied(state, edit.value());
                    ++splits;
                }
            }
            check_sound(state);
            CHECK(smallest_angle(state.sheet->mesh) >=
                  std::min(15.0 * degree, smallest_angle(model.sheet->mesh)) - 1e-9);
            CHECK(mesh_area(state.sheet->mesh) == doctest::Approx(mesh_area(model.sheet->mesh)).epsilon(1e-10));
            CHECK(state.sheet->mesh.nodes.size() < model.sheet->mesh.nodes.size() + 4 * 400);
        }
        CHECK(splits > 1000);
    }

    TEST_CASE("copies of a node are held, hung and loaded as it was") {
        MembraneModel model = membrane("sheet", square_sheet(2.0, 100), fibrous);
        const std::vector<int> low = nodes_at(model.sheet->mesh, 1, 0.0);
        const int held_node = low[low.size() / 2];
        const int hung = nodes_at(model.sheet->mesh, 1, 2.0)[2];
        model.fixed_nodes = low;
        model.springs = {{hung, model.sheet->mesh.nodes[at(hung)] + Vec3(0.0, 0.5, 0.0), 40.0, 0.1}};
        MembraneState state = rest_state(model);
        state.loads = {{{held_node, hung}, Vec3(0.0, 0.0, 3.0)}};
        const auto forces = [&](const MembraneState& of) {
            MembraneBody body(model, of.sheet);
            std::vector<double> position;
            for (const int node : body.node_of()) {
                position.insert(position.end(), of.position[at(node)].begin(), of.position[at(node)].end());
            }
            position.push_back(0.0);
            std::vector<double> force;
            body.forces(position, force);
            Vec3 sum = Vec3::Zero();
            for (std::size_t row = 0; row < body.node_of().size(); ++row) {
                sum += Eigen::Map<const Vec3>(force.data() + 3 * row);
            }
            return sum;
        };
        CHECK(forces(state).y() == doctest::Approx(40.0 * 0.4));
        for (const int node : {held_node, hung}) {
            const Vec3 way(0.0, node == hung ? -1.0 : 1.0, 0.0);
            const Result<MembraneEdit> edit = notch(model, state, node, way);
            REQUIRE(edit.ok());
            state = applied(state, edit.value());
            const int copy = static_cast<int>(state.sheet->mesh.nodes.size()) - 1;
            CHECK(state.sheet->origin[at(copy)] == node);
            CHECK(is_fixed(model, *state.sheet, copy) == (node == held_node));
        }
        CHECK(forces(state).y() == doctest::Approx(40.0 * 0.4));
        CHECK(state.loads[0].nodes.size() == 4);
    }

    TEST_CASE("what cannot be torn is refused") {
        const MembraneModel model = membrane("sheet", square_sheet(2.0, 100), fibrous);
        const MembraneState state = rest_state(model);
        const auto refused = [](const Result<MembraneEdit>& edit, const std::string& part) {
            CHECK_FALSE(edit.ok());
            if (!edit.ok()) {
                CHECK_MESSAGE(edit.error().text().find(part) != std::string::npos, edit.error().text());
            }
        };
        refused(tear(model, state, 0, Vec3::UnitX()), "no tip 0");
        refused(puncture(model, state, 9999, Vec3(1, 1, 0), Vec3::UnitX()), "no triangle 9999");
        refused(puncture(model, state, -1, Vec3(1, 1, 0), Vec3::UnitX()), "no triangle -1");
        const int middle = nearest_triangle(model.sheet->mesh, Vec3(1, 1, 0));
        refused(puncture(model, state, middle, Vec3(1, 1, 0), Vec3::Zero()), "no direction");
        refused(puncture(model, state, middle, Vec3(1, 1, 0), Vec3(std::nan(""), 0, 0)), "no direction");
        refused(puncture(model, state, middle, Vec3(1, std::nan(""), 0), Vec3::UnitX()), "not finite");
        refused(puncture(model, state, middle, Vec3(1, 1, 0), Vec3::UnitZ()), "out of the sheet");
        refused(
            puncture(model, state, nearest_triangle(model.sheet->mesh, Vec3(5, 1, 0)), Vec3(5, 1, 0), Vec3::UnitX()),
            "the place is outside the sheet: 3.");
        refused(puncture(model, state, 0, model.sheet->mesh.nodes[0], Vec3::UnitX()), "on an edge");
        refused(notch(model, state, -3, Vec3::UnitX()), "no node -3");
        const int corner = nodes_at(model.sheet->mesh, 0, 0.0)[1];
        refused(notch(model, state, corner, -Vec3::UnitX()), "out of the sheet");
        CHECK(notch(model, state, corner, Vec3::UnitX()).ok());
    }
}
