// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <limits>
#include <numeric>
#include <vector>

#include "base/rng.hpp"
#include "mesh/shapes.hpp"
#include "topology/remove.hpp"

using namespace rhexis;

namespace {

SolidModel two_level(const TetMesh& mesh) {
    SolidModel model;
    model.name = "body";
    model.coarse = mesh;
    model.fine = subdivide(mesh);
    model.materials = {Material{"inner"}, Material{"outer"}};
    model.materials[1].density = 2e-3;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        model.coarse.region[t] = static_cast<int>(t % 2);
    }
    return model;
}

std::vector<int> shuffled(std::size_t count, Rng& rng) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = count; i > 1; --i) {
        std::swap(order[i - 1], order[static_cast<std::size_t>(rng.integer(0, static_cast<std::int64_t>(i) - 1))]);
    }
    return order;
}

std::string message(const Status& status) { return status.ok() ? "" : status.error().text(); }

}  // namespace

TEST_SUITE("topology") {
    TEST_CASE("removing every fine tetrahedron in random order ends quietly and loses no mass") {
        const SolidModel model = two_level(bar(3, 2, 2, 0.5));
        Rng rng(11);
        SolidState state = rest_state(model);
        const double start = remaining_mass(model, state);
        double removed = 0.0;
        for (int fine : shuffled(model.fine.tets.size(), rng)) {
            // Half at once, then the rest, as an instrument does that erodes.
            for (double left : {0.5, 0.0}) {
                SolidState next = state;
                const double before = state.fraction[static_cast<std::size_t>(fine)];
                next.fraction[static_cast<std::size_t>(fine)] = left;
                removed += (before - left) * tet_mass(model, fine / 8) / 8.0;
                const MeshEdit edit = spent_elements(state, next, 0);
                CHECK(edit.removed_fine.size() == (left == 0.0 ? 1U : 0U));
                CHECK(edit_mass(edit, model, next) == 0.0);
                apply(edit, model, next);
                REQUIRE(message(validate(model, next)) == "");
                REQUIRE(std::abs(removed + remaining_mass(model, next) - start) < 1e-12 * start);
                state = next;
            }
        }
        CHECK(remaining_mass(model, state) == 0.0);
        for (std::uint8_t present : state.present) {
            CHECK(present == 0);
        }
    }

    TEST_CASE("removing every coarse tetrahedron in random order stops the nodes left without elements") {
        const SolidModel model = two_level(ball(1.0, 500));
        Rng rng(5);
        SolidState state = rest_state(model);
        const double start = remaining_mass(model, state);
        double removed = 0.0;
        state.velocity.assign(state.velocity.size(), Vec3(1, 2, 3));
        for (int t : shuffled(model.coarse.tets.size(), rng)) {
            const MeshEdit edit = remove_coarse(model, state, 0, {t, t});
            REQUIRE(edit.removed_coarse == std::vector<int>{t});
            CHECK(edit.removed_fine.size() == 8);
            removed += edit_mass(edit, model, state);
            apply(edit, model, state);
            REQUIRE(message(validate(model, state)) == "");
            REQUIRE(std::abs(removed + remaining_mass(model, state) - start) < 1e-12 * start);
        }
        CHECK(remove_coarse(model, state, 0, {0, 1}).empty());
        for (const Vec3& velocity : state.velocity) {
            CHECK(velocity == Vec3::Zero());
        }
    }

    TEST_CASE("a node keeps its velocity while one element holds it") {
        const SolidModel model = two_level(bar(1, 1, 1, 1.0));
        SolidState state = rest_state(model);
        state.velocity.assign(state.velocity.size(), Vec3(1, 0, 0));
        apply(remove_coarse(model, state, 0, {0}), model, state);
        CHECK(state.velocity[0] == Vec3::Zero());  // corner 0 belongs to tetrahedron 0 only
        CHECK(state.velocity[1] == Vec3(1, 0, 0));
    }

    TEST_CASE("a coarse tetrahedron goes only with the last of its 8 children") {
        const SolidModel model = two_level(bar(1, 1, 1, 1.0));
        SolidState state = rest_state(model);
        for (std::size_t child = 8; child < 15; ++child) {
            state.fraction[child] = 0.0;
        }
        CHECK(spent_elements(model, state, 0).removed_coarse.empty());
        CHECK(spent_elements(model, state, 0).removed_fine.size() == 7);
        const SolidState before = state;
        state.fraction[15] = 0.0;
        CHECK(spent_elements(model, state, 0).removed_coarse == std::vector<int>{1});
        const MeshEdit edit = spent_elements(before, state, 0);
        CHECK(edit.removed_fine == std::vector<int>{15});
        CHECK(edit.removed_coarse == std::vector<int>{1});
        apply(edit, model, state);
        CHECK(spent_elements(model, state, 0).empty());
    }

    TEST_CASE("a solid without a fine mesh loses whole tetrahedra") {
        SolidModel model = two_level(bar(2, 1, 1, 1.0));
        model.fine = {};
        SolidState state = rest_state(model);
        const double start = remaining_mass(model, state);
        const MeshEdit edit = remove_coarse(model, state, 0, {3, 1});
        CHECK(edit.removed_coarse == std::vector<int>{1, 3});
        const double taken = edit_mass(edit, model, state);
        apply(edit, model, state);
        CHECK(message(validate(model, state)) == "");
        CHECK(taken + remaining_mass(model, state) == doctest::Approx(start).epsilon(1e-14));
        CHECK(spent_elements(model, state, 0).empty());
    }

    TEST_CASE("an inconsistent state is reported with the first element that is wrong") {
        const SolidModel model = two_level(bar(1, 1, 1, 1.0));
        const auto with = [&model](const auto& spoil) {
            SolidState state = rest_state(model);
            spoil(state);
            return message(validate(model, state));
        };
        CHECK(with([](SolidState&) {}) == "");
        CHECK(with([](SolidState& s) { s.fraction.pop_back(); }).find("do not fit") != std::string::npos);
        CHECK(with([](SolidState& s) {
                  s.position[3].x() = std::numeric_limits<double>::quiet_NaN();
              }).find("node 3 ") != std::string::npos);
        CHECK(with([](SolidState& s) { s.fraction[9] = 1.5; }).find("fine tetrahedron 9 ") != std::string::npos);
        CHECK(with([](SolidState& s) {
                  s.fraction[9] = std::numeric_limits<double>::quiet_NaN();
              }).find("fine tetrahedron 9 ") != std::string::npos);
        CHECK(with([](SolidState& s) { s.present[2] = 0; }).find("fine tetrahedron 16 ") != std::string::npos);
        CHECK(with([](SolidState& s) { s.present[2] = 7; }).find("tetrahedron 2 ") != std::string::npos);
        CHECK(with([](SolidState& s) {
                  std::fill(s.fraction.begin() + 16, s.fraction.begin() + 24, 0.0);
              }).find("tetrahedron 2 is present") != std::string::npos);
    }
}
