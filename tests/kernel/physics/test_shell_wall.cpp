// SPDX-License-Identifier: GPL-3.0-or-later
// A shell and a membrane that it touches, solved together.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "mesh/shapes.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "physics/shell/shell_body.hpp"
#include "physics/shell/shell_carry.hpp"
#include "physics/shell/shell_motion.hpp"
#include "physics/solve/paired_body.hpp"
#include "scenes/membranes.hpp"
#include "scenes/shell_contacts.hpp"
#include "support/finite_difference.hpp"

using namespace rhexis;

namespace {

/// A square of 4 mm about the origin at this height, held by its edge.
MembraneModel drum(double height) {
    TriMesh mesh = square_sheet(4.0, 400);
    for (Vec3& node : mesh.nodes) {
        node += Vec3(-2.0, -2.0, height);
    }
    MembraneModel model = scenes::membrane("drum", mesh, isotropic(1e6, 0.4));
    scenes::hold(model, scenes::nodes_at(model.sheet->mesh, 0, -2.0), scenes::nodes_at(model.sheet->mesh, 0, 2.0));
    model.damping_mass = 1e5;
    return model;
}

/// A strip of 1.5 x 1 mm about the origin.
ShellModel plate(double thickness = 0.2) {
    ShellModel model = scenes::flat_strip(1.5, 1.0, thickness, 6, 4);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& node : model.mesh.nodes) {
        middle += node / static_cast<double>(model.mesh.nodes.size());
    }
    for (Vec3& node : model.mesh.nodes) {
        node -= middle;
    }
    return model;
}

VecX flat(const ShellState& shell, const MembraneState& sheet) {
    VecX x = VecX::Zero(static_cast<Eigen::Index>(6 * shell.position.size() + 3 * sheet.position.size()));
    for (std::size_t n = 0; n < shell.position.size(); ++n) {
        x.segment<3>(static_cast<Eigen::Index>(6 * n)) = shell.position[n];
    }
    for (std::size_t n = 0; n < sheet.position.size(); ++n) {
        x.segment<3>(static_cast<Eigen::Index>(6 * shell.position.size() + 3 * n)) = sheet.position[n];
    }
    return x;
}

std::vector<Vec3> points_of(const VecX& x) {
    std::vector<Vec3> points(static_cast<std::size_t>(x.size() / 3));
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = x.segment<3>(static_cast<Eigen::Index>(3 * i));
    }
    return points;
}

struct Pressed {
    WorldModel world;
    ShellModel shell = plate();
    ShellState state;
    MembraneState wall;
    double deepest = 0.0;
    int rough = 0;
};

/// A plate beside a drum, pushed along z for half a second.
Pressed press(double height, double force) {
    Pressed result;
    result.world.membranes.push_back(drum(height));
    result.shell.damping_mass = 1e3;
    result.state = rest_state(result.shell);
    result.wall = rest_state(result.world.membranes[0]);
    std::vector<int> all(result.state.position.size());
    for (std::size_t n = 0; n < all.size(); ++n) {
        all[n] = static_cast<int>(n);
    }
    result.state.loads.push_back({all, Vec3(0.0, 0.0, force)});
    Result<ShellStepper> stepper = ShellStepper::create(result.shell);
    REQUIRE(stepper.ok());
    ShellContacts contacts(result.shell);
    const ShellPartners partners;
    for (int i = 0; i < 100; ++i) {
        ShellState next;
        MembraneState next_wall;
        ContactSet found;
        ShellStepReport report;
        int rollbacks = 0;
        ShellTask task{result.state, partners, Vec3::Zero(), 0.005};
        task.wall.emplace(WallTask{result.world, 0, result.wall, {}, next_wall, found});
        const ShellMotion motion = move_shell(stepper.value(), contacts, task, next, report, rollbacks);
        REQUIRE(motion != ShellMotion::failed);
        result.rough += motion == ShellMotion::rough ? 1 : 0;
        result.deepest = std::max(result.deepest, contacts.deepest());
        result.state = std::move(next);
        result.wall = std::move(next_wall);
    }
    return result;
}

/// Force of the drum on what holds its edges [uN].
double borne(const Pressed& pressed) {
    const MembraneModel& model = pressed.world.membranes[0];
    return elastic_force(model, pressed.wall, model.fixed_nodes).z();
}

}  // namespace

TEST_SUITE("paired body") {
    TEST_CASE("forces and stiffness of two bodies are those of each, in one numbering") {
        const ShellModel shell = plate();
        const MembraneModel sheet = drum(0.5);
        const std::vector<std::array<int, 2>> ties{{0, 3}, {1, 3}, {7, 20}};
        PairedBody pair(std::make_unique<ShellBody>(shell, *shell_kernel::choose({})),
                        std::make_unique<MembraneBody>(sheet, sheet.sheet), ties);
        ShellBody first(shell, *shell_kernel::choose({}));
        MembraneBody second(sheet, sheet.sheet);
        const std::size_t shell_points = 2 * shell.mesh.nodes.size();
        REQUIRE(pair.rows() == first.rows() + second.rows());
        Rng rng(3, "pair");
        std::vector<Vec3> points(shell_points, Vec3::Zero());
        for (std::size_t n = 0; n < shell.mesh.nodes.size(); ++n) {
            points[2 * n] = shell.mesh.nodes[n];
        }
        points.insert(points.end(), sheet.sheet->mesh.nodes.begin(), sheet.sheet->mesh.nodes.end());
        for (Vec3& point : points) {
            point += 0.02 * uniform3(rng);
        }
        const auto rows = [&](const ElasticBody& body, std::size_t offset) {
            std::vector<double> x(3 * static_cast<std::size_t>(body.rows()) + 1, 0.0);
            for (int row = 0; row < body.rows(); ++row) {
                Eigen::Map<Vec3>(x.data() + 3 * row) =
                    points[offset + static_cast<std::size_t>(body.node_of()[static_cast<std::size_t>(row)])];
            }
            return x;
        };
        std::vector<double> both;
        std::vector<double> own;
        BlockValues stiffness = zero_values(pair.pattern());
        pair.forces_and_stiffness(rows(pair, 0), elastic_kernel::Mode::consistent, 1.0, both, stiffness);
        mirror_upper(pair.pattern(), stiffness);
        for (const bool is_first : {true, false}) {
            ElasticBody& body = is_first ? static_cast<ElasticBody&>(first) : second;
            const std::size_t offset = is_first ? 0 : shell_points;
            BlockValues alone = zero_values(body.pattern());
            body.forces_and_stiffness(rows(body, offset), elastic_kernel::Mode::consistent, 1.0, own, alone);
            mirror_upper(body.pattern(), alone);
            for (int i = 0; i < body.rows(); ++i) {
                const auto there = [&](int row) {
                    return pair
                        .row_of()[offset + static_cast<std::size_t>(body.node_of()[static_cast<std::size_t>(row)])];
                };
                CHECK(Eigen::Map<const Vec3>(own.data() + 3 * i) == Eigen::Map<const Vec3>(both.data() + 3 * there(i)));
                for (int slot = body.pattern().first[static_cast<std::size_t>(i)];
                     slot < body.pattern().first[static_cast<std::size_t>(i) + 1]; ++slot) {
                    const int j = body.pattern().column[static_cast<std::size_t>(slot)];
                    CHECK(block_of(alone, slot) == block_of(stiffness, pair.pattern().slot(there(i), there(j))));
                }
            }
        }
        for (const std::array<int, 2>& tie : ties) {
            CHECK(pair.pattern().slot(pair.row_of()[static_cast<std::size_t>(tie[0])],
                                      pair.row_of()[shell_points + static_cast<std::size_t>(tie[1])]) >= 0);
        }
    }
}

TEST_SUITE("shell and membrane") {
    TEST_CASE("without friction forces on both are the gradient of the springs' energy and sum to nothing") {
        const ShellModel shell = plate();
        MembraneModel sheet = drum(0.0);
        sheet.shell_friction = 0.0;
        Rng rng(5, "wall");
        ShellState state = rest_state(shell);
        MembraneState wall = rest_state(sheet);
        for (Vec3& node : wall.position) {
            node.z() = 0.07 + 0.03 * rng.uniform() + (node.x() > 0.3 ? -0.18 : 0.0);  // before it, and behind it
        }
        ShellContacts contacts(shell);
        ShellPartners partners;
        partners.sheet = &wall;
        partners.sheet_model = &sheet;
        contacts.look(state, partners);
        const VecX x = flat(state, wall);
        std::vector<ContactTerm> terms;
        contacts.terms(points_of(x), terms);
        CHECK(terms.size() > 50);
        VecX force = VecX::Zero(x.size());
        for (const ContactTerm& term : terms) {
            for (const ContactShare& share : term.more) {
                force.segment<3>(3 * share.node) += share.share.transpose() * term.force;
            }
        }
        const auto energy = [&](const VecX& there) {
            return VecX(VecX::Constant(1, -contacts.normal_energy(points_of(there))));
        };
        CHECK(rhexis::test::derivative_error(energy, x, force.transpose(), 1e-5) < 1e-6);
        Vec3 on_shell = Vec3::Zero();
        Vec3 on_sheet = Vec3::Zero();
        for (Eigen::Index i = 0; i < x.size() / 3; ++i) {
            const bool of_shell = i < static_cast<Eigen::Index>(2 * state.position.size());
            if (!of_shell) {
                on_sheet += force.segment<3>(3 * i);
            } else if (i % 2 == 0) {
                on_shell += force.segment<3>(3 * i);
            }
        }
        CHECK((on_shell + on_sheet).norm() < 1e-9 * force.norm());
    }

    TEST_CASE(
        "a plate pressed into a drum from either side comes to rest, and the drum bears what it is pressed with") {
        for (const double side : {1.0, -1.0}) {
            CAPTURE(side);
            const Pressed pressed = press(side * 0.15, side * 500.0);
            CHECK(pressed.rough == 0);
            CHECK(pressed.deepest < 0.05);
            CHECK(borne(pressed) == doctest::Approx(side * 500.0).epsilon(1e-3));
            double moved = 0.0;
            for (std::size_t n = 0; n < pressed.wall.position.size(); ++n) {
                moved = std::max(moved, side * (pressed.wall.position[n].z() - side * 0.15));
            }
            CHECK(moved > 0.05);
            CHECK(moved < 1.0);
        }
    }

    TEST_CASE("a membrane that stands on a plate's edge does not slip in between its samples") {
        const ShellModel shell = plate(0.1);
        const ShellState state = rest_state(shell);
        const MembraneModel sheet = drum(0.0);
        const double depth = 0.025;  // half of what the edge sticks out
        double least = HUGE_VAL;
        double most = 0.0;
        for (int i = -20; i <= 20; ++i) {
            MembraneState wall = rest_state(sheet);
            for (Vec3& node : wall.position) {  // upright, at right angles to the plate's edge at x = 0.75
                node = {0.75 + 0.05 - depth + node.x() + 2.0, 0.02 * i, node.y()};
            }
            ShellContacts contacts(shell);
            ShellPartners partners;
            partners.sheet = &wall;
            partners.sheet_model = &sheet;
            contacts.look(state, partners);
            const double stored = contacts.normal_energy(points_of(flat(state, wall)));
            least = std::min(least, stored);
            most = std::max(most, stored);
        }
        CHECK(least > 0.3 * most);
    }

    TEST_CASE("a drum that nothing touches stays as it was") {
        const Pressed pressed = press(1.0, 0.0);
        CHECK(borne(pressed) == doctest::Approx(0.0));
        CHECK(pressed.wall.position == rest_state(pressed.world.membranes[0]).position);
    }
}

TEST_SUITE("shell in a tube that is moved") {
    TEST_CASE(
        "it begins a step with the tube's motion in place of its own as a rigid body, and keeps what it does in it") {
        const ShellModel model = plate();
        ShellState state = rest_state(model);
        const Vec3 spin(0.1, -0.2, 0.3);
        for (std::size_t n = 0; n < state.position.size(); ++n) {
            state.velocity[n] = Vec3(5.0, 2.0, -1.0) + spin.cross(state.position[n]);
            state.spin[n] = spin;
        }
        TubeModel tube;
        tube.stations = {{-5.0, 2.0, 2.0}, {5.0, 2.0, 2.0}};
        ToolState carrier;
        carrier.present = true;
        carrier.previous_pose.position = Vec3::Zero();
        carrier.pose.position = Vec3(0.02, 0.0, -0.01);
        ShellPartners partners;
        partners.tubes = {&tube, 1};
        partners.tube_states = {&carrier, 1};
        const int plunger = 0;
        ToolState pushed;
        partners.tool_states = {&pushed, 1};
        CHECK(carried_velocity(state, partners, 0.01).empty());  // nobody says what pushes in it
        partners.tube_tools = {&plunger, 1};
        const std::vector<Vec3> guess = carried_velocity(state, partners, 0.01);
        REQUIRE(guess.size() == 2 * state.position.size());
        for (std::size_t n = 0; n < state.position.size(); ++n) {
            CHECK((guess[2 * n] - Vec3(2.0, 0.0, -1.0)).norm() < 1e-6);
            CHECK(guess[2 * n + 1].norm() < 1e-6);
        }
        tube.stations = {{-5.0, 2.0, 2.0}, {-4.0, 2.0, 2.0}};  // it is out
        CHECK(carried_velocity(state, partners, 0.01).empty());
    }
}
