// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/contact_scenes.hpp"

#include <algorithm>
#include <cmath>

#include "eye/make_eye.hpp"
#include "mesh/shapes.hpp"
#include "scenes/bodies.hpp"
#include "tools/instruments.hpp"
#include "tools/probe.hpp"

namespace rhexis::scenes {

namespace {

Physics make_physics(const std::shared_ptr<const WorldModel>& model, const PhysicsSettings& settings) {
    Result<Physics> made = Physics::create(model, settings);
    if (!made) {
        assertion_failed(made.error().text().c_str(), __FILE__, __LINE__);
    }
    return std::move(made).value();
}

}  // namespace

Scene::Scene(WorldModel world, const PhysicsSettings& settings)
    : model(std::make_shared<const WorldModel>(std::move(world))),
      state(rest_state(*model)),
      tools(model->tools.size()),
      physics_(make_physics(model, settings)) {}

void Scene::place_tool(int tool, const Pose& pose) {
    tools[tool] = ToolState{};
    tools[tool].present = true;
    tools[tool].pose = pose;
    tools[tool].previous_pose = pose;
}

void Scene::move_tool(int tool, const Pose& pose) { tools[tool].pose = pose; }

void Scene::step(double dt) {
    outcome = physics_.advance(state, tools, dt, next_, contacts, profile);
    std::swap(state, next_);
    rollbacks += outcome.rollbacks;
    for (ToolState& tool : tools) {
        tool.previous_pose = tool.pose;
    }
}

Vec3 Scene::tool_force(int tool) const {
    Vec3 sum = Vec3::Zero();
    for (const Contact& contact : contacts) {
        if (contact.partner == ContactPartner::tool && contact.partner_index == tool) {
            sum -= contact.force;
        }
    }
    return sum;
}

Vec3 Scene::force_from(ContactPartner partner) const {
    Vec3 sum = Vec3::Zero();
    for (const Contact& contact : contacts) {
        sum += contact.partner == partner ? contact.force : Vec3::Zero();
    }
    return sum;
}

double Scene::penetration() const {
    double deepest = 0.0;
    for (const Contact& contact : contacts) {
        deepest = std::max(deepest, -contact.gap);
    }
    return deepest;
}

double Scene::speed() const {
    double fastest = 0.0;
    for (const Vec3& velocity : state.solids[0].velocity) {
        fastest = std::max(fastest, velocity.norm());
    }
    return fastest;
}

Vec3 Scene::centre() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& position : state.solids[0].position) {
        sum += position;
    }
    return sum / static_cast<double>(state.solids[0].position.size());
}

double Scene::kinetic() const { return outcome.solids[0].kinetic_energy; }

double Scene::elastic() const { return outcome.solids[0].elastic_energy; }

Pose pose_at(const Vec3& position) {
    Pose pose;
    pose.position = position;
    return pose;
}

WorldModel cube_on_slope(double slope, double heading, double friction, Advance advance, int cells) {
    WorldModel model;
    SolidModel solid = cube(cells, 1.0, 5000.0, 0.3);
    for (Vec3& node : solid.coarse.nodes) {
        node.z() += 0.5;
    }
    solid.advance = advance;
    solid.damping_mass = 0.0;
    solid.damping_stiffness = 1e-4;
    model.solids.push_back(solid);
    PlaneModel plane;
    plane.friction = friction;
    model.planes.push_back(plane);
    model.gravity =
        9810.0 * Vec3(std::sin(slope) * std::cos(heading), std::sin(slope) * std::sin(heading), -std::cos(slope));
    return model;
}

WorldModel ball_on_block(int n, double size, double centre, double young_modulus, double poisson_ratio, double radius,
                         Advance advance) {
    TetMesh mesh = bar(2 * n, 2 * n, n, 1.0 / n, Vec3(-1.0, -1.0, -1.0));
    for (Vec3& node : mesh.nodes) {
        for (double& x : node) {
            const double share = std::abs(x);
            x = std::copysign(size * (centre * share + (1.0 - centre) * share * share * share * share), x);
        }
    }
    WorldModel model;
    SolidModel solid = body("block", std::move(mesh), young_modulus, poisson_ratio);
    solid.fixed_nodes = nodes_on_plane(solid.coarse, Vec3(0.0, 0.0, -size), Vec3::UnitZ());
    solid.advance = advance;
    solid.damping_mass = 50.0;
    model.solids.push_back(std::move(solid));
    model.tools.push_back(probe(radius, 0.0));
    model.tools[0].friction = 0.0;
    model.gravity.setZero();
    return model;
}

WorldModel lens_in_bag(const char* tool, Advance advance, int tetrahedra, double grade) {
    Patient patient;
    patient.tetrahedra = tetrahedra;
    patient.nuclear_grade = grade;
    EyeModel eye = make_eye(patient).value();
    eye.lens.advance = advance;
    WorldModel model;
    model.solids.push_back(std::move(eye.lens));
    model.bags.push_back(std::move(eye.bag));
    model.tools.push_back(make_tool(tool).value());
    return model;
}

}  // namespace rhexis::scenes
