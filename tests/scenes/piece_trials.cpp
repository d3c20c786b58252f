// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/piece_trials.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/index.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/places.hpp"
#include "mesh/shapes.hpp"
#include "scenes/bodies.hpp"
#include "scenes/contact_scenes.hpp"
#include "topology/come_apart.hpp"
#include "topology/segments.hpp"

namespace rhexis::scenes {
namespace {

constexpr double piece_dt = 0.01;

/// Faces between tetrahedra on either side of x = 0.
std::vector<BrokenFace> faces_across(const TetMesh& mesh) {
    std::vector<BrokenFace> faces;
    const std::vector<std::array<int, 4>> neighbours = face_neighbours(mesh.tets);
    const auto right = [&](int t) { return centroid(mesh.nodes, mesh.tets[at(t)]).x() > 0.0; };
    for (int t = 0; t < static_cast<int>(neighbours.size()); ++t) {
        for (const int other : neighbours[at(t)]) {
            if (other > t && right(t) != right(other)) {
                faces.push_back({t, other});
            }
        }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

/// A scene of one solid whose faces have broken.
Scene broken_scene(WorldModel world, const std::vector<BrokenFace>& faces) {
    SolidState body = rest_state(world.solids[0]);
    apply_splits(come_apart(world.solids[0], body, 0, faces), body);
    world.solids[0] = split_model(world.solids[0], body.splits);
    PhysicsSettings settings;
    settings.elastic_energy = true;
    Scene scene(std::move(world), settings);
    scene.state.solids[0] = std::move(body);
    if (!scene.state.bags.empty() && !scene.state.bags[0].adherent.empty()) {
        scene.state.bags[0].adherent.resize(scene.state.solids[0].position.size(), 0);
    }
    return scene;
}

std::vector<double> node_masses(const SolidModel& model) {
    std::vector<double> mass(model.coarse.nodes.size(), 0.0);
    for (int t = 0; t < static_cast<int>(model.coarse.tets.size()); ++t) {
        for (const int node : model.coarse.tets[at(t)]) {
            mass[at(node)] += 0.25 * tet_mass(model, t);
        }
    }
    return mass;
}

/// The two halves of the block: their middles along x and momentum in all.
struct Halves {
    double left = 0.0;
    double right = 0.0;
    Vec3 momentum = Vec3::Zero();
};

Halves halves_of(const Scene& scene, const std::vector<double>& mass, const std::vector<char>& is_right) {
    Halves found;
    const SolidState& body = scene.state.solids[0];
    double left = 0.0;
    double right = 0.0;
    for (std::size_t n = 0; n < mass.size(); ++n) {
        (is_right[n] != 0 ? found.right : found.left) += mass[n] * body.position[n].x();
        (is_right[n] != 0 ? right : left) += mass[n];
        found.momentum += mass[n] * body.velocity[n];
    }
    found.left /= left;
    found.right /= right;
    return found;
}

std::vector<char> on_the_right(const TetMesh& mesh) {
    std::vector<char> right(mesh.nodes.size(), 0);
    for (const std::array<int, 4>& tet : mesh.tets) {
        for (const int node : tet) {
            right[at(node)] = centroid(mesh.nodes, tet).x() > 0.0 ? 1 : 0;
        }
    }
    return right;
}

/// Deepest that a node lies in a tetrahedron of another piece, from its nearest face [mm].
double overlap_of(const Scene& scene) {
    const SolidModel& model = scene.model->solids[0];
    const std::vector<Vec3>& x = scene.state.solids[0].position;
    const std::vector<int> pieces = pieces_of(model, scene.state.solids[0]);
    std::vector<int> owner(x.size(), -1);
    for (std::size_t t = 0; t < pieces.size(); ++t) {
        for (const int node : model.coarse.tets[t]) {
            owner[at(node)] = pieces[t];
        }
    }
    double deepest = 0.0;
    for (std::size_t t = 0; t < pieces.size(); ++t) {
        Mat3 edges;
        const Vec3& corner = x[at(model.coarse.tets[t][0])];
        for (Eigen::Index k = 0; k < 3; ++k) {
            edges.col(k) = x[at(model.coarse.tets[t][static_cast<std::size_t>(k + 1)])] - corner;
        }
        const double reach = edges.colwise().squaredNorm().maxCoeff();
        const Mat3 inverse = edges.inverse();
        const Vec3 last = -inverse.colwise().sum().transpose();
        for (std::size_t n = 0; n < x.size(); ++n) {
            const Vec3 way = x[n] - corner;
            if (owner[n] == pieces[t] || owner[n] < 0 || way.squaredNorm() > reach) {
                continue;
            }
            const Vec3 share = inverse * way;
            double depth = (1.0 - share.sum()) / last.norm();
            for (Eigen::Index k = 0; k < 3; ++k) {
                depth = std::min(depth, share[k] / inverse.row(k).norm());
            }
            deepest = std::max(deepest, depth);
        }
    }
    return deepest;
}

double foremost(const TetMesh& mesh) {
    double z = -HUGE_VAL;
    for (const Vec3& node : mesh.nodes) {
        z = std::max(z, node.z());
    }
    return z;
}

}  // namespace

Collision collide(double speed) {
    constexpr double apart = 0.3;  // at first [mm]
    WorldModel world;
    SolidModel block = body("block", bar(4, 2, 2, 0.5, Vec3(-1.0, -0.5, -0.5)), 5000.0, 0.45);
    block.advance = Advance::explicit_;
    world.solids.push_back(std::move(block));
    world.gravity.setZero();
    const std::vector<BrokenFace> faces = faces_across(world.solids[0].coarse);
    Scene scene = broken_scene(std::move(world), faces);
    const std::vector<double> mass = node_masses(scene.model->solids[0]);
    const std::vector<char> is_right = on_the_right(scene.model->solids[0].coarse);
    double scale = 0.0;
    SolidState& state = scene.state.solids[0];
    for (std::size_t n = 0; n < mass.size(); ++n) {
        const double side = is_right[n] != 0 ? 1.0 : -1.0;
        state.position[n].x() += 0.5 * side * apart;
        state.velocity[n] = Vec3(-0.5 * side * speed, 0.0, 0.0);
        scale += mass[n] * 0.5 * speed;
    }
    const Vec3 before = halves_of(scene, mass, is_right).momentum;
    const double start = 0.25 * scale * speed;
    Collision found;
    for (int i = 0; i < 100; ++i) {
        scene.step(piece_dt);
        found.failures += scene.outcome.failure == StepFailure::none ? 0 : 1;
        found.gain = std::max(found.gain, (scene.kinetic() + scene.elastic()) / start - 1.0);
        const Halves now = halves_of(scene, mass, is_right);
        found.momentum = std::max(found.momentum, (now.momentum - before).norm() / scale);
    }
    const Halves end = halves_of(scene, mass, is_right);
    found.parted = end.right - end.left > 1.0;
    return found;
}

Crowd press_segments(int tetrahedra, double seconds) {
    constexpr double deep = 0.3;  // [mm]
    constexpr int pressing = 10;  // steps, and as many that the probe stays
    WorldModel world = lens_in_bag("probe", Advance::explicit_, tetrahedra);
    const std::vector<BrokenFace> faces = segment_faces(world.solids[0], 8);
    const double front = foremost(world.solids[0].coarse);
    Scene scene = broken_scene(std::move(world), faces);
    const auto place = [&](int i) { return Vec3(0.1, 0.05, front + 0.05 - deep * std::min(1.0, 1.0 * i / pressing)); };
    scene.place_tool(0, pose_at(place(0)));
    Crowd found;
    const int steps = 2 * pressing + static_cast<int>(std::lround(seconds / piece_dt));
    for (int i = 1; i <= steps; ++i) {
        if (i <= 2 * pressing) {
            scene.move_tool(0, pose_at(place(i)));
        } else {
            scene.withdraw_tool(0);
        }
        scene.step(piece_dt);
        found.failures += scene.outcome.failure == StepFailure::none ? 0 : 1;
        found.fastest = std::max(found.fastest, scene.speed());
        found.left = i > 4 * pressing ? std::max(found.left, scene.kinetic()) : found.left;
        found.overlap = i % 5 == 0 ? std::max(found.overlap, overlap_of(scene)) : found.overlap;
    }
    found.inverted = scene.outcome.solids[0].inverted;
    return found;
}

}  // namespace rhexis::scenes
