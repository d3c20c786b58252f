// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/lens_press.hpp"

#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "scenes/contact_scenes.hpp"
#include "tools/probe.hpp"

namespace rhexis::scenes {
namespace {

constexpr double window = 0.01;  ///< [s]
constexpr double down = 0.2;     ///< [s]
constexpr double whole = 0.4;    ///< [s]
constexpr double depth = 0.4;    ///< [mm]

int pole_of(const TetMesh& mesh) {
    const auto higher = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
    return static_cast<int>(std::max_element(mesh.nodes.begin(), mesh.nodes.end(), higher) - mesh.nodes.begin());
}

}  // namespace

LensPress press_lens(SolidModel lens, double dt) {
    WorldModel world;
    const int pole = pole_of(lens.coarse);
    const Vec3 top = lens.coarse.nodes[static_cast<std::size_t>(pole)];
    world.solids.push_back(std::move(lens));
    world.tools.push_back(probe(1.0, 0.0));
    world.gravity.setZero();
    Scene scene(std::move(world));
    const auto place = [&](double time) {
        return pose_at(top + Vec3(0.0, 0.0, 0.005 - depth * std::min(1.0, time / down)));
    };
    scene.place_tool(0, place(0.0));
    LensPress result;
    const int steps = static_cast<int>(std::lround(window / dt));
    const double start = process_cpu_seconds();
    for (int w = 0; w < static_cast<int>(std::lround(whole / window)); ++w) {
        double force = 0.0;
        for (int i = 1; i <= steps; ++i) {
            scene.move_tool(0, place(w * window + i * dt));
            scene.step(dt);
            force += scene.tool_force(0).z() / steps;
        }
        result.force.push_back(force);
        result.dip.push_back(top.z() - scene.state.solids[0].position[static_cast<std::size_t>(pole)].z());
    }
    result.cpu_s_per_s = (process_cpu_seconds() - start) / whole;
    result.rollbacks = scene.rollbacks;
    return result;
}

double stroke_cost(const SolidModel& lens, double grade) {
    WorldModel world = lens_in_bag("phaco", lens.advance, 3000, grade);
    world.solids[0].formulation = lens.formulation;
    world.solids[0].sought_step = lens.sought_step;
    Scene scene(std::move(world));
    const TetMesh& mesh = scene.model->solids[0].coarse;
    const double top = mesh.nodes[static_cast<std::size_t>(pole_of(mesh))].z();
    const auto place = [&](double time) {
        const double there = std::abs(std::fmod(time, 1.0) - 0.5);  // to and fro, 3.5 mm each way
        return pose_at(Vec3(0.0, 7.0 * there - 1.75, top - 0.1));
    };
    scene.place_tool(0, place(0.0));
    constexpr int steps = 200;
    const double start = process_cpu_seconds();
    for (int i = 1; i <= steps; ++i) {
        scene.move_tool(0, place(i * window));
        scene.step(window);
    }
    return (process_cpu_seconds() - start) / (steps * window);
}

double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double difference = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        difference += (a[i] - b[i]) * (a[i] - b[i]);
        size += b[i] * b[i];
    }
    return std::sqrt(difference / size);
}

}  // namespace rhexis::scenes
