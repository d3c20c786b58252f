// SPDX-License-Identifier: GPL-3.0-or-later
// A shell against planes, tubes, instruments and itself.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "math/rotation.hpp"
#include "physics/shell/shell_motion.hpp"
#include "scenes/shell_contacts.hpp"
#include "support/finite_difference.hpp"

using namespace rhexis;

namespace {

/// Forces and moments of contacts on all points, movement and turn of each node in turn.
VecX forces_of(const std::vector<ContactTerm>& terms, std::size_t points) {
    VecX sum = VecX::Zero(static_cast<Eigen::Index>(3 * points));
    for (const ContactTerm& term : terms) {
        for (const ContactShare& share : term.more) {
            sum.segment<3>(3 * share.node) += share.share.transpose() * term.force;
        }
    }
    return sum;
}

std::vector<Vec3> points_of(const VecX& x) {
    std::vector<Vec3> points(static_cast<std::size_t>(x.size() / 3));
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = x.segment<3>(static_cast<Eigen::Index>(3 * i));
    }
    return points;
}

VecX flat(const ShellState& state) {
    VecX x = VecX::Zero(static_cast<Eigen::Index>(6 * state.position.size()));
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        x.segment<3>(static_cast<Eigen::Index>(6 * n)) = state.position[n];
    }
    return x;
}

/// Of all partners' forces, against the energy of their springs; how many touched.
int check_gradient(const ShellModel& model, const ShellState& state, const ShellPartners& partners, double step) {
    ShellContacts contacts(model);
    contacts.look(state, partners);
    const VecX x = flat(state);
    std::vector<ContactTerm> terms;
    contacts.terms(points_of(x), terms);
    const VecX force = forces_of(terms, 2 * state.position.size());
    const auto energy = [&](const VecX& there) {
        return VecX(VecX::Constant(1, -contacts.normal_energy(points_of(there))));
    };
    CHECK(rhexis::test::derivative_error(energy, x, force.transpose(), step) < 1e-6);
    return static_cast<int>(terms.size());
}

/// A strip bent and turned a little everywhere.
ShellState shaken(const ShellModel& model, double size) {
    Rng rng(1, "shell contact");
    ShellState state = rest_state(model);
    const auto random = [&] { return Vec3(2.0 * uniform3(rng) - Vec3::Ones()); };
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        state.position[n] += 0.2 * size * random();
        state.rotation[n] = Quat(cayley(size * random()));
    }
    return state;
}

}  // namespace

TEST_SUITE("shell contact forces") {
    TEST_CASE("without friction they are the gradient of the springs' energy, for places and turns") {
        const ShellModel model = scenes::flat_strip(3.0, 1.0, 0.2, 6, 2);
        const ShellState state = shaken(model, 0.1);
        SUBCASE("plane") {
            PlaneModel plane{Vec3(0.0, 0.0, -0.09), Vec3(0.1, 0.0, 1.0).normalized(), 0.0};
            ShellPartners partners;
            partners.planes = {&plane, 1};
            CHECK(check_gradient(model, state, partners, 1e-6) > 3);
        }
        SUBCASE("rod") {
            const ToolModel tool = scenes::rod(0.3, 0.2);
            const ToolState pose = scenes::moving_tool(Vec3(1.5, 0.5, 0.45), Vec3(1.5, 0.5, 0.39));
            ShellPartners partners;
            partners.tools = {&tool, 1};
            partners.tool_states = {&pose, 1};
            CHECK(check_gradient(model, state, partners, 1e-6) > 3);
        }
        SUBCASE("forceps that hold, and that slip") {
            for (const double hold : {1e9, 100.0}) {
                const ToolModel tool = scenes::forceps(0.6, hold);
                ToolState pose = scenes::moving_tool(Vec3(1.5, 0.5, 0.0), Vec3(1.52, 0.49, 0.06));
                pose.previous_jaw = 1.0;
                ShellPartners partners;
                partners.tools = {&tool, 1};
                partners.tool_states = {&pose, 1};
                CHECK(check_gradient(model, state, partners, 1e-6) > 3);
            }
        }
        SUBCASE("tube") {
            TubeModel tube;
            tube.pose.orientation = Quat(Eigen::AngleAxisd(M_PI / 2.0, Vec3::UnitY()));  // its z along x
            tube.pose.position = Vec3(0.0, 0.5, 0.0);
            tube.stations = {{2.4, 0.55, 0.55}};
            ShellPartners partners;
            partners.tubes = {&tube, 1};
            CHECK(check_gradient(model, state, partners, 1e-6) > 5);
        }
    }

    TEST_CASE("layers: gradient of the energy; forces and moments of both sides sum to nothing, with friction") {
        ShellModel model = scenes::flat_strip(12.0, 1.0, 0.2, 40, 2);
        const ShellState state = scenes::rolled_strip(model, 0.8, 0.19);
        CHECK(check_gradient(model, state, ShellPartners{}, 1e-6) > 50);
        model.friction = 0.5;
        ShellContacts contacts(model);
        contacts.look(state, ShellPartners{});
        ShellState moved = state;
        for (std::size_t n = 0; n < moved.position.size(); ++n) {
            moved.position[n].y() += 0.02 * std::sin(static_cast<double>(n));
        }
        contacts.settle(points_of(flat(moved)), moved.touches);
        REQUIRE(moved.touches.size() > 50);
        contacts.look(moved, ShellPartners{});
        std::vector<ContactTerm> terms;
        contacts.terms(points_of(flat(moved)), terms);
        REQUIRE(terms.size() > 50);
        const VecX all = forces_of(terms, 2 * state.position.size());
        Vec3 force = Vec3::Zero();
        Vec3 moment = Vec3::Zero();
        double size = 0.0;
        double sideways = 0.0;
        for (Eigen::Index n = 0; n < static_cast<Eigen::Index>(state.position.size()); ++n) {
            const Vec3 own = all.segment<3>(6 * n);
            force += own;
            moment += moved.position[static_cast<std::size_t>(n)].cross(own) + all.segment<3>(6 * n + 3);
            size += own.norm();
            sideways += std::abs(own.y());
        }
        CHECK(sideways > 0.01 * size);
        CHECK(force.norm() < 1e-12 * size);
        CHECK(moment.norm() < 1e-12 * size);
    }

    TEST_CASE("layers that stick: gradient of the energy; what never touched is not held") {
        ShellModel model = scenes::flat_strip(12.0, 1.0, 0.2, 40, 2);
        model.friction = 0.0;
        model.tack = 2e4;
        const ShellState pressed = scenes::rolled_strip(model, 0.8, 0.19);
        ShellState apart = scenes::rolled_strip(model, 0.8, 0.208);
        CHECK(check_gradient(model, apart, ShellPartners{}, 1e-7) == 0);
        ShellContacts contacts(model);
        contacts.look(pressed, ShellPartners{});
        contacts.settle(points_of(flat(pressed)), apart.touches);
        REQUIRE(apart.touches.size() > 50);
        CHECK(check_gradient(model, apart, ShellPartners{}, 1e-7) > 50);
        contacts.look(apart, ShellPartners{});
        contacts.settle(points_of(flat(apart)), apart.touches);
        CHECK(contacts.touching() == 0);
        CHECK(apart.touches.size() > 50);
        CHECK(contacts.work().stored > 0.0);
        model.tack = 0.0;
        ShellContacts bare(model);
        bare.look(pressed, ShellPartners{});
        bare.settle(points_of(flat(pressed)), apart.touches);
        CHECK(apart.touches.empty());
    }

    TEST_CASE("layers that were looked for before are those of a new search, however the shell has moved since") {
        const ShellModel model = scenes::flat_strip(12.0, 1.0, 0.2, 40, 2);
        const ShellState rolled = scenes::rolled_strip(model, 0.8, 0.19);
        ShellState state = rolled;
        ShellContacts kept(model);
        for (int i = 0; i < 40; ++i) {
            // pressed flat, step by step, while it goes away as a whole
            for (std::size_t n = 0; n < state.position.size(); ++n) {
                const Vec3& from = rolled.position[n];
                state.position[n] = Vec3(from.x() * (1.0 + 0.005 * i) + 0.3 * i, from.y(), from.z() * (1.0 - 0.01 * i));
            }
            ShellContacts anew(model);
            kept.look(state, ShellPartners{});
            anew.look(state, ShellPartners{});
            std::vector<ContactTerm> of_kept;
            std::vector<ContactTerm> of_new;
            kept.terms(points_of(flat(state)), of_kept);
            anew.terms(points_of(flat(state)), of_new);
            REQUIRE(of_new.size() > 50);
            CHECK(kept.links(HUGE_VAL) == anew.links(HUGE_VAL));
            CHECK(forces_of(of_kept, 2 * state.position.size()) == forces_of(of_new, 2 * state.position.size()));
        }
    }

    TEST_CASE("where nodes go little, layers are met that are near, and a node that goes farther is told") {
        const ShellModel model = scenes::flat_strip(12.0, 1.0, 0.2, 40, 2);
        const ShellState state = scenes::rolled_strip(model, 0.8, 0.19);
        constexpr double way = 0.02;
        ShellContacts all(model);
        ShellContacts near(model);
        all.look(state, ShellPartners{});
        near.look(state, ShellPartners{}, std::vector<double>(state.position.size(), way));
        REQUIRE(all.links(2.0 * way).size() > 50);
        CHECK(near.links(2.0 * way) == all.links(2.0 * way));
        CHECK(near.links(HUGE_VAL) == near.links(2.0 * way));
        CHECK(all.links(HUGE_VAL).size() > near.links(HUGE_VAL).size());
        std::vector<Vec3> gone = state.position;
        for (Vec3& place : gone) {
            place += Vec3(0.09, 0.0, 0.05);  // as a whole
        }
        CHECK_FALSE(near.went_too_far(state.position, gone));
        gone[7].z() += 1.2 * way;
        CHECK(near.went_too_far(state.position, gone));
        CHECK_FALSE(all.went_too_far(state.position, gone));
    }

    TEST_CASE("an edge that comes sideways meets a plane with its face, whatever the mesh") {
        const auto stiffness = [](int along, int across) {
            const ShellModel model = scenes::flat_strip(2.0, 1.0, 0.2, along, across);
            const PlaneModel plane{Vec3(-0.095, 0.0, 0.0), Vec3::UnitX(), 0.0};  // the end has sunk in beyond the onset
            ShellPartners partners;
            partners.planes = {&plane, 1};
            const ShellState state = rest_state(model);
            ShellContacts contacts(model, {.onset = 0.01});
            contacts.look(state, partners);
            std::vector<ContactTerm> terms;
            contacts.terms(points_of(flat(state)), terms);
            double sum = 0.0;
            for (const ContactTerm& term : terms) {
                sum += term.stiffness(0, 0);
            }
            return sum;
        };
        const double face = ShellContactSettings{}.stiffer * 1e6 / 0.2 * (1.0 * 0.2);
        CHECK(stiffness(8, 4) > face);  // a corner counts both its sides
        CHECK(stiffness(8, 4) < 1.2 * face);
        CHECK(stiffness(32, 16) == doctest::Approx(face).epsilon(0.05));
    }
}

TEST_SUITE("shell pressed") {
    TEST_CASE("a plane that lifts the end of a strip feels a cantilever's force") {
        ShellModel model = scenes::flat_strip(10.0, 1.0, 0.2, 40, 2);
        scenes::hold_line(model, 0.0);
        const double lift = 0.1;
        const double bending = model.material.young_modulus * 0.008 / 12.0;
        scenes::TouchingShell shell(model);
        PlaneModel plane{Vec3(0.0, 0.0, -0.1), Vec3::UnitZ(), 0.0};
        ShellPartners partners;
        partners.planes = {&plane, 1};
        partners.layers = false;
        // under the free end only: the plane is tilted as the strip's end is not
        plane.normal = Vec3(-0.05, 0.0, 1.0).normalized();
        for (int i = 1; i <= 60; ++i) {
            const double height = lift * std::min(1.0, i / 20.0);
            plane.point = Vec3(10.0, 0.0, height) - 0.1 * plane.normal;
            const ImplicitReport report = shell.step(partners, {}, Vec3::Zero(), 0.05);
            CHECK(report.converged);
        }
        const double expected = 3.0 * bending * lift / 1000.0;
        const double up = shell.contacts.force_of(ContactPartner::plane, 0).dot(plane.normal);
        CHECK(up == doctest::Approx(expected).epsilon(0.02));
        CHECK(shell.contacts.deepest() < 0.05);
    }

    TEST_CASE("forceps that lift the end of a strip bear a guided beam's force until it slips, and let it go") {
        const double length = 3.0;
        const double lift = 0.1;
        const double bending = 1e6 * (1.0 * 0.008 / 12.0);
        const double free = length - 0.6;  // the jaws turn what they hold as little as they let it go
        const double beam = 12.0 * bending * lift / (free * free * free);         // one guided at its end [uN]
        const double hinged = 3.0 * bending * lift / (length * length * length);  // free to turn where it is held
        for (const double hold : {1e9, 0.5 * hinged}) {
            ShellModel model = scenes::flat_strip(length, 1.0, 0.2, 24, 8);
            scenes::hold_line(model, 0.0);
            model.damping_mass = 20.0;
            scenes::TouchingShell shell(model);
            const ToolModel tool = scenes::forceps(0.6, hold);
            const auto step = [&](double from, double to, double previous_jaw, double jaw) {
                ToolState now = scenes::moving_tool(Vec3(length, 0.5, from), Vec3(length, 0.5, to));
                now.previous_jaw = previous_jaw;
                now.jaw = jaw;
                ShellPartners partners;
                partners.tools = {&tool, 1};
                partners.tool_states = {&now, 1};
                partners.layers = false;
                shell.step(partners, {}, Vec3::Zero(), 10.0);
                return -shell.contacts.force_of(ContactPartner::jaws, 0).z();
            };
            const auto end = [&] { return shell.state.position.back().z(); };
            CHECK(step(0.0, 0.0, 1.0, 1.0) == 0.0);
            CHECK(step(0.0, 0.5 * lift, 1.0, 0.0) < 0.0);
            const double force = -step(0.5 * lift, lift, 0.0, 0.0);
            if (hold > hinged) {
                CHECK(end() == doctest::Approx(lift).epsilon(0.02));
                CHECK(force == doctest::Approx(beam).epsilon(0.1));
            } else {
                CHECK(force <= hold * (1.0 + 1e-6));
                CHECK(force > 0.9 * hold);
                CHECK(end() < 0.8 * lift);
            }
            CHECK(step(lift, lift, 0.0, 1.0) == 0.0);
            CHECK(std::abs(end()) < 1e-3);
            CHECK(shell.state.touches.empty());
        }
    }

    TEST_CASE("a patch on a plane sticks below tan and slides above, whatever its heading") {
        const double mu = 0.3;
        ShellModel model = scenes::flat_strip(1.0, 1.0, 0.1, 4, 4);
        PlaneModel plane{Vec3(0.0, 0.0, -0.05), Vec3::UnitZ(), mu};
        ShellPartners partners;
        partners.planes = {&plane, 1};
        for (const double heading : {0.0, 0.7}) {
            for (const double share : {0.99, 1.01}) {
                scenes::TouchingShell shell(model);
                shell.settings.newton_tolerance = 1e-9;
                const double g = 9810.0;
                const Vec3 gravity =
                    g * Vec3(share * mu * std::cos(heading), share * mu * std::sin(heading), -1.0).normalized();
                const double along = gravity.head<2>().norm();
                CHECK(shell.step(partners, {}, gravity.z() * Vec3::UnitZ(), 1.0).converged);  // sinks in
                for (Vec3& v : shell.state.velocity) {
                    v.setZero();
                }
                for (int i = 0; i < 40; ++i) {
                    CHECK(shell.step(partners, {}, gravity, 1e-3).converged);
                }
                const double speed = shell.state.velocity[12].head<2>().norm();
                const double surplus = (along - mu * std::abs(gravity.z())) * 0.04;
                if (share < 1.0) {
                    CHECK(speed < 1e-6 * std::abs(surplus));
                } else {
                    CHECK(speed == doctest::Approx(surplus).epsilon(1e-3));
                }
            }
        }
    }
}

TEST_SUITE("shell contact motion") {
    TEST_CASE("a roll pressed between planes keeps its layers apart") {
        ShellModel model = scenes::flat_strip(14.0, 0.6, 0.2, 56, 2);
        model.mesh.nodes = scenes::rolled_strip(model, 1.0, 0.22).position;  // at rest so
        model.damping_mass = 20.0;
        model.friction = 0.0;
        scenes::TouchingShell shell(model);
        shell.settings.most_travel = 0.1;
        shell.settings.force_tolerance = 1.0;
        Box box;
        for (const Vec3& x : shell.state.position) {
            box.add(x, 0.1);
        }
        for (int i = 1; i <= 8; ++i) {
            const double press = 0.02 * i;
            const PlaneModel planes[2] = {{Vec3(0.0, 0.0, box.low.z() + press), Vec3::UnitZ(), 0.0},
                                          {Vec3(0.0, 0.0, box.high.z() - press), -Vec3::UnitZ(), 0.0}};
            ShellPartners partners;
            partners.planes = planes;
            const ImplicitReport report = shell.step(partners, {}, Vec3::Zero(), 5e-3);
            CHECK(report.converged);
            CHECK(shell.contacts.deepest() < 0.05);
        }
        CHECK(shell.contacts.touching() > 30);
        CHECK(shell.contacts.force_of(ContactPartner::plane, 0).z() > 50.0);
        CHECK(shell.contacts.force_of(ContactPartner::layer, 0).norm() > 0.0);
    }

    TEST_CASE("jaws closed on a strip by less than it is thick stay apart by force, not by throwing it out (T12)") {
        ShellModel model = scenes::flat_strip(3.0, 1.0, 0.2, 12, 4);
        scenes::hold_line(model, 0.0);
        model.damping_mass = 20.0;
        scenes::TouchingShell shell(model);
        shell.settings.most_travel = 0.1;
        shell.settings.newton_tolerance = 1e-4;
        const ToolModel jaws[2] = {scenes::rod(0.2, 1.0), scenes::rod(0.2, 1.0)};
        double last = 0.0;
        for (int i = 1; i <= 20; ++i) {
            const auto apart = [](int n) { return 0.31 - 0.001 * std::min(n, 15); };  // to 0.295: 0.005 into each side
            const ToolState now[2] = {scenes::moving_tool(Vec3(2.0, 0.5, apart(i - 1)), Vec3(2.0, 0.5, apart(i))),
                                      scenes::moving_tool(Vec3(2.0, 0.5, -apart(i - 1)), Vec3(2.0, 0.5, -apart(i)))};
            ShellPartners partners;
            partners.tools = jaws;
            partners.tool_states = now;
            CHECK(shell.step(partners, {}, Vec3::Zero(), 1e-3).converged);
            last = shell.contacts.force_of(ContactPartner::tool, 1).z();
        }
        CHECK(last > 100.0);
        CHECK(shell.contacts.force_of(ContactPartner::tool, 0).z() == doctest::Approx(-last).epsilon(1e-3));
        CHECK(shell.state.position.back().z() < 0.01);
    }

    TEST_CASE("a rod at 1 m/s pushes a strip before it and does not pass through (T11)") {
        ShellModel model = scenes::flat_strip(4.0, 1.0, 0.2, 16, 4);
        model.damping_mass = 1000.0;  // it does not fly off
        ShellStepper stepper = std::move(ShellStepper::create(model)).value();
        ShellContacts contacts(model);
        const ToolModel tool = scenes::rod(0.2, 1.0);
        const ToolState pose = scenes::moving_tool(Vec3(2.0, 0.5, -1.0), Vec3(2.0, 0.5, 9.0));
        ShellPartners partners;
        partners.tools = {&tool, 1};
        partners.tool_states = {&pose, 1};
        ShellState next;
        ShellStepReport report;
        int rollbacks = 0;
        const ShellState start = rest_state(model);
        const ShellMotion motion =
            move_shell(stepper, contacts, {start, partners, Vec3::Zero(), 0.01}, next, report, rollbacks);
        double nearest = HUGE_VAL;
        for (const Vec3& x : next.position) {
            nearest = std::min(nearest, std::hypot(x.x() - 2.0, x.z() - 9.0));
        }
        CHECK(motion == ShellMotion::balanced);
        CHECK(nearest > 0.3 - 0.05 * 0.2);
        CHECK(next.position[next.position.size() / 2].z() > 9.2);
    }

    TEST_CASE("a bent strip pushed out of a tube leaves it and springs open") {
        ShellModel model = scenes::flat_strip(2.0, 2.4, 0.1, 8, 12);
        model.damping_mass = 50.0;
        scenes::TouchingShell shell(model);
        shell.settings.most_travel = 0.05;
        shell.settings.newton_tolerance = 1e-4;
        // bent about x to an arc in the bore, whose axis is x
        const double radius = 0.9;
        for (std::size_t n = 0; n < shell.state.position.size(); ++n) {
            const Vec3& rest = model.mesh.nodes[n];
            const double angle = (rest.y() - 1.2) / radius;
            shell.state.position[n] = Vec3(rest.x(), radius * std::sin(angle), -radius * std::cos(angle));
            shell.state.rotation[n] = Quat(Eigen::AngleAxisd(angle, Vec3::UnitX()));
        }
        TubeModel tube;
        tube.pose.orientation = Quat(Eigen::AngleAxisd(M_PI / 2.0, Vec3::UnitY()));
        tube.stations = {{2.2, 1.0, 1.0}};
        tube.friction = 0.0;
        ShellPartners partners;
        partners.tubes = {&tube, 1};
        partners.layers = false;
        ShellLoad push;
        push.force.assign(model.mesh.nodes.size(), Vec3::Zero());
        double deepest = 0.0;
        double width_in = 0.0;
        for (int i = 0; i < 100; ++i) {
            for (Vec3& f : push.force) {
                f.x() = i < 50 ? 0.0 : 3.0;
            }
            CHECK(shell.step(partners, push, Vec3::Zero(), 5e-4).converged);
            deepest = std::max(deepest, shell.contacts.deepest());
            if (i == 49) {
                for (const Vec3& x : shell.state.position) {
                    width_in = std::max(width_in, x.y());
                }
            }
        }
        CHECK(deepest < 0.05);
        CHECK(width_in < 1.0);
        CHECK(shell.contacts.touching() == 0);
        CHECK(std::abs(shell.state.position[0].y()) > 1.15);  // half its width is 1.2
    }
}
