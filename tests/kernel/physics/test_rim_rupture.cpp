// SPDX-License-Identifier: GPL-3.0-or-later
// The opening of a bag that is drawn out until it splits.
#include <doctest/doctest.h>

#include <cmath>

#include "eye/anatomy.hpp"
#include "eye/capsular_bag.hpp"
#include "eye/empty_bag.hpp"
#include "physics/membrane/rim_rupture.hpp"
#include "topology/tear.hpp"

using namespace rhexis;

namespace {

/// A bag whose opening is drawn out to an oval: x by this factor, y by its inverse, dying away to the equator.
MembraneState drawn_out(const MembraneModel& bag, double factor) {
    MembraneState state = rest_state(bag);
    for (Vec3& node : state.position) {
        if (node.z() > 0.0) {
            const double rho = node.head<2>().norm();
            const double share = std::clamp((4.8 - rho) / (4.8 - 2.6), 0.0, 1.0);
            node.x() *= 1.0 + share * (factor - 1.0);
            node.y() *= 1.0 + share * (factor - 1.0);
        }
    }
    return state;
}

}  // namespace

TEST_SUITE("rim rupture") {
    const HalfEllipsoids lens = lens_shape(Patient{});
    const MembraneModel bag = make_empty_bag(lens, make_bag(lens, 0.2, 68.0), 68.0, {});

    TEST_CASE("an opening drawn out by less than it bears stays whole") {
        CHECK(propose_notches(bag, rest_state(bag)).empty());
        CHECK(propose_notches(bag, drawn_out(bag, 1.3)).empty());
        MembraneModel strong = bag;
        strong.rupture_stretch = 0.0;
        CHECK(propose_notches(strong, drawn_out(bag, 3.0)).empty());
    }

    TEST_CASE("beyond that one notch goes from its edge into the sheet, and not a second one beside it") {
        MembraneState state = drawn_out(bag, 1.45);
        const std::vector<NotchProposal> proposals = propose_notches(bag, state);
        REQUIRE(proposals.size() == 1);
        const Vec3 place = bag.sheet->mesh.nodes[static_cast<std::size_t>(proposals[0].node)];
        CHECK(place.head<2>().norm() == doctest::Approx(2.6).epsilon(1e-2));
        CHECK(proposals[0].direction.norm() == doctest::Approx(1.0));
        CHECK(proposals[0].direction.head<2>().dot(place.head<2>().normalized()) > 0.5);  // away from the opening
        MembraneStepReport report;
        report.notches = proposals;
        REQUIRE(carry_out(bag, report, state) == 1);
        CHECK(validate_tri_mesh(state.sheet->mesh).ok());
        REQUIRE(state.tips.size() == 1);
        CHECK(state.sheet->mesh.nodes[static_cast<std::size_t>(state.tips[0].node)].head<2>().norm() > 2.7);
        for (const NotchProposal& next : propose_notches(bag, state)) {
            const Vec3 there = state.sheet->mesh.nodes[static_cast<std::size_t>(next.node)];
            CHECK((there - state.sheet->mesh.nodes[static_cast<std::size_t>(state.tips[0].node)]).norm() > 0.5);
        }
    }
}
