// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "base/profile.hpp"
#include "mesh/shapes.hpp"
#include "physics/physics.hpp"
#include "scenes/membranes.hpp"

using namespace rhexis;

namespace {

ToolModel ball(double radius, double friction) {
    ToolModel tool;
    tool.name = "ball";
    tool.parts = {{Vec3::Zero(), Vec3::Zero(), radius, radius}};
    tool.friction = friction;
    return tool;
}

/// A world of one membrane and one ball, stepped.
class Scene {
public:
    Scene(MembraneModel membrane, const ToolModel& tool, const Vec3& place, const PhysicsSettings& settings = {}) {
        WorldModel world;
        world.gravity = Vec3::Zero();
        world.membranes.push_back(std::move(membrane));
        world.tools.push_back(tool);
        model_ = std::make_shared<const WorldModel>(std::move(world));
        physics_.emplace(std::move(Physics::create(model_, settings)).value());
        state = rest_state(*model_);
        tools_.resize(1);
        tools_[0].present = true;
        tools_[0].pose.position = tools_[0].previous_pose.position = place;
    }

    StepOutcome step(const Vec3& place) {
        tools_[0].previous_pose = tools_[0].pose;
        tools_[0].pose.position = place;
        const StepOutcome outcome = physics_->advance(state, tools_, 0.01, next_, contacts_, profile_);
        std::swap(state, next_);
        return outcome;
    }

    /// On the sheet.
    [[nodiscard]] Vec3 force() const {
        Vec3 sum = Vec3::Zero();
        for (const Contact& contact : contacts_) {
            CHECK(contact.membrane == 0);
            sum += contact.force;
        }
        return sum;
    }

    [[nodiscard]] const ContactSet& contacts() const { return contacts_; }

    WorldState state;

private:
    std::shared_ptr<const WorldModel> model_;
    std::optional<Physics> physics_;
    std::vector<ToolState> tools_;
    WorldState next_;
    ContactSet contacts_;
    Profile profile_;
};

/// A round sheet held at its rim and stretched by so much.
MembraneModel drum(double stretch) {
    MembraneModel model = scenes::membrane("drum", round_sheet(4.0, 1500), isotropic(1e6, 0.3));
    MembraneSheet sheet = *model.sheet;
    for (Vec3& x : sheet.mesh.nodes) {
        x /= 1.0 + stretch;
    }
    model.sheet = std::make_shared<const MembraneSheet>(sheet);
    model.damping_mass = 200.0;
    for (int n = 0; n < static_cast<int>(sheet.mesh.nodes.size()); ++n) {
        if (sheet.mesh.nodes[at(n)].norm() * (1.0 + stretch) > 3.999) {
            model.fixed_nodes.push_back(n);
        }
    }
    return model;
}

}  // namespace

TEST_SUITE("sheet contact") {
    TEST_CASE("a ball pressed into a taut drum: the deflection of theory") {
        // small indent of a membrane of tension T: F = 2 pi T d / ln(R / c), c the radius of contact
        const double stretch = 0.1;
        Scene scene(drum(stretch), ball(0.5, 0.0), Vec3(0.0, 0.0, 0.6));
        for (Vec3& x : scene.state.membranes[0].position) {
            x *= 1.0 + stretch;
        }
        double depth = -0.05;
        for (int i = 0; i < 150; ++i) {
            depth = std::min(0.1, depth + 0.002);
            scene.step(Vec3(0.0, 0.0, 0.5 - depth));
        }
        const double tension = 1e6 / (1.0 - 0.3) * stretch * 0.01 / (1.0 + stretch);
        double middle = 0.0;
        for (const Vec3& x : scene.state.membranes[0].position) {
            middle = std::min(middle, x.z());
        }
        const double force = -scene.force().z();
        // under the ball the sheet follows it: F = 2 pi T c (c / r) there, and the catenary outside
        const double contact = std::sqrt(force * 0.5 / (2.0 * M_PI * tension));
        const double expected = force / (2.0 * M_PI * tension) * (std::log(4.0 / contact) + 0.5);
        CHECK(-middle == doctest::Approx(expected).epsilon(0.1));
        CHECK(-middle == doctest::Approx(depth).epsilon(0.15));
    }

    TEST_CASE("a thin tool between the nodes does not pass; a fast one neither") {
        for (const double speed : {5.0, 100.0}) {
            Scene scene(drum(0.05), ball(0.1, 0.2), Vec3(0.07, 0.11, 0.3));
            for (Vec3& x : scene.state.membranes[0].position) {
                x *= 1.05;
            }
            double z = 0.3;
            while (z > -0.7) {
                z -= 0.01 * speed;
                scene.step(Vec3(0.07, 0.11, z));
            }
            double lowest = 0.0;
            for (const Vec3& x : scene.state.membranes[0].position) {
                CHECK(x.allFinite());
                lowest = std::min(lowest, x.z());
            }
            CHECK(lowest < z + 0.3);
            CHECK(scene.force().z() < 0.0);
        }
    }

    TEST_CASE("a step that comes nowhere near to balance is made again in smaller ones, and one that does is not") {
        PhysicsSettings hasty;
        hasty.membranes.max_newton = 2;
        for (const bool thrown : {false, true}) {
            CAPTURE(thrown);
            Scene scene(drum(0.1), ball(0.5, 0.0), Vec3(0.0, 0.0, 0.6), hasty);
            for (Vec3& x : scene.state.membranes[0].position) {
                x *= 1.1;
            }
            if (thrown) {
                for (Vec3& v : scene.state.membranes[0].velocity) {
                    v = Vec3(0.0, 0.0, 300.0);
                }
            }
            const StepOutcome outcome = scene.step(Vec3(0.0, 0.0, 0.6));
            CHECK((outcome.rollbacks > 0) == thrown);
            CHECK((outcome.membranes[0].substeps > 1) == thrown);
            CHECK(outcome.notes.size() == (thrown ? 1 : 0));
            CHECK(outcome.membranes[0].force < 1e3);
        }
    }

    TEST_CASE("friction drags a loose sheet along, and lets it go at Coulomb's limit") {
        MembraneModel sheet = scenes::membrane("sheet", square_sheet(2.0, 200), isotropic(1e6, 0.3));
        scenes::hold(sheet, scenes::nodes_at(sheet.sheet->mesh, 0, 0.0), scenes::nodes_at(sheet.sheet->mesh, 0, 2.0));
        sheet.damping_mass = 200.0;
        Scene scene(sheet, ball(0.3, 0.3), Vec3(1.0, 1.0, 0.3));
        for (int i = 0; i < 40; ++i) {
            scene.step(Vec3(1.0, 1.0, 0.3 - 0.005 * i));
        }
        const Vec3 pressed = scene.force();
        CHECK(pressed.z() < -10.0);
        double dragged = 0.0;
        for (int i = 0; i < 60; ++i) {
            scene.step(Vec3(1.0, 1.0 + 0.01 * i, 0.105));
            dragged = std::max(dragged, scene.force().y());
            for (const Contact& contact : scene.contacts()) {
                const double pressed_on = contact.force.dot(contact.normal);
                CHECK((contact.force - pressed_on * contact.normal).norm() <= 0.3 * pressed_on * 1.05 + 1.0);
            }
        }
        CHECK(dragged > 10.0);
    }

    TEST_CASE("a sheet lies on the body under it") {
        MembraneModel sheet = scenes::membrane("sheet", round_sheet(3.0, 600), isotropic(1e6, 0.3));
        sheet.support = SupportModel{{4.6, 1.9, 2.7}, 0.05};
        sheet.damping_mass = 200.0;
        MembraneSheet raised = *sheet.sheet;
        for (Vec3& x : raised.mesh.nodes) {
            x.z() = 1.95;
        }
        sheet.sheet = std::make_shared<const MembraneSheet>(raised);
        Scene scene(sheet, ball(0.1, 0.0), Vec3(0.0, 0.0, 5.0));
        std::vector<int> all;
        for (int n = 0; n < static_cast<int>(raised.mesh.nodes.size()); ++n) {
            all.push_back(n);
        }
        scene.state.membranes[0].loads.push_back({all, Vec3(0.0, 0.0, -2000.0)});
        for (int i = 0; i < 150; ++i) {
            CHECK(scene.step(Vec3(0.0, 0.0, 5.0)).failure == StepFailure::none);
        }
        for (const Vec3& x : scene.state.membranes[0].position) {
            const double gap = bag_distance(sheet.support->shape, x).distance;
            CHECK(gap > -0.02);
            CHECK(gap < 0.3);
        }
        CHECK(scene.force().z() == doctest::Approx(2000.0).epsilon(0.05));
    }
}
