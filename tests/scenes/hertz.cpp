// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/contact_scenes.hpp"

namespace rhexis::scenes {
namespace {

constexpr double patches = 8.0;      ///< size of the block in radii of the patch
constexpr double centre = 0.2;       ///< size of the cells at the middle, share of the mean
constexpr double contact_dt = 1e-3;  ///< [s], where contacts are as stiff as they get
constexpr double density = 1e-5;     ///< [g/mm^3]: so light that a step outlasts every wave
constexpr int steps = 12;

/// Displacement of a half-space below z = 0 under a force pressing down at the origin.
Vec3 boussinesq(const HertzCase& problem, double force, const Vec3& place) {
    const double nu = problem.poisson_ratio;
    const double shear = problem.young_modulus / (2.0 * (1.0 + nu));
    const double depth = -place.z();
    const double aside = place.head<2>().norm();
    const double distance = std::max(place.norm(), problem.patch());
    const double scale = force / (4.0 * std::numbers::pi * shear);
    const double out =
        scale * (depth * aside / std::pow(distance, 3) - (1.0 - 2.0 * nu) * aside / (distance * (distance + depth)));
    const double down = scale * (depth * depth / std::pow(distance, 3) + 2.0 * (1.0 - nu) / distance);
    const Vec3 away = aside > 0.0 ? Vec3(place.x() / aside, place.y() / aside, 0.0) : Vec3::Zero();
    return out * away - down * Vec3::UnitZ();
}

WorldModel block(const HertzCase& problem, int n, Formulation formulation) {
    const double size = patches * problem.patch();
    WorldModel model =
        ball_on_block(n, size, centre, problem.young_modulus, problem.poisson_ratio, problem.radius, Advance::implicit);
    SolidModel& solid = model.solids[0];
    solid.formulation = formulation;
    solid.damping_mass = 0.0;
    solid.materials[0].density = density;
    solid.fixed_nodes.clear();
    for (std::size_t i = 0; i < solid.coarse.nodes.size(); ++i) {
        const Vec3& node = solid.coarse.nodes[i];
        if (std::max({std::abs(node.x()), std::abs(node.y()), -node.z()}) > size - 1e-9) {
            solid.fixed_nodes.push_back(static_cast<int>(i));
        }
    }
    return model;
}

}  // namespace

double HertzCase::force() const {
    return 4.0 / 3.0 * young_modulus / (1.0 - poisson_ratio * poisson_ratio) * std::sqrt(radius) * std::pow(depth, 1.5);
}

double HertzCase::patch() const { return std::sqrt(radius * depth); }

HertzResult press_ball(const HertzCase& problem, int n, Formulation formulation) {
    PhysicsSettings settings;
    settings.tolerance = 1e-6;
    settings.max_newton = 40;
    Scene scene(block(problem, n, formulation), settings);
    const std::vector<Vec3>& rest = scene.model->solids[0].coarse.nodes;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        scene.state.solids[0].position[i] += boussinesq(problem, problem.force(), rest[i]);
    }
    scene.place_tool(0, pose_at(Vec3(0.0, 0.0, -problem.depth)));
    HertzResult result;
    for (int i = 0; i < steps; ++i) {
        scene.step(contact_dt);
        const double force = scene.tool_force(0).z();
        result.change = std::abs(force - result.force) / std::abs(force);
        result.force = force;
    }
    result.tetrahedra = static_cast<int>(scene.model->solids[0].coarse.tets.size());
    result.spacing = 0.5 * patches * problem.patch() * centre / n;
    result.sideways = scene.tool_force(0).head<2>().norm();
    for (const Contact& contact : scene.contacts) {
        result.patch = std::max(result.patch, contact.point.head<2>().norm());
    }
    result.rollbacks = scene.rollbacks;
    return result;
}

}  // namespace rhexis::scenes
