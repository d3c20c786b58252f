// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "eye/anatomy.hpp"
#include "eye/capsular_bag.hpp"
#include "eye/posterior_capsule.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "scenes/capsule_scene.hpp"

using namespace rhexis;

TEST_SUITE("anterior capsule") {
    TEST_CASE("thin at the pole, thickest in the mid-periphery, thin at the equator, thicker with age") {
        CHECK(anterior_thickness(68.0, 0.0, 4.8) == doctest::Approx(0.0138).epsilon(0.01));
        CHECK(anterior_thickness(68.0, 2.64, 4.8) == doctest::Approx(0.0152).epsilon(0.01));
        CHECK(anterior_thickness(68.0, 4.8, 4.8) == doctest::Approx(0.007));
        CHECK(anterior_thickness(20.0, 0.0, 4.8) < anterior_thickness(90.0, 0.0, 4.8));
    }

    TEST_CASE("of patients of every age: on the lens, sound, hung as stiffly as the bag") {
        for (const double age : {20.0, 45.0, 68.0, 95.0}) {
            for (const bool circles : {false, true}) {
                Patient patient;
                patient.age = age;
                const HalfEllipsoids lens = lens_shape(patient);
                const BagModel bag = make_bag(lens, 0.2, age);
                const MembraneModel capsule = make_anterior_capsule(lens, bag, age, {.circles = circles});
                CHECK(check_membrane(capsule).ok());
                CHECK(std::abs(static_cast<int>(capsule.sheet->mesh.triangles.size()) - 1500) < 100);
                for (const Vec3& node : capsule.sheet->mesh.nodes) {
                    CHECK(std::abs(surface_level(lens, node) - 1.0) < 1e-9);
                }
                double springs = 0.0;
                double beyond = 0.0;
                for (const NodeSpring& spring : capsule.springs) {
                    (spring.on_support ? beyond : springs) += spring.stiffness;
                }
                double zonules = 0.0;
                for (const ZonuleSpring& zonule : bag.zonules) {
                    zonules += zonule.stiffness;
                }
                CHECK(springs == doctest::Approx(zonules));
                // the rim's length, of capsule as thick as there, 1 mm long
                const double rim = 0.9 * lens.radius;
                const double along_rim = 2.0 * std::numbers::pi * rim;
                CHECK(beyond ==
                      doctest::Approx(along_rim * capsule_modulus(age) * anterior_thickness(age, rim, lens.radius))
                          .epsilon(0.01));
                const double along = std::abs(capsule.sheet->fibre[700].dot(
                    Vec3::UnitZ().cross(triangle_middle(capsule.sheet->mesh, 700)).normalized()));
                CHECK((along > 0.999) == circles);
            }
        }
    }

    TEST_CASE("quiet on its lens; pressure of the vitreous lifts the lens and stretches the capsule") {
        double last_lift = -1.0;
        double last_energy = -1.0;
        for (const double push : {0.0, 3e4, 1e5}) {
            scenes::CapsuleScene scene(68.0, {}, {});
            scene.sheet().support.push = push;
            for (int i = 0; i < 80; ++i) {
                REQUIRE(scene.step());
            }
            const double lift = scene.sheet().support.lift;
            const double energy = elastic_energy(scene.model(), scene.sheet());
            if (push == 0.0) {
                CHECK(std::abs(lift) < 0.2);  // the zonules' own tension presses it back a little
                CHECK(scene.sheet().velocity[0].norm() < 0.01);
            }
            CHECK(lift > last_lift);
            CHECK(energy > last_energy);
            last_lift = lift;
            last_energy = energy;
        }
        CHECK(last_lift > 0.6);
        CHECK(last_lift < 1.1);
    }

    TEST_CASE("a pull of 15 mN near the pupil's edge leaves the outer rim where it is") {
        for (const double heading : {0.0, 1.0}) {
            scenes::CapsuleScene scene(68.0, {}, {});
            const std::vector<Vec3> rest = scene.sheet().position;
            const Vec3 outward(std::cos(heading), std::sin(heading), 0.0);
            SheetLoad pull{{}, -15000.0 * outward};
            for (int node = 0; node < static_cast<int>(rest.size()); ++node) {
                const Vec3& place = rest[static_cast<std::size_t>(node)];
                if ((place - scene.front(3.0 * outward.x(), 3.0 * outward.y())).norm() < 0.3) {
                    pull.nodes.push_back(node);
                }
            }
            REQUIRE(pull.nodes.size() >= 3);
            scene.sheet().loads.push_back(pull);
            for (int i = 0; i < 100; ++i) {
                REQUIRE(scene.step());
            }
            double farthest = 0.0;
            for (const NodeSpring& spring : scene.model().springs) {
                const std::size_t node = static_cast<std::size_t>(spring.node);
                farthest =
                    std::max(farthest, spring.on_support ? (scene.sheet().position[node] - rest[node]).norm() : 0.0);
            }
            CHECK(farthest < 0.3);
            CHECK(scene.sheet().velocity[0].norm() < 0.05);
        }
    }

    TEST_CASE("what a tear owes its tip lies in the curved sheet") {
        scenes::CapsuleScene scene(68.0, {}, {});
        for (const double angle : {0.3, 0.6, 0.9}) {
            scene.open_flap(1.0, 2.6, angle);
            const MembraneState& state = scene.sheet();
            const TearTip& tip = state.tips.back();
            Vec3 front = Vec3::Zero();
            const TriNeighbours& near = state.sheet->neighbours;
            for (int i = near.offset[static_cast<std::size_t>(tip.node)];
                 i < near.offset[static_cast<std::size_t>(tip.node) + 1]; ++i) {
                const int t = near.triangles[static_cast<std::size_t>(i)];
                const std::array<int, 3>& n = state.sheet->mesh.triangles[static_cast<std::size_t>(t)];
                front += triangle_area(state.sheet->mesh.nodes[static_cast<std::size_t>(n[0])],
                                       state.sheet->mesh.nodes[static_cast<std::size_t>(n[1])],
                                       state.sheet->mesh.nodes[static_cast<std::size_t>(n[2])]) *
                         front_of(state.sheet->mesh, t);
            }
            CHECK(std::abs(tip.owed.dot(front.normalized())) < 1e-9);
            scene.sheet() = rest_state(scene.model());
        }
    }
}
