// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/contact_trials.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/shapes.hpp"
#include "scenes/bodies.hpp"
#include "scenes/contact_scenes.hpp"
#include "tools/probe.hpp"

namespace rhexis::scenes {
namespace {

constexpr double gravity = 9810.0;  // [mm/s^2]

void count(const Scene& scene, int& failures) { failures += scene.outcome.failure == StepFailure::none ? 0 : 1; }

/// A block of 4 x 4 x 2 mm with its top at z = 0, held at the bottom, and a ball as tool.
WorldModel block_and_ball(double radius, Advance advance) {
    WorldModel model = ball_on_block(4, 2.0, 1.0, 5000.0, 0.45, radius, advance);
    model.solids[0].damping_mass = 20.0;
    model.solids[0].damping_stiffness = 1e-4;
    return model;
}

constexpr double edge = 0.5;  ///< of its cells [mm]

/// Where the tool stands after step i, and whether it is there at all.
Vec3 place_of(Blow blow, int i) {
    if (blow == Blow::down) {
        return {0.1, 0.05, i % 2 == 1 ? -0.3 : 9.7};
    }
    return {i % 2 == 1 ? 5.0 : -5.0, 0.1, -0.2};
}

}  // namespace

Slide slide(double share, double heading, Advance advance, double seconds) {
    constexpr double friction = 0.3;
    constexpr double dt = 0.01;
    const double slope = share * std::atan(friction);
    WorldModel model = cube_on_slope(slope, heading, friction, advance);
    const Vec3 tilted = model.gravity;
    const Vec3 downhill(std::cos(heading), std::sin(heading), 0.0);
    Scene scene(std::move(model));
    Slide result;
    for (double time = 0.0; time < 0.3; time += dt) {
        scene.step(dt);
        count(scene, result.failures);
    }
    const Vec3 start = scene.centre();
    for (double time = 0.0; time < seconds - 1e-9; time += dt) {
        scene.step(dt);
        count(scene, result.failures);
    }
    const Vec3 way = scene.centre() - start;
    result.drift = way.head<2>().norm();
    result.aside = (way - way.dot(downhill) * downhill).head<2>().norm();
    if (share > 1.0) {
        const double pull = tilted.head<2>().norm() - friction * std::abs(tilted.z());
        result.expected = 0.5 * pull * (std::pow(0.3 + seconds, 2) - 0.09);
    }
    result.rollbacks = scene.rollbacks;
    return result;
}

Strike strike(Blow blow, Advance advance) {
    constexpr double dt = 0.01;
    constexpr double speed = 1000.0;
    PhysicsSettings settings;
    settings.elastic_energy = true;
    Scene scene(block_and_ball(0.5, advance), settings);
    scene.place_tool(0, pose_at(place_of(blow, 0)));
    Strike result;
    double work = 0.0;
    double excess = 0.0;
    const auto step = [&](const Vec3& way) {
        scene.step(dt);
        work -= scene.tool_force(0).dot(way);
        count(scene, result.failures);
        result.penetration = std::max(result.penetration, scene.penetration() / edge);
        result.fastest = std::max(result.fastest, scene.speed() / speed);
        result.most_substeps = std::max(result.most_substeps, scene.outcome.solids[0].substeps);
        result.work = std::max(result.work, work);
        excess = std::max(excess, scene.kinetic() + scene.elastic() - work);
    };
    for (int i = 1; i <= 6; ++i) {
        scene.move_tool(0, pose_at(place_of(blow, i)));
        step(place_of(blow, i) - place_of(blow, i - 1));
    }
    scene.withdraw_tool(0);
    for (int i = 0; i < 50; ++i) {
        step(Vec3::Zero());
    }
    result.gain = excess / result.work;
    result.left = (scene.kinetic() + scene.elastic()) / result.work;
    result.inverted = scene.outcome.solids[0].inverted;
    return result;
}

Press press(Advance advance, double dt) {
    Scene scene(block_and_ball(1.0, advance));
    scene.place_tool(0, pose_at(Vec3(0.0, 0.0, 0.01)));
    Press result;
    const int steps = static_cast<int>(std::lround(0.2 / dt));
    int counted = 0;
    for (int i = 1; i <= steps; ++i) {
        const double share = std::min(1.0, 2.0 * i / steps);
        scene.move_tool(0, pose_at(Vec3(0.0, 0.0, 0.01 - 0.16 * share)));
        scene.step(dt);
        if (4 * i > 3 * steps) {
            result.force += scene.tool_force(0).z();
            ++counted;
        }
    }
    result.force /= counted;
    for (std::size_t i = 0; i < scene.state.solids[0].position.size(); ++i) {
        if (scene.model->solids[0].coarse.nodes[i].norm() < 1e-9) {
            result.dip = -scene.state.solids[0].position[i].z();
        }
    }
    result.rollbacks = scene.rollbacks;
    return result;
}

}  // namespace rhexis::scenes
