// SPDX-License-Identifier: GPL-3.0-or-later
// The capsular bag without its lens, as a membrane.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "eye/anatomy.hpp"
#include "eye/capsular_bag.hpp"
#include "eye/empty_bag.hpp"
#include "math/turn.hpp"

using namespace rhexis;

namespace {

const HalfEllipsoids lens = lens_shape(Patient{});

MembraneModel bag_of(const EmptyBagSettings& settings) {
    return make_empty_bag(lens, make_bag(lens, 0.2, 68.0), 68.0, settings);
}

std::vector<Vec3> rim_of(const MembraneModel& bag) {
    const std::vector<std::vector<int>> loops = boundary_loops(bag.sheet->mesh, bag.sheet->neighbours);
    REQUIRE(loops.size() == 1);
    std::vector<Vec3> rim;
    for (const int node : loops[0]) {
        rim.push_back(bag.sheet->mesh.nodes[static_cast<std::size_t>(node)]);
    }
    return rim;
}

}  // namespace

TEST_SUITE("empty bag") {
    TEST_CASE(
        "one sound sheet on the lens's contour, open in front, its triangles as many as asked for and none thin") {
        for (const int triangles : {300, 800, 3000}) {
            CAPTURE(triangles);
            const MembraneModel bag = bag_of({.triangles = triangles});
            REQUIRE(check_membrane(bag).ok());
            const TriMesh& mesh = bag.sheet->mesh;
            CHECK(std::abs(static_cast<double>(mesh.triangles.size()) - triangles) < 0.2 * triangles);
            CHECK(smallest_angle(mesh) > 25.0 * std::numbers::pi / 180.0);
            for (const Vec3& node : mesh.nodes) {
                CHECK(surface_level(lens, node) == doctest::Approx(1.0).epsilon(1e-4));
            }
            for (const Vec3& place : rim_of(bag)) {
                CHECK(place.head<2>().norm() == doctest::Approx(2.6).epsilon(1e-3));
                CHECK(place.z() > 0.0);
            }
            for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
                CHECK(front_of(mesh, t).dot(triangle_middle(mesh, t)) > 0.0);  // outwards
            }
        }
    }

    TEST_CASE("an opening that is no circle about the axis is where it is said to be") {
        EmptyBagSettings settings;
        const Vec2 middle(0.4, -0.3);
        for (int i = 0; i < 64; ++i) {
            const Vec2 way = direction_at(2.0 * std::numbers::pi * i / 64);
            const double along = middle.dot(way);
            settings.opening.push_back(along + std::sqrt(along * along - middle.squaredNorm() + 2.5 * 2.5));
        }
        const MembraneModel bag = bag_of(settings);
        REQUIRE(check_membrane(bag).ok());
        for (const Vec3& place : rim_of(bag)) {
            CHECK((place.head<2>() - middle).norm() == doctest::Approx(2.5).epsilon(5e-3));
        }
    }

    TEST_CASE("with an opening off the axis it hangs all round, and its triangles stay sound") {
        EmptyBagSettings settings;
        for (int i = 0; i < 64; ++i) {
            settings.opening.push_back(i < 32 ? 2.2 : 3.1);  // a step, as where a tear met its beginning
        }
        REQUIRE(check_empty_bag(settings).ok());
        const MembraneModel bag = bag_of(settings);
        REQUIRE(check_membrane(bag).ok());
        CHECK(smallest_angle(bag.sheet->mesh) > 12.0 * std::numbers::pi / 180.0);
        for (const double side : {-1.0, 1.0}) {
            int zonules = 0;
            double pull = 0.0;
            for (const NodeSpring& spring : bag.springs) {
                const Vec3& place = bag.sheet->mesh.nodes[static_cast<std::size_t>(spring.node)];
                if (spring.slack > 0.0 && place.z() > 0.0 && place.x() * side > 0.0) {
                    ++zonules;
                    pull += spring.stiffness;
                }
            }
            CHECK(zonules > 10);
            CHECK(pull > 0.0);
        }
    }

    TEST_CASE("it hangs on as much zonule as the bag has, and lies before the vitreous") {
        const BagModel whole = make_bag(lens, 0.2, 68.0);
        const MembraneModel bag = bag_of({});
        double zonules = 0.0;
        double vitreous = 0.0;
        for (const NodeSpring& spring : bag.springs) {
            const bool free = spring.slack > 0.0;
            (free ? zonules : vitreous) += spring.stiffness;
            CHECK((free || bag.sheet->mesh.nodes[static_cast<std::size_t>(spring.node)].z() < 0.0));
        }
        double wanted = 0.0;
        for (const ZonuleSpring& zonule : whole.zonules) {
            wanted += zonule.stiffness;
        }
        CHECK(zonules == doctest::Approx(wanted));
        CHECK(vitreous > 5e4);
        CHECK(vitreous < 1.2e5);
    }

    TEST_CASE("what cannot be is refused by name") {
        const auto text = [](const EmptyBagSettings& settings) {
            const Status status = check_empty_bag(settings);
            return status.ok() ? std::string() : status.error().text();
        };
        CHECK(text({}).empty());
        CHECK(text({.triangles = 100}).find("triangles") != std::string::npos);
        CHECK(text({.opening_radius = 4.5}).find("opening_radius") != std::string::npos);
        CHECK(text({.opening = {2.5, 0.0}}).find("radius 1 of the opening") != std::string::npos);
        CHECK(text({.opening = std::vector<double>(10, 2.5)}).find("number of radii") != std::string::npos);
        std::vector<double> jump(64, 2.0);
        jump[5] = 3.5;
        CHECK(text({.opening = jump}).find("jumps by 1.5 mm beside radius 4 (at most 1 mm)") != std::string::npos);
        CHECK(text({.friction = -1.0}).find("friction") != std::string::npos);
    }
}
