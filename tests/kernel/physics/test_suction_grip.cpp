// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "physics/fluid/aspiration.hpp"
#include "physics/fluid/suction_grip.hpp"
#include "physics/physics.hpp"
#include "scenes/bodies.hpp"
#include "tools/phaco_tip.hpp"

using namespace rhexis;

namespace {

constexpr double modulus = 5000.0;

/// A cube of lens, 2 mm, that floats before the mouth of a tip from above.
struct Held {
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>();
    WorldState state;
    std::vector<ToolState> tools{ToolState{}};
    std::vector<MouthProbe> probes;

    explicit Held(double hold_uN, double power = 0.0) {
        SolidModel cube = scenes::cube(3, 2.0, modulus, 0.45);
        cube.damping_mass = 20.0;
        cube.advance = Advance::explicit_;
        model->solids.push_back(cube);
        model->gravity = Vec3::Zero();
        model->tools.push_back(phaco_tip());
        model->tools[0].bevel = 0.0;
        state = rest_state(*model);
        probes.push_back(mouth_probe(model->tools[0]));
        tools[0].present = true;
        tools[0].pose.position = Vec3(0.0, 0.0, 1.02);
        tools[0].previous_pose = tools[0].pose;
        tools[0].power = power;
        set_hold(hold_uN);
    }
    void set_hold(double hold_uN) {
        TipState& tip = state.tips[0];
        tip.lens = 1.0;
        tip.open = 0.0;
        tip.hold = hold_uN;
        tip.suction = hold_uN / probes[0].area;
    }
    [[nodiscard]] Vec3 centre() const {
        const std::vector<Vec3>& x = state.solids[0].position;
        return std::accumulate(x.begin(), x.end(), Vec3(Vec3::Zero())) / static_cast<double>(x.size());
    }
    /// The tip goes sideways at 2 mm/s; how far the cube has come with it [mm].
    double follow(double seconds) {
        Result<Physics> made = Physics::create(model, {});
        REQUIRE(made.ok());
        Physics physics = std::move(made).value();
        ContactSet contacts;
        Profile profile;
        const double hold = state.tips[0].hold;
        const Vec3 before = centre();
        for (int i = 0; i < std::lround(seconds / 0.01); ++i) {
            tools[0].previous_pose = tools[0].pose;
            tools[0].pose.position.x() += 0.02;
            WorldState next;
            REQUIRE(physics.advance(state, tools, 0.01, next, contacts, profile).failure == StepFailure::none);
            state = next;
            set_hold(hold);
        }
        return (centre() - before).x();
    }
    /// The greatest force of the tip on the cube while growing forces on all nodes pull it straight off [uN].
    double borne() {
        Result<Physics> made = Physics::create(model, {});
        REQUIRE(made.ok());
        Physics physics = std::move(made).value();
        ContactSet contacts;
        Profile profile;
        NodeLoad pull;
        pull.nodes.resize(state.solids[0].position.size());
        std::iota(pull.nodes.begin(), pull.nodes.end(), 0);
        const double hold = state.tips[0].hold;
        const Vec3 before = centre();
        double most = 0.0;
        for (int i = 1; i <= 100 && (before - centre()).z() < 0.6; ++i) {
            pull.total.z() = -0.03 * hold * i;
            state.loads = {pull};
            WorldState next;
            REQUIRE(physics.advance(state, tools, 0.01, next, contacts, profile).failure == StepFailure::none);
            state = next;
            set_hold(hold);
            most = std::max(most, std::accumulate(contacts.begin(), contacts.end(), 0.0,
                                                  [](double sum, const Contact& one) { return sum + one.force.z(); }));
        }
        return most;
    }
    std::vector<SuctionGrip> grips() {
        std::vector<SuctionGrip> found;
        find_grips(*model, state, tools, probes, found);
        return found;
    }
};

}  // namespace

TEST_SUITE("suction grip") {
    TEST_CASE("what suction holds comes with the tip; what it does not, does not") {
        const double led = Held(20000.0).follow(0.4);
        CHECK(led == doctest::Approx(0.8).epsilon(0.15));
        CHECK(Held(0.01).follow(0.4) < 0.2 * led);
    }

    TEST_CASE("contacts and grip bear suction once") {
        Held firm(2000.0);
        firm.model->solids[0].materials[0].young_modulus = 10.0 * modulus;
        CHECK(firm.borne() == doctest::Approx(2000.0).epsilon(0.1));
        Held beside(2000.0);
        beside.state.tips[0].lens = 0.5;
        beside.state.tips[0].capsule = 0.5;
        CHECK(hold_of_lens(beside.state.tips[0]) == 1000.0);
    }

    TEST_CASE("ultrasound shakes it off") {
        CHECK(Held(20000.0, 0.5).grips().empty());
        CHECK(Held(20000.0).grips().size() == 1);
        CHECK(Held(0.0).grips().empty());
    }

    TEST_CASE(
        "the patch: shares of sum 1, within reach of the mouth, none of tissue that does not hang together with it") {
        Held held(20000.0);
        // a second cube beside the first that shares no node, as near to the mouth
        SolidModel& cube = held.model->solids[0];
        const int nodes = static_cast<int>(cube.coarse.nodes.size());
        TetMesh twice = cube.coarse;
        for (const Vec3& node : cube.coarse.nodes) {
            twice.nodes.push_back(node + Vec3(0.0, 2.05, 0.0));
        }
        for (const std::array<int, 4>& tet : cube.coarse.tets) {
            twice.tets.push_back({tet[0] + nodes, tet[1] + nodes, tet[2] + nodes, tet[3] + nodes});
            twice.region.push_back(0);
        }
        cube.coarse = twice;
        cube.fine = subdivide(twice);
        held.state = rest_state(*held.model);
        held.tools[0].pose.position = held.tools[0].previous_pose.position = Vec3(0.0, 0.55, 1.02);
        held.set_hold(20000.0);
        const std::vector<SuctionGrip> grips = held.grips();
        REQUIRE(grips.size() == 1);
        CHECK(std::accumulate(grips[0].weights.begin(), grips[0].weights.end(), 0.0) == doctest::Approx(1.0));
        CHECK(grips[0].limit == 20000.0);
        for (std::size_t i = 0; i < grips[0].nodes.size(); ++i) {
            CHECK(grips[0].nodes[i] < nodes);
            CHECK(grips[0].weights[i] >= 0.0);
            CHECK((held.state.solids[0].position[grips[0].nodes[i]] - Vec3(0.0, 0.55, 1.02)).norm() < 2.0);
        }
    }

    TEST_CASE("nothing left before the mouth: no grip") {
        Held held(20000.0);
        for (double& fraction : held.state.solids[0].fraction) {
            fraction = 0.0;
        }
        CHECK(held.grips().empty());
    }
}

TEST_SUITE("aspiration") {
    TEST_CASE("tissue enters beyond ten times its modulus; half of it at half of that, and with ultrasound at less") {
        const auto taken = [](double suction, double fraction, double power) {
            Held held(suction * mouth_probe(phaco_tip()).area, power);
            for (double& left : held.state.solids[0].fraction) {
                left = fraction;
            }
            held.model->solids[0].materials[0].ablation_energy = 30.0;
            const double before = held.state.removed_mass;
            aspirate(*held.model, 0, held.tools[0], held.probes[0], 0.0, 0.01, held.state);
            return held.state.removed_mass - before;
        };
        CHECK(taken(9.9 * modulus, 1.0, 0.0) == 0.0);
        CHECK(taken(11.0 * modulus, 1.0, 0.0) > 0.0);
        CHECK(taken(4.9 * modulus, 0.5, 0.0) == 0.0);
        CHECK(taken(5.1 * modulus, 0.5, 0.0) > 0.0);
        CHECK(taken(2.9 * modulus, 1.0, 1.0) == 0.0);
        CHECK(taken(3.1 * modulus, 1.0, 1.0) > 0.0);
    }
}
