// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "base/rng.hpp"
#include "energy/corotational.hpp"
#include "energy/nodal_pressure.hpp"
#include "math/random_vectors.hpp"
#include "scenes/bodies.hpp"
#include "support/finite_difference.hpp"

using namespace rhexis;

namespace {

/// A block of two materials, one corner of it gone and some of it worn.
struct Block {
    TetMesh mesh = scenes::cube(2, 1.0, 3000.0, 0.3).coarse;
    ElementDomains domains = element_domains(mesh, Formulation::nodal_pressure);
    std::vector<TetStiffness> stiffness;
    NodePatches patches;

    Block() {
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            const Lame material = lame(t % 2 == 0 ? 3000.0 : 9000.0, 0.47);
            stiffness.push_back({material.lambda, material.mu, t == 0 ? 0.0 : t < 5 ? 0.4 : 1.0});
        }
        patches = node_patches(mesh, domains.rest_volume, stiffness);
    }

    [[nodiscard]] CorotationalPoint point(std::size_t t, const VecX& x) const {
        Mat3 f = Mat3::Zero();
        for (std::size_t a = 0; a < 4; ++a) {
            f += x.segment<3>(3 * mesh.tets[t][a]) * domains.rest_gradient[4 * t + a].transpose();
        }
        return corotational_point(f);
    }
    [[nodiscard]] std::vector<double> theta(const VecX& x) const {
        std::vector<double> result;
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            result.push_back(point(t, x).trace - 3.0);
        }
        return result;
    }
    [[nodiscard]] double energy(const VecX& x) const {
        return nodal_pressure_energy(mesh, domains.rest_volume, stiffness, patches, theta(x));
    }
    [[nodiscard]] VecX gradient(const VecX& x) const {
        const std::vector<double> pressure = tet_pressures(mesh, domains.rest_volume, stiffness, patches, theta(x));
        VecX result = VecX::Zero(x.size());
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            const Mat3 rotation = point(t, x).rotation;
            const double weight = stiffness[t].share * domains.rest_volume[t] * pressure[t];
            for (std::size_t a = 0; a < 4; ++a) {
                result.segment<3>(3 * mesh.tets[t][a]) += weight * (rotation * domains.rest_gradient[4 * t + a]);
            }
        }
        return result;
    }
    [[nodiscard]] VecX mapped(const Mat3& map, double noise) const {
        VecX x(static_cast<Eigen::Index>(3 * mesh.nodes.size()));
        Rng rng(7, "block");
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
            const Vec3 shake = uniform3(rng) - Vec3::Constant(0.5);
            x.segment<3>(static_cast<Eigen::Index>(3 * i)) = map * mesh.nodes[i] + noise * shake;
        }
        return x;
    }
};

Mat3 turn(double angle) { return Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix(); }

}  // namespace

TEST_SUITE("energy") {
    TEST_CASE("pressure at nodes: the gradient is that of the energy") {
        const Block block;
        const VecX x = block.mapped(turn(0.7) * Vec3(1.2, 0.9, 1.1).asDiagonal(), 0.1);
        const auto value = [&block](const VecX& at_x) { return VecX::Constant(1, block.energy(at_x)); };
        CHECK(test::derivative_error(value, x, block.gradient(x).transpose(), 1e-4) < 1e-8);
    }

    TEST_CASE("pressure at nodes: an even change of volume costs what it costs in the tetrahedra") {
        const Block block;
        const double stretch = 1.05;
        const VecX x = block.mapped(turn(1.0) * (stretch * Mat3::Identity()), 0.0);
        double expected = 0.0;
        for (std::size_t t = 0; t < block.stiffness.size(); ++t) {
            const TetStiffness& own = block.stiffness[t];
            const double bulk = own.lambda + 2.0 / 3.0 * own.mu;
            expected += 0.5 * own.share * block.domains.rest_volume[t] * bulk * 9.0 * (stretch - 1.0) * (stretch - 1.0);
        }
        CHECK(block.energy(x) == doctest::Approx(expected).epsilon(1e-12));
    }

    TEST_CASE("pressure at nodes: never more than in the tetrahedra, the same in every frame, nothing at rest") {
        Block block;  // of one material: where two meet, the modulus of a patch is that of neither
        for (TetStiffness& own : block.stiffness) {
            own.lambda = block.stiffness[1].lambda;
            own.mu = block.stiffness[1].mu;
        }
        block.patches = node_patches(block.mesh, block.domains.rest_volume, block.stiffness);
        const VecX x = block.mapped(Vec3(1.1, 0.9, 1.05).asDiagonal(), 0.15);
        const std::vector<double> theta = block.theta(x);
        double local = 0.0;
        for (std::size_t t = 0; t < theta.size(); ++t) {
            const TetStiffness& own = block.stiffness[t];
            local += 0.5 * own.share * block.domains.rest_volume[t] * (own.lambda + 2.0 / 3.0 * own.mu) * theta[t] *
                     theta[t];
        }
        CHECK(block.energy(x) < local);
        CHECK(block.energy(x) > 0.0);
        VecX turned = x;
        for (Eigen::Index i = 0; i < x.size(); i += 3) {
            turned.segment<3>(i) = turn(2.0) * x.segment<3>(i) + Vec3(5, -3, 8);
        }
        CHECK(block.energy(turned) == doctest::Approx(block.energy(x)).epsilon(1e-12));
        CHECK(std::abs(block.energy(block.mapped(turn(2.5), 0.0))) < 1e-20 * local + 1e-18);
    }
}
