// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/bag_injection.hpp"

#include <algorithm>
#include <utility>

#include "session/build_world.hpp"
#include "session/implant_fold.hpp"

namespace rhexis::scenes {
namespace {

constexpr double plunger_speed = 5.0;    // [mm/s]
const Vec3 mouth_place(0.0, -1.0, 1.2);  // in the near half of the opening [mm]

SceneDescription bag_scene(const BagInjectionCase& own) {
    SceneDescription scene;
    scene.tissues = {"implant", "bag", "viscoelastic"};
    scene.instruments = {"injector"};
    scene.settings = {{"bag.triangles", own.bag}, {"implant.triangles", own.implant}, {"cartridge.tucked", 0.0}};
    return scene;
}

ShellState folded_for(const SceneDescription& scene) {
    ImplantFold fold = std::move(ImplantFold::create(folding_scene(scene.settings))).value();
    while (!fold.done() && fold.step()) {
    }
    return std::move(fold.result()).value().snapshot.world.shells[0];
}

/// The shaft rises by 25 degrees towards the surgeon.
Quat held_shaft() {
    Mat3 axes;
    axes.col(0) = Vec3::UnitX();
    axes.col(2) = Vec3(0.0, -0.9063, 0.4226).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return Quat(axes).normalized();
}

PhysicsSettings bag_settings(const BagInjectionCase& own) {
    PhysicsSettings settings;
    settings.shell_contact = own.contact;
    return settings;
}

}  // namespace

BagInjection::BagInjection(const BagInjectionCase& own)
    : model(std::move(build_world(bag_scene(own))).value().world),
      own_(own),
      physics_(std::move(Physics::create(model, bag_settings(own))).value()) {
    state = rest_state(*model);
    state.shells[0] = folded_for(bag_scene(own));
    hand.present = true;
    hand.pose = {mouth_place, held_shaft()};
    hand.previous_pose = hand.pose;
    pushing_ = static_cast<int>(model->tools[0].cartridge->stroke / plunger_speed / own.dt) + 1;
    steps_ = pushing_ + static_cast<int>(own.unfolding / own.dt);
}

StepOutcome BagInjection::step() {
    hand.previous_jaw = hand.jaw;
    hand.jaw = std::min(1.0, hand.jaw + 1.0 / pushing_);
    WorldState next;
    ContactSet contacts;
    Profile profile;
    StepOutcome outcome = physics_.advance(state, {&hand, 1}, own_.dt, next, contacts, profile);
    before = std::exchange(state, std::move(next));
    return outcome;
}

}  // namespace rhexis::scenes
