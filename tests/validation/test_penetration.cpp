// SPDX-License-Identifier: GPL-3.0-or-later
// The verifier of penetration, by crossings that are known; and what it says of an implant and of a capsule.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/rng.hpp"
#include "scenes/verified_runs.hpp"

using namespace rhexis;
using namespace rhexis::scenes;

namespace {

constexpr double fine = 1e-9;  // [mm]

Mover still(double x, double y, double z) { return {Vec3(x, y, z), Vec3(x, y, z), 0.0}; }

Mover moved(const Vec3& from, const Vec3& to) { return {from, to, 0.0}; }

std::array<Mover, 3> flat_triangle() { return {still(0, 0, 0), still(1, 0, 0), still(0, 1, 0)}; }

bool corner_keeps(const Mover& corner, const std::array<Mover, 3>& triangle) {
    return stays_apart(corner_to_triangle(corner, triangle, 0.0), fine).apart;
}

bool edges_keep(const std::array<Mover, 2>& a, const std::array<Mover, 2>& b) {
    return stays_apart(edge_to_edge(a, b, 0.0), fine).apart;
}

Vec3 any_place(Rng& rng) {
    Vec3 place;
    for (double& number : place) {
        number = 2.0 * rng.uniform() - 1.0;
    }
    return place;
}

/// A corner that meets a triangle of any motion at some time and place in it.
struct Meeting {
    Mover corner;
    std::array<Mover, 3> triangle;
};

Meeting any_meeting(Rng& rng) {
    Meeting made;
    const double time = rng.uniform();
    const double first = rng.uniform();
    const double second = (1.0 - first) * rng.uniform();
    const std::array<double, 3> weights{1.0 - first - second, first, second};
    Vec3 met = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        made.triangle[k] = moved(any_place(rng), any_place(rng));
        met += weights[k] * ((1.0 - time) * made.triangle[k].from + time * made.triangle[k].to);
    }
    const Vec3 speed = 3.0 * any_place(rng);
    made.corner = moved(met - time * speed, met + (1.0 - time) * speed);
    return made;
}

/// A square of two triangles in the plane z, of a thickness.
Skin square_skin(double half) {
    Skin skin;
    skin.triangles = {{0, 1, 2}, {0, 2, 3}};
    skin.half.assign(4, half);
    for (int i = 0; i < 4; ++i) {
        skin.place.push_back(i);
        skin.nodes.push_back({i, -1, -1});
    }
    skin.parent = {0, 1};
    skin.near = {{0, 1, 2}, {0, 2, 3}};
    return skin;
}

std::vector<Vec3> square_at(double z, double size = 1.0) {
    return {Vec3(-size, -size, z), Vec3(size, -size, z), Vec3(size, size, z), Vec3(-size, size, z)};
}

void print(const VerifiedRun& run) {
    std::string shares;
    for (std::size_t i = 0; i < depths_tried.size(); ++i) {
        shares += " " + std::to_string(100 * run.free_to[i] / run.steps) + "% to " +
                  std::to_string(static_cast<int>(100.0 * depths_tried[i])) + "%;";
    }
    MESSAGE(run.name, ": ", run.steps, " steps proven free of penetration:", shares, " deepest ",
            100.0 * run.worst.of_thickness, " % of the thickness, ", 100.0 * run.worst.of_edge,
            " % of an edge, in step ", run.worst_step, "; pairs that may cross: ", run.worst.crossing);
}

}  // namespace

TEST_SUITE("penetration verifier") {
    TEST_CASE("a corner that passes through a triangle is found, one that passes beside it proven free") {
        const std::array<Mover, 3> triangle = flat_triangle();
        CHECK_FALSE(corner_keeps(moved({0.2, 0.2, 1.0}, {0.2, 0.2, -1.0}), triangle));
        CHECK(stays_apart(corner_to_triangle(moved({0.2, 0.2, 1.0}, {0.2, 0.2, -3.0}), triangle, 0.0), fine).since ==
              doctest::Approx(0.25).epsilon(1e-6));
        CHECK(corner_keeps(moved({0.6, 0.6, 1.0}, {0.6, 0.6, -1.0}), triangle));
        for (const double beside : {1e-3, 1e-6, 1e-9}) {
            CHECK(corner_keeps(moved({0.3, -beside, 1.0}, {0.3, -beside, -1.0}), triangle));
            CHECK(corner_keeps(moved({0.2, 0.2, 1.0}, {0.2, 0.2, beside}), triangle));
        }
        CHECK_FALSE(corner_keeps(moved({0.3, 0.0, 1.0}, {0.3, 0.0, -1.0}), triangle));  // through an edge
        CHECK_FALSE(corner_keeps(moved({0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}), triangle));  // through a corner
        CHECK_FALSE(corner_keeps(moved({0.2, 0.2, 1.0}, {0.2, 0.2, 0.0}), triangle));   // ends in it
    }

    TEST_CASE("edges that pass through each other are found, near misses proven free") {
        const std::array<Mover, 2> edge{still(-1, 0, 0), still(1, 0, 0)};
        const auto across = [](double x, double from, double to) {
            return std::array<Mover, 2>{moved({x, -1, from}, {x, -1, to}), moved({x, 1, from}, {x, 1, to})};
        };
        CHECK_FALSE(edges_keep(edge, across(0.3, 1.0, -1.0)));
        CHECK_FALSE(edges_keep(edge, across(1.0, 1.0, -1.0)));  // at its end
        CHECK(edges_keep(edge, across(1.0 + 1e-6, 1.0, -1.0)));
        CHECK(edges_keep(edge, across(0.3, 1.0, 1e-6)));
        // parallel, one after the other in a line
        CHECK(edges_keep(edge, {still(1.001, 0, 0), still(2, 0, 0)}));
        CHECK_FALSE(edges_keep(edge, {still(0.5, 0, 0), still(2, 0, 0)}));
        CHECK(edges_keep(edge, {still(-1, 1e-4, 0), still(1, 1e-4, 0)}));
    }

    TEST_CASE("a step that ends free of penetration is told when it went through on its way") {
        const Skin skin = square_skin(0.0);
        const std::vector<Vec3> below = square_at(0.0, 2.0);
        const std::vector<Vec3> from = square_at(0.5);
        const std::vector<Vec3> to = square_at(-0.5);
        const MovingSkin ground{skin, below, below};
        CHECK(pierced_at_start({skin, to, to}, ground) == 0);
        const StepFinding found = verify_pair({skin, from, to}, ground);
        CHECK(found.level == depths_tried.size());
        CHECK(found.since == doctest::Approx(0.5).epsilon(1e-3));
        CHECK(found.deepest == doctest::Approx(0.5));
        CHECK(verify_pair({skin, from, square_at(0.01)}, ground).level == 0);
        CHECK(verify_pair({skin, from, square_at(0.0)}, ground).level == depths_tried.size());  // ends on it
        // there and back within a step is not even movement: nothing was told of it
        CHECK(verify_pair({skin, from, from}, ground).level == 0);
    }

    TEST_CASE("depth is proven by thickness") {
        const Skin skin = square_skin(0.1);
        const std::vector<Vec3> below = square_at(0.0, 2.0);
        const auto deep_by = [&](double gap) {
            return verify_pair({skin, square_at(0.5), square_at(gap)}, {skin, below, below});
        };
        CHECK(deep_by(0.2001).level == 0);
        CHECK(depths_tried[deep_by(0.197).level] == 0.02);
        CHECK(deep_by(0.197).of_thickness == doctest::Approx(0.015).epsilon(1e-6));
        CHECK(depths_tried[deep_by(0.15).level] == 0.5);
        CHECK(depths_tried[deep_by(0.01).level] == 1.0);
        const StepFinding through = deep_by(-0.05);
        CHECK(through.level == depths_tried.size());
        CHECK(through.of_thickness == doctest::Approx(1.25));
    }

    TEST_CASE("coplanar and degenerate input is never proven free where it touches") {
        const std::array<Mover, 3> triangle = flat_triangle();
        CHECK_FALSE(corner_keeps(moved({-1, 0.2, 0}, {2, 0.2, 0}), triangle));  // in its plane, into it
        CHECK(corner_keeps(moved({-1, 1.2, 0}, {2, 1.2, 0}), triangle));        // in its plane, past it
        const std::array<Mover, 3> line{still(0, 0, 0), still(1, 0, 0), still(2, 0, 0)};
        CHECK_FALSE(corner_keeps(moved({1.5, 1, 0}, {1.5, -1, 0}), line));
        CHECK(corner_keeps(moved({2.5, 1, 0}, {2.5, -1, 0}), line));
        const std::array<Mover, 3> point{still(0, 0, 0), still(0, 0, 0), still(0, 0, 0)};
        CHECK_FALSE(corner_keeps(moved({-1, 0, 0}, {1, 0, 0}), point));
        CHECK(corner_keeps(moved({-1, 1e-6, 0}, {1, 1e-6, 0}), point));
        CHECK_FALSE(corner_keeps(still(0, 0, 0), point));
        const std::array<Mover, 2> spot{still(0, 0, 0), still(0, 0, 0)};
        CHECK_FALSE(edges_keep(spot, {moved({-1, 0, 1}, {-1, 0, -1}), moved({1, 0, 1}, {1, 0, -1})}));
        // far from the origin, where coordinates are coarse
        const Vec3 far = Vec3::Constant(1e6);
        std::array<Mover, 3> away = triangle;
        for (Mover& corner : away) {
            corner = moved(corner.from + far, corner.to + far);
        }
        CHECK_FALSE(corner_keeps(moved(far + Vec3(0.2, 0.2, 1), far + Vec3(0.2, 0.2, -1)), away));
        CHECK(corner_keeps(moved(far + Vec3(0.2, 0.2, 1), far + Vec3(0.2, 0.2, 1e-3)), away));
    }

    TEST_CASE("none of 20,000 meetings of any motion is missed, and what keeps away is proven to") {
        Rng rng(7);
        int missed = 0;
        int unproven = 0;
        for (int i = 0; i < 20000; ++i) {
            const Meeting made = any_meeting(rng);
            missed += corner_keeps(made.corner, made.triangle) ? 1 : 0;
            // from beyond all that the triangle can reach
            const Vec3 out(0.0, 0.0, 1.0 + 1e-7);
            Mover above = moved(any_place(rng), any_place(rng));
            above.from.z() = std::abs(above.from.z()) + out.z();
            above.to.z() = std::abs(above.to.z()) + out.z();
            unproven += corner_keeps(above, made.triangle) ? 0 : 1;
        }
        CHECK(missed == 0);
        CHECK(unproven == 0);
    }

    TEST_CASE("an edge that goes through a triangle's face, away from corners and edges, is told at the start") {
        Skin skin = square_skin(0.0);
        const std::vector<Vec3> ground = square_at(0.0, 2.0);
        std::vector<Vec3> upright = square_at(0.0, 0.5);
        for (Vec3& place : upright) {
            place = Vec3(place.x(), 0.1, place.y());
        }
        CHECK(pierced_at_start({skin, upright, upright}, {skin, ground, ground}) > 0);
        for (Vec3& place : upright) {
            place.z() += 0.5 + 1e-6;
        }
        CHECK(pierced_at_start({skin, upright, upright}, {skin, ground, ground}) == 0);
    }

    TEST_CASE("a ball that a surface comes down on, and one that is shot through it") {
        const Skin skin = square_skin(0.05);
        MovingSolid ball;
        ball.distance = [](double, const Vec3& place) { return (place - Vec3(0.2, 0.3, 0.0)).norm() - 0.3; };
        CHECK(verify_solid({skin, square_at(0.6), square_at(0.36)}, ball).level == 0);
        CHECK(depths_tried[verify_solid({skin, square_at(0.6), square_at(0.347)}, ball).level] == 0.1);
        CHECK(verify_solid({skin, square_at(0.6), square_at(-0.6)}, ball).level == depths_tried.size());
        MovingSolid shot = ball;
        shot.distance = [](double share, const Vec3& place) {
            return (place - Vec3(0.2, 0.3, 1.0 - 2.0 * share)).norm() - 0.01;
        };
        shot.travel = 2.0;
        const StepFinding found = verify_solid({skin, square_at(0.0), square_at(0.0)}, shot);
        CHECK(found.level == depths_tried.size());
        CHECK(found.since == doctest::Approx(0.495).epsilon(1e-2));
    }
}

TEST_SUITE("steps without penetration") {
    TEST_CASE("an implant that is pushed out of its cartridge and unfolds crosses neither itself nor the plunger") {
        for (const VerifiedRun& run : verify_injection({.triangles = 400.0, .unfolding = 0.5})) {
            print(run);
            CHECK(run.pierced_at_start == 0);
            CHECK(run.first_crossing == -1);
        }
    }

    TEST_CASE("a capsule that is torn round and folded over does not pass through itself") {
        for (const VerifiedRun& run : verify_tear(1500, 0.4)) {
            print(run);
            CHECK(run.pierced_at_start == 0);
            CHECK(run.first_crossing == -1);
        }
    }
}
