// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/squeeze_trials.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/index.hpp"
#include "scenes/bodies.hpp"
#include "scenes/contact_scenes.hpp"
#include "tools/probe.hpp"
#include "topology/remove.hpp"

namespace rhexis::scenes {
namespace {

constexpr double ball = 0.5;       // radius [mm]
constexpr double half_cube = 1.0;  // [mm]
constexpr double squeeze_dt = 0.01;

WorldModel cube_between_balls(Advance way, int cells) {
    WorldModel model;
    SolidModel body = cube(cells, 2.0 * half_cube, 5000.0, 0.45);
    body.advance = way;
    body.damping_mass = 20.0;
    body.damping_stiffness = 1e-4;
    model.solids.push_back(std::move(body));
    model.tools = {probe(ball, 0.0), probe(ball, 0.0)};
    model.gravity.setZero();
    return model;
}

/// The ball's foremost point is its origin, and it lies along +z from there: that from below has it turned.
Pose jaw_pose(int jaw, double depth) {
    Pose pose = pose_at(Vec3(0.0, 0.0, half_cube - depth));
    if (jaw == 1) {
        pose.position.z() = -pose.position.z();
        pose.orientation = Quat(Eigen::AngleAxisd(M_PI, Vec3::UnitX()));
    }
    return pose;
}

/// Change from one to the next, rms over the mean.
double change_of(const std::vector<double>& series) {
    double mean = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        mean += series[i] / static_cast<double>(series.size());
        square += i > 0 ? std::pow(series[i] - series[i - 1], 2) : 0.0;
    }
    return std::sqrt(square / static_cast<double>(series.size() - 1)) / std::abs(mean);
}

/// The block of the trials of contact, with a ball over its middle.
WorldModel block_to_cut() {
    WorldModel model = ball_on_block(4, 2.0, 1.0, 5000.0, 0.45, 1.0, Advance::implicit);
    model.solids[0].damping_stiffness = 1e-4;
    return model;
}

/// Tetrahedra of the block's upper half beside the ball, the nearest to its side first.
std::vector<int> beside_ball(const TetMesh& mesh) {
    std::vector<std::pair<double, int>> found;
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
        Vec3 middle = Vec3::Zero();
        for (const int node : mesh.tets[at(t)]) {
            middle += 0.25 * mesh.nodes[at(node)];
        }
        if (middle.x() > 0.3 && middle.z() > -1.0) {
            found.emplace_back(middle.head<2>().norm(), t);
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<int> list;
    for (const auto& [distance, t] : found) {
        list.push_back(t);
    }
    return list;
}

}  // namespace

Squeeze squeeze_cube(Advance way, double depth, bool quick) {
    const int cells = quick ? 4 : 6;
    const int closing = quick ? 10 : 20;
    const int steps = quick ? 40 : 100;
    PhysicsSettings settings;
    settings.elastic_energy = true;
    Scene scene(cube_between_balls(way, cells), settings);
    const auto depth_at = [&](int i) { return depth * std::min(1.0, static_cast<double>(i) / closing); };
    for (const int jaw : {0, 1}) {
        scene.place_tool(jaw, jaw_pose(jaw, 0.0));
    }
    Squeeze found;
    std::vector<double> force;
    double work = 0.0;
    double most = 0.0;
    double excess = 0.0;
    for (int i = 1; i <= steps; ++i) {
        std::array<Vec3, 2> way_of;
        for (const int jaw : {0, 1}) {
            scene.move_tool(jaw, jaw_pose(jaw, depth_at(i)));
            way_of[at(jaw)] = jaw_pose(jaw, depth_at(i)).position - jaw_pose(jaw, depth_at(i - 1)).position;
        }
        scene.step(squeeze_dt);
        work -= scene.tool_force(0).dot(way_of[0]) + scene.tool_force(1).dot(way_of[1]);
        most = std::max(most, work);
        excess = std::max(excess, scene.kinetic() + scene.elastic() - work);
        found.failures += scene.outcome.failure == StepFailure::none ? 0 : 1;
        found.deepest = std::max(found.deepest, scene.penetration() / (2.0 * half_cube / cells));
        if (2 * i > steps + closing) {
            force.push_back(scene.tool_force(0).z());
            found.uneven = std::max(found.uneven, std::abs(1.0 + scene.tool_force(1).z() / force.back()));
        }
    }
    found.jitter = change_of(force);
    found.gain = std::max(0.0, excess) / most;
    return found;
}

CutPress cut_under_tool(int steps) {
    PhysicsSettings close;
    close.tolerance = 1e-9;
    close.max_newton = 60;
    Scene kept(block_to_cut(), close);
    Scene anew(block_to_cut(), close);
    const std::vector<int> order = beside_ball(kept.model->solids[0].coarse);
    const std::vector<Vec3> rest = kept.state.solids[0].position;
    CutPress found;
    double shift = 0.0;
    for (Scene* scene : {&kept, &anew}) {
        scene->place_tool(0, pose_at(Vec3(0.0, 0.0, 0.01)));
    }
    for (int i = 1; i <= steps; ++i) {
        const double share = std::min(1.0, 10.0 * i / steps);
        const std::vector<int> gone(order.begin(), order.begin() + std::min<std::ptrdiff_t>(3 * i, std::ssize(order)));
        for (Scene* scene : {&kept, &anew}) {
            SolidState& body = scene->state.solids[0];
            apply(remove_coarse(scene->model->solids[0], body, 0, gone), scene->model->solids[0], body);
            scene->move_tool(0, pose_at(Vec3(0.0, 0.0, 0.01 - 0.16 * share)));
            if (scene == &anew) {
                scene->forget();
            }
            scene->step(squeeze_dt);
            found.failures += scene->outcome.failure == StepFailure::none ? 0 : 1;
            found.deepest = std::max(found.deepest, scene->penetration() / 0.5);
        }
        for (std::size_t n = 0; n < rest.size(); ++n) {
            const Vec3& now = kept.state.solids[0].position[n];
            shift = std::max(shift, (now - rest[n]).norm());
            found.apart = std::max(found.apart, (now - anew.state.solids[0].position[n]).norm());
        }
    }
    found.apart /= shift;
    return found;
}

}  // namespace rhexis::scenes
