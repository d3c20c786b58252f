// SPDX-License-Identifier: GPL-3.0-or-later
// What suction holds, and what slips from it.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/shapes.hpp"
#include "physics/fluid/mouth.hpp"
#include "scenes/bodies.hpp"
#include "scenes/contact_scenes.hpp"
#include "scenes/piece_trials.hpp"
#include "tools/phaco_tip.hpp"

namespace rhexis::scenes {
namespace {

constexpr double grip_dt = 0.01;
constexpr double drawn_by = 0.4;    // [mm]
constexpr double ample = 20000.0;   // [uN]
constexpr double slipping = 500.0;  // less than the cube pulls back with at the end [uN]

WorldModel cube_under_tip() {
    WorldModel model;
    SolidModel held = cube(3, 2.0, 5000.0, 0.45);
    held.damping_mass = 20.0;
    held.damping_stiffness = 1e-4;
    held.advance = Advance::explicit_;
    held.fixed_nodes = nodes_on_plane(held.coarse, Vec3(0.0, 0.0, -1.0), Vec3::UnitZ());
    model.solids.push_back(std::move(held));
    model.tools = {phaco_tip()};
    model.tools[0].bevel = 0.0;
    model.gravity.setZero();
    return model;
}

double suction_in(Suction suction, int step) {
    if (suction == Suction::on_and_off) {
        return step % 2 == 0 ? ample : 0.0;
    }
    return suction == Suction::ample ? ample : slipping;
}

double top_of(const Scene& scene) {
    const std::vector<Vec3>& rest = scene.model->solids[0].coarse.nodes;
    double sum = 0.0;
    int count = 0;
    for (std::size_t n = 0; n < rest.size(); ++n) {
        const bool under_mouth = rest[n].z() > 0.99 && rest[n].head<2>().norm() < 0.5;
        sum += under_mouth ? scene.state.solids[0].position[n].z() : 0.0;
        count += under_mouth ? 1 : 0;
    }
    return sum / count;
}

}  // namespace

Grip draw_up(Suction suction) {
    PhysicsSettings settings;
    settings.elastic_energy = true;
    Scene scene(cube_under_tip(), settings);
    const double area = mouth_probe(scene.model->tools[0]).area;
    const auto height = [](int i) { return 1.02 + std::min(drawn_by, 0.02 * i); };
    scene.place_tool(0, pose_at(Vec3(0.0, 0.0, height(0))));
    Grip found;
    const double strongest = suction == Suction::threshold ? slipping : ample;
    double work = 0.0;
    double excess = 0.0;
    double most = 0.0;
    const double before = top_of(scene);
    for (int i = 1; i <= 80; ++i) {
        const double hold = i <= 30 ? suction_in(suction, i) : 0.0;
        TipState& tip = scene.state.tips[0];
        tip.lens = hold > 0.0 ? 1.0 : 0.0;
        tip.open = 0.0;
        tip.hold = hold;
        tip.suction = hold / area;
        if (i <= 30) {
            scene.move_tool(0, pose_at(Vec3(0.0, 0.0, height(i))));
        } else {
            scene.withdraw_tool(0);
        }
        scene.step(grip_dt);
        const double force = scene.tool_force(0).norm();
        const double done = i <= 30 ? -scene.tool_force(0).z() * (height(i) - height(i - 1)) : 0.0;
        work += done;
        const double energy = scene.kinetic() + scene.elastic();
        most = std::max(most, energy);
        excess = std::max(excess, energy - work);
        found.most = hold > 0.0 ? std::max(found.most, force / hold) : found.most;
        found.failures += scene.outcome.failure == StepFailure::none ? 0 : 1;
        found.led = i == 30 ? (top_of(scene) - before) / drawn_by : found.led;
    }
    found.gain = excess / (0.1 * strongest);
    found.left = (scene.kinetic() + scene.elastic()) / most;
    return found;
}

}  // namespace rhexis::scenes
