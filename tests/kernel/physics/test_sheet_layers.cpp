// SPDX-License-Identifier: GPL-3.0-or-later
// A flap of the capsule of an eye that is folded over: it lies on the capsule and does not pass through it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "scenes/capsule_scene.hpp"
#include "support/sanitized.hpp"
#include "tools/rhexis_tools.hpp"

using namespace rhexis;
using scenes::CapsuleScene;

namespace {

constexpr double of_the_fold = 0.7;  // nearer to each other at rest, they belong to the fold itself [mm]
constexpr double steepest = 0.3;     // cosine, from where it looked at rest, of what has an above and a below
constexpr double stayed = 0.6;       // of what has gone less far it is known which side is up [mm]

Vec3 above(const CapsuleScene& scene, double x, double y, double height) {
    return scene.front(x, y) + height * Vec3::UnitZ();
}

Vec3 normal_of(const std::vector<Vec3>& x, const std::array<int, 3>& n) {
    return (x[at(n[1])] - x[at(n[0])]).cross(x[at(n[2])] - x[at(n[0])]);
}

/// Nodes whose triangles are folded over.
std::vector<int> folded_nodes(const MembraneState& state) {
    const TriMesh& mesh = state.sheet->mesh;
    std::vector<double> upright(state.position.size(), 0.0);
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = mesh.triangles[at(t)];
        for (const int node : n) {
            upright[at(node)] += normal_of(state.position, n).dot(front_of(mesh, t));
        }
    }
    std::vector<int> result;
    for (int node = 0; node < static_cast<int>(upright.size()); ++node) {
        if (upright[at(node)] < 0.0) {
            result.push_back(node);
        }
    }
    return result;
}

struct Heights {
    double least = 1.0;  ///< [mm]
    int count = 0;       ///< nodes that are above or below a triangle
};

/// Of the folded nodes over the part of the sheet that stayed where it was.
Heights heights(const MembraneState& state) {
    const TriMesh& mesh = state.sheet->mesh;
    const std::vector<Vec3>& x = state.position;
    const std::vector<int> over = folded_nodes(state);
    Heights result;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = mesh.triangles[at(t)];
        if (std::any_of(n.begin(), n.end(),
                        [&](int k) { return (x[at(k)] - mesh.nodes[at(k)]).head<2>().norm() > stayed; })) {
            continue;
        }
        const Vec3 normal = normal_of(x, n);
        if (normal.normalized().dot(front_of(mesh, t)) < steepest) {
            continue;
        }
        for (const int node : over) {
            const Vec3 way = x[at(node)] - x[at(n[0])];
            const double v = way.cross(x[at(n[2])] - x[at(n[0])]).dot(normal) / normal.squaredNorm();
            const double w = (x[at(n[1])] - x[at(n[0])]).cross(way).dot(normal) / normal.squaredNorm();
            const double height = way.dot(normal.normalized());
            if (v > 0.0 && w > 0.0 && v + w < 1.0 && std::abs(height) < 1.0 &&
                (mesh.nodes[at(node)] - triangle_middle(mesh, t)).norm() > of_the_fold) {
                result.least = std::min(result.least, height);
                ++result.count;
            }
        }
    }
    return result;
}

/// Grasps a flap, folds it over to the other side of the pole, and lays it down.
CapsuleScene folded_over(bool layers) {
    CapsuleScene scene(68.0, {}, {capsulorhexis_forceps(), capsulorhexis_forceps()}, layers);
    scene.open_flap(1.0, 2.6, 1.2);
    scene.put(0, above(scene, 2.2, 0.4, 0.05), 1.0);
    scene.lead(0, above(scene, 2.2, 0.4, 0.06), 1.0, 0.0);
    scene.lead(0, above(scene, 1.3, 0.9, 0.6), 3.0, 0.0);
    scene.lead(0, above(scene, 0.6, 0.9, 0.6), 3.0, 0.0);
    scene.lead(0, above(scene, 0.3, 0.8, 0.1), 3.0, 0.0);
    return scene;
}

void let_go(CapsuleScene& scene) {
    const Vec3 place = scene.tool(0).pose.position;
    scene.lead(0, place + Vec3(0.0, 0.0, 1e-3), 1.0, 1.0);
    scene.lead(0, place + Vec3(0.0, 0.0, 1.5), 5.0, 1.0);
    scene.withdraw(0);
}

double fastest(const MembraneState& state) {
    double most = 0.0;
    for (const Vec3& v : state.velocity) {
        most = std::max(most, v.norm());
    }
    return most;
}

/// Leads the flap in a straight line of a millimetre at most, in fifths: fifths of one that is as long take a step at
/// 20 mm/s. Returns the least height on the way.
double least_on_way(CapsuleScene& scene, const Vec3& to, double speed) {
    const Vec3 from = scene.tool(0).pose.position;
    double least = 1.0;
    for (int i = 1; i <= 5; ++i) {
        scene.lead(0, from + 0.2 * i * (to - from), speed, 0.0);
        least = std::min(least, heights(scene.sheet()).least);
    }
    return least;
}

}  // namespace

TEST_SUITE("sheet layers") {
    TEST_CASE("what is lifted under a flap lifts it; without layers it passes through" *
              doctest::skip(rhexis::testing::sanitized)) {
        for (const bool layers : {true, false}) {
            CapsuleScene scene = folded_over(layers);
            let_go(scene);
            scene.settle(30);
            CHECK(heights(scene.sheet()).count > 8);
            scene.put(1, above(scene, -0.3, 0.5, 0.1), 1.0);
            scene.lead(1, above(scene, -0.3, 0.5, 0.05), 1.0, 0.0);
            REQUIRE(scene.sheet().grips.size() >= 3);
            double least = 1.0;
            for (int i = 1; i < 10; ++i) {
                scene.lead(1, above(scene, -0.3, 0.5, 0.05 + 0.1 * i), 2.0, 0.0);
                least = std::min(least, heights(scene.sheet()).least);
            }
            CHECK((layers ? least > 0.01 : least < -0.1));
        }
    }

    TEST_CASE("a flap pressed onto the capsule at up to 19 mm/s stays above it, and comes up on its side") {
        CapsuleScene scene = folded_over(true);
        CHECK(least_on_way(scene, above(scene, 0.3, 0.8, -0.15), 1.0) >
              -0.03);  // two thicknesses; without layers -0.26
        CHECK(scene.force().norm() > 20000.0);
        CHECK(least_on_way(scene, above(scene, -0.3, 0.5, -0.05), 20.0) > -0.02);
        CHECK(least_on_way(scene, above(scene, 0.6, 1.0, -0.05), 20.0) > -0.02);
        CHECK(least_on_way(scene, above(scene, 0.6, 1.0, 0.5), 5.0) > -0.001);
    }

    TEST_CASE("led back, a flap unfolds" * doctest::skip(rhexis::testing::sanitized)) {
        CapsuleScene scene = folded_over(true);
        const std::size_t most = folded_nodes(scene.sheet()).size();
        scene.lead(0, above(scene, 1.0, 0.9, 0.6), 3.0, 0.0);
        scene.lead(0, above(scene, 2.0, 0.5, 0.6), 3.0, 0.0);
        scene.lead(0, above(scene, 2.2, 0.4, 0.1), 3.0, 0.0);
        CHECK(folded_nodes(scene.sheet()).size() <= 6 * most / 10);  // the rest lies in wrinkles beside the jaws
        CHECK(scene.force().norm() < 5000.0);
    }

    TEST_CASE("a flap that lies folded comes to rest and gains no energy" * doctest::skip(rhexis::testing::sanitized)) {
        CapsuleScene scene = folded_over(true);
        let_go(scene);
        double least = elastic_energy(scene.model(), scene.sheet());
        for (int i = 0; i < 200; ++i) {
            scene.step();
            const double energy = elastic_energy(scene.model(), scene.sheet());
            CHECK(energy < 1.002 * least);  // rim springs give some back, and forces may be out of balance by 20 uN
            least = std::min(least, energy);
        }
        CHECK(fastest(scene.sheet()) < 0.4);  // it creeps open against the viscoelastic, with layers as without
    }

    TEST_CASE("a flap that tears round stays above the capsule" * doctest::skip(rhexis::testing::sanitized)) {
        CapsuleScene scene(68.0, {}, {capsulorhexis_forceps()});
        scene.open_flap(1.0, 2.6, 0.9);
        scene.put(0, above(scene, 2.2, 0.4, 0.05), 1.0);
        scene.lead(0, above(scene, 2.2, 0.4, 0.06), 1.0, 0.0);
        double least = 1.0;
        int most = 0;
        for (int i = 0; i <= 28; ++i) {
            const double angle = 0.2 + 0.08 * i;
            scene.lead(0, above(scene, 1.7 * std::cos(angle), 1.7 * std::sin(angle), 0.2), 1.5, 0.0);
            const Heights now = heights(scene.sheet());
            least = std::min(least, now.least);
            most = std::max(most, now.count);
        }
        CHECK(most > 20);
        CHECK(least > 0.0);
    }
}
