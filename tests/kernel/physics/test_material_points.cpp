// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "mesh/material_points.hpp"
#include "mesh/places.hpp"
#include "physics/contact/contact_surface.hpp"
#include "physics/contact/near_points.hpp"
#include "physics/contact/tool_shape.hpp"
#include "physics/physics.hpp"
#include "physics/solid/sculpt.hpp"
#include "scenes/bodies.hpp"
#include "tools/phaco_tip.hpp"

using namespace rhexis;

namespace {

constexpr double ablation = 30.0;  ///< [mJ/mm^3]

/// A cube of lens, 2 mm, clamped below, whose top is at z = 1; a tip above it, its mouth facing down.
struct Bench {
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>();
    WorldState state;
    std::vector<ToolState> tools{ToolState{}};
    SculptZone zone;

    explicit Bench(int cells, double tip_z) {
        SolidModel cube = scenes::cube(cells, 2.0, 5000.0, 0.45);
        cube.materials[0].ablation_energy = ablation;
        cube.damping_mass = 20.0;
        cube.advance = Advance::explicit_;
        cube.by_points = true;
        for (std::size_t n = 0; n < cube.coarse.nodes.size(); ++n) {
            if (cube.coarse.nodes[n].z() < -0.999) {
                cube.fixed_nodes.push_back(static_cast<int>(n));
            }
        }
        model->solids.push_back(cube);
        model->gravity = Vec3::Zero();
        model->tools.push_back(phaco_tip());
        state = rest_state(*model);
        zone = sculpt_zone(model->tools[0]);
        tools[0].present = true;
        tools[0].power = 1.0;
        tools[0].pose.position = Vec3(0.0, 0.0, tip_z);
        tools[0].previous_pose = tools[0].pose;
    }
    [[nodiscard]] const SolidModel& solid() const { return model->solids[0]; }
    [[nodiscard]] Vec3 place(int fine, std::size_t point) const {
        const PointWeights weights = material_points(solid().coarse, solid().fine, fine);
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = 0; k < 4; ++k) {
            sum += weights[point][k] * state.solids[0].position[solid().coarse.tets[fine / 8][k]];
        }
        return sum;
    }
    [[nodiscard]] int fine_count() const { return static_cast<int>(solid().fine.tets.size()); }
};

}  // namespace

TEST_SUITE("material points") {
    TEST_CASE("they integrate what is of second order over a fine tetrahedron") {
        const Bench bench(2, 3.0);
        const TetMesh& coarse = bench.solid().coarse;
        for (const int fine : {0, 5, 13, bench.fine_count() - 1}) {
            const PointWeights weights = material_points(coarse, bench.solid().fine, fine);
            double mean = 0.0;
            for (std::size_t p = 0; p < 4; ++p) {
                CHECK(weights[p][0] + weights[p][1] + weights[p][2] + weights[p][3] == doctest::Approx(1.0));
                mean += 0.25 * bench.place(fine, p).squaredNorm();
            }
            // mean of |x|^2 over a tetrahedron: (sum |x_i|^2 + |sum x_i|^2) / 20
            double squares = 0.0;
            Vec3 sum = Vec3::Zero();
            for (const int node : bench.solid().fine.tets[fine]) {
                const Vec3 x = fine_point(bench.solid().fine, coarse.nodes, node);
                squares += x.squaredNorm();
                sum += x;
            }
            CHECK(mean == doctest::Approx((squares + sum.squaredNorm()) / 20.0).epsilon(1e-7));
        }
    }

    TEST_CASE("what is left of them is their tetrahedron's fraction until each has its own") {
        SolidState state;
        state.fraction = {1.0, 0.6, 1.0};
        CHECK(left_of_points(state, 1)[2] == 0.6);
        set_points(state, 2, {1.0, 0.5, 0.5, 0.0});
        CHECK(state.fraction[2] == 0.5);
        CHECK(left_of_points(state, 2)[0] == 1.0);
        set_fraction(state, 2, 0.25);
        CHECK(left_of_points(state, 2)[0] == 0.5);
        CHECK(left_of_points(state, 2)[3] == 0.0);
        set_points(state, 0, {0.0, 0.0, 0.0, 0.4});
        REQUIRE(state.spent.size() == 2);
        CHECK(state.spent[0].fine == 0);
        set_points(state, 0, {0.0, 0.0, 0.0, 0.0});
        set_fraction(state, 2, 0.0);
        CHECK(state.spent.empty());
        CHECK(state.fraction == std::vector<double>{0.0, 0.6, 0.0});
    }

    TEST_CASE("ultrasound takes from each what its place is given, whatever the mesh") {
        for (const int cells : {2, 4}) {
            Bench bench(cells, 1.0);
            const ToolModel& tip = bench.model->tools[0];
            constexpr double dt = 0.01;
            constexpr int steps = 6;
            for (int i = 0; i < steps; ++i) {
                sculpt(*bench.model, 0, bench.tools[0], bench.zone, dt, bench.state);
            }
            const double given = steps * dt * tip.max_power / (bench.zone.volume * ablation);
            double gone = 0.0;
            int partly = 0;
            for (int fine = 0; fine < bench.fine_count(); ++fine) {
                const std::array<double, 4> left = left_of_points(bench.state.solids[0], fine);
                for (std::size_t p = 0; p < 4; ++p) {
                    const Vec3 local = bench.tools[0].pose.to_body(bench.place(fine, p));
                    const double wanted = std::max(0.0, 1.0 - given * zone_weight(tip, bench.zone, local));
                    CHECK(std::abs(left[p] - wanted) < least_fraction + 1e-9);
                    partly += left[p] > 0.0 && left[p] < 1.0 ? 1 : 0;
                    gone += (1.0 - left[p]) * tet_mass(bench.solid(), fine / 8) / 32.0;
                }
            }
            CHECK(partly > 0);
            CHECK(bench.state.removed_mass == doctest::Approx(gone).epsilon(1e-9));
            CHECK(bench.state.ablation_energy * bench.solid().materials[0].density ==
                  doctest::Approx(ablation * gone).epsilon(1e-9));
        }
    }

    TEST_CASE("the energy that finds no tissue is told") {
        Bench away(2, 3.0);
        const double all = away.model->tools[0].max_power * 0.01;
        CHECK(sculpt(*away.model, 0, away.tools[0], away.zone, 0.01, away.state) == doctest::Approx(all));
        Bench near(4, 1.0);
        const double unused = sculpt(*near.model, 0, near.tools[0], near.zone, 0.01, near.state);
        CHECK(unused >= 0.0);
        CHECK(unused < 0.99 * all);
        // what was used is what is booked, but for points that are cut to nothing
        CHECK(near.state.ablation_energy == doctest::Approx(all - unused).epsilon(1e-6));
    }

    TEST_CASE("tools meet those that are near and left, and no others") {
        Bench bench(3, 0.9);
        SolidState& solid = bench.state.solids[0];
        for (int fine = 0; fine < bench.fine_count(); fine += 3) {
            set_points(solid, fine, {1.0, 0.31, 0.29, 0.0});
        }
        const double margin = 0.08;
        const std::vector<ToolReach> reaches{{&bench.model->tools[0], bench.tools[0].pose, margin}};
        std::vector<NearPoint> found;
        find_near_points(bench.solid(), ContactSurface(bench.solid()).point_spacings(), solid, reaches, 0.01, found);
        std::set<int> ids;
        for (const NearPoint& near : found) {
            ids.insert(near.at.id);
        }
        REQUIRE(ids.size() == found.size());
        const int first = static_cast<int>(bench.solid().coarse.nodes.size() + bench.solid().fine.edges.size());
        std::size_t wanted = 0;
        for (int fine = 0; fine < bench.fine_count(); ++fine) {
            const double spacing =
                std::cbrt(tet_mass(bench.solid(), fine / 8) / (32.0 * bench.solid().materials[0].density));
            for (std::size_t p = 0; p < 4; ++p) {
                const Vec3 local = bench.tools[0].pose.to_body(bench.place(fine, p));
                const double gap = tool_distance(bench.model->tools[0], local, 0.0).distance - 0.5 * spacing;
                const bool near = gap < margin && left_of_points(solid, fine)[p] > still_there;
                wanted += near ? 1 : 0;
                CHECK((ids.count(first + 4 * fine + static_cast<int>(p)) == 1) == near);
            }
        }
        CHECK(wanted > 0);
        CHECK(wanted == found.size());
    }

    TEST_CASE("a tip pushes what is there, and goes through what is spent") {
        const auto force_of = [](bool spent) {
            Bench bench(3, 1.3);
            bench.tools[0].power = 0.0;
            if (spent) {
                for (int fine = 0; fine < bench.fine_count(); ++fine) {
                    const Vec3 middle = fine_middle(bench.solid().fine, bench.solid().coarse.nodes, fine);
                    if (middle.head<2>().norm() < 0.9 && middle.z() > -0.5) {
                        set_points(bench.state.solids[0], fine, {0.2, 0.2, 0.2, 0.2});
                    }
                }
            }
            Result<Physics> made = Physics::create(bench.model, {});
            REQUIRE(made.ok());
            Physics physics = std::move(made).value();
            Profile profile;
            ContactSet contacts;
            for (int i = 0; i < 50; ++i) {
                bench.tools[0].previous_pose = bench.tools[0].pose;
                bench.tools[0].pose.position.z() -= 0.01;
                WorldState next;
                contacts.clear();
                const StepOutcome outcome = physics.advance(bench.state, bench.tools, 0.01, next, contacts, profile);
                REQUIRE(outcome.failure == StepFailure::none);
                bench.state = next;
            }
            double force = 0.0;
            for (const Contact& contact : contacts) {
                CHECK(contact.solid == 0);
                CHECK(contact.nodes[2] >= 0);
                force += contact.partner == ContactPartner::tool ? contact.force.z() : 0.0;
            }
            return force;
        };
        CHECK(force_of(false) < -100.0);  // down, 0.2 mm deep
        CHECK(force_of(true) == 0.0);
    }
}
