// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/capsule_scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"
#include "eye/anatomy.hpp"
#include "eye/capsular_bag.hpp"
#include "topology/tear.hpp"

namespace rhexis::scenes {
namespace {

constexpr double lens_mass = 0.2;  // only scales the bag's damping

HalfEllipsoids lens_at(double age) {
    Patient patient;
    patient.age = age;
    return lens_shape(patient);
}

}  // namespace

CapsuleScene::CapsuleScene(double age, const AnteriorCapsuleSettings& settings, std::vector<ToolModel> tools,
                           bool layers, double step_s, const PhysicsSettings& physics)
    : lens_(lens_at(age)), step_s_(step_s), tools_(tools.size()) {
    WorldModel world;
    world.membranes.push_back(make_anterior_capsule(lens_, make_bag(lens_, lens_mass, age), age, settings));
    world.membranes[0].layer_distance = layers ? world.membranes[0].layer_distance : 0.0;
    world.tools = std::move(tools);
    world_ = std::make_shared<const WorldModel>(std::move(world));
    physics_ = std::make_unique<Physics>(std::move(Physics::create(world_, physics)).value());
    state_ = rest_state(*world_);
}

Vec3 CapsuleScene::front(double x, double y) const { return {x, y, anterior_z(lens_, std::hypot(x, y))}; }

bool CapsuleScene::step() {
    const StepOutcome outcome = physics_->advance(state_, tools_, step_s_, next_, contacts_, profile_);
    std::swap(state_, next_);
    if (watch) {
        watch(next_.membranes[0], state_.membranes[0]);
    }
    force_.setZero();
    for (const Contact& contact : contacts_) {
        force_ += contact.partner == ContactPartner::tool ? contact.force : Vec3(Vec3::Zero());
    }
    greatest_force = std::max(greatest_force, force_.norm());
    const int proposed = static_cast<int>(outcome.membranes[0].punctures.size());
    force_of_puncture = punctures == 0 && proposed > 0 ? force_.norm() : force_of_puncture;
    punctures += proposed;
    carry_out(world_->membranes[0], outcome.membranes[0], state_.membranes[0]);
    for (ToolState& tool : tools_) {
        tool.previous_pose = tool.pose;
        tool.previous_jaw = tool.jaw;
    }
    return outcome.failure == StepFailure::none;
}

void CapsuleScene::settle(int steps) {
    for (int i = 0; i < steps; ++i) {
        step();
    }
}

void CapsuleScene::put(int tool, const Vec3& place, double jaw) {
    ToolState& own = tools_[at(tool)];
    own.present = true;
    own.pose.position = own.previous_pose.position = place;
    own.jaw = own.previous_jaw = jaw;
}

bool CapsuleScene::lead(int tool, const Vec3& to, double speed, double jaw) {
    ToolState& own = tools_[at(tool)];
    const Vec3 from = own.pose.position;
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / (speed * step_s_))));
    bool good = true;
    for (int i = 1; i <= steps; ++i) {
        own.pose.position = from + (to - from) * (static_cast<double>(i) / steps);
        own.jaw = jaw;
        good = step() && good;
    }
    return good;
}

void CapsuleScene::open_flap(double inside, double radius, double angle) {
    MembraneState& sheet = state_.membranes[0];
    const Vec3 start = front(radius - 0.5 * inside, 0.0);
    Result<MembraneEdit> edit =
        puncture(model(), sheet, nearest_triangle(sheet.sheet->mesh, start), start, Vec3::UnitX());
    int node = -1;
    while (edit.ok()) {
        sheet = applied(sheet, edit.value());
        const std::vector<Vec3>& nodes = sheet.sheet->mesh.nodes;
        // after the first edit the tip that is farther out leads
        const auto leading = std::max_element(
            sheet.tips.begin(), sheet.tips.end(),
            [&](const TearTip& a, const TearTip& b) { return nodes[at(a.node)].x() < nodes[at(b.node)].x(); });
        node = node < 0 ? leading->node : sheet.tips.back().node;
        const Vec3& here = nodes[at(node)];
        const double next = std::atan2(here.y(), here.x()) + 0.12;
        if (next > angle) {
            return;
        }
        const auto tip = std::find_if(sheet.tips.begin(), sheet.tips.end(),
                                      [node](const TearTip& other) { return other.node == node; });
        edit = tear(model(), sheet, static_cast<int>(tip - sheet.tips.begin()),
                    front(radius * std::cos(next), radius * std::sin(next)) - here);
    }
}

}  // namespace rhexis::scenes
