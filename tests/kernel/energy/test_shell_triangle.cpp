// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "base/rng.hpp"
#include "energy/shell_triangle.hpp"
#include "math/random_vectors.hpp"
#include "math/rotation.hpp"
#include "scenes/eigenvalues.hpp"
#include "support/finite_difference.hpp"

using namespace rhexis;

namespace {

using Points = std::array<Vec3, 3>;

const Points rest_points{Vec3(0.1, 0.0, 0.2), Vec3(0.9, 0.1, 0.25), Vec3(0.2, 0.7, 0.1)};
const double thickness = 0.12;
const double young = 1.0e6;

ShellTriangle sample(double nu = 0.42) { return shell_triangle(rest_points, thickness, young, nu); }

Vec3 random_vector(Rng& rng, double size) { return size * (2.0 * uniform3(rng) - Vec3::Ones()); }

Mat3 any_turn(Rng& rng) {
    const Vec3 axis = random_vector(rng, 1.0) + Vec3(0.0, 0.0, 1.5);
    return Eigen::AngleAxisd(3.0 * rng.uniform(), axis.normalized()).toRotationMatrix();
}

/// Turned as a whole by any angle, then each corner moved and turned by up to `size`.
ShellCorners deformed(Rng& rng, double size) {
    const Mat3 turn = any_turn(rng);
    ShellCorners corners;
    for (std::size_t a = 0; a < 3; ++a) {
        corners.position[a] = turn * (rest_points[a] + random_vector(rng, 0.3 * size)) + Vec3(3.0, -1.0, 2.0);
        corners.rotation[a] = turn * cayley(random_vector(rng, size));
    }
    return corners;
}

ShellCorners moved(const ShellCorners& from, const VecX& by) {
    ShellCorners corners;
    for (std::size_t a = 0; a < 3; ++a) {
        const Eigen::Index i = static_cast<Eigen::Index>(6 * a);
        corners.position[a] = from.position[a] + by.segment<3>(i);
        corners.rotation[a] = cayley(by.segment<3>(i + 3)) * from.rotation[a];
    }
    return corners;
}

void check_derivatives(const ShellTriangle& triangle, const ShellCorners& corners, const Vec18& gradient,
                       const Mat18& hessian) {
    const auto energy = [&](const VecX& by) {
        return VecX(VecX::Constant(1, shell_energy(triangle, moved(corners, by))));
    };
    const auto slope = [&](const VecX& by) {
        Vec18 there;
        shell_gradient(triangle, moved(corners, by), there);
        return VecX(there);
    };
    const VecX none = VecX::Zero(18);
    CHECK(rhexis::test::derivative_error(energy, none, gradient.transpose(), 1e-3) < 1e-6);
    const MatX rate = rhexis::test::finite_difference(slope, none, 1e-3);
    const MatX symmetric = 0.5 * (rate + rate.transpose());
    CHECK((symmetric - hessian).cwiseAbs().maxCoeff() < 1e-6 * hessian.cwiseAbs().maxCoeff());
}

}  // namespace

TEST_SUITE("shell triangle") {
    TEST_CASE("turned as a whole by any angle it is at rest") {
        Rng rng(1, "turns");
        const ShellTriangle triangle = sample();
        for (int i = 0; i < 30; ++i) {
            Vec18 gradient;
            const double energy = shell_gradient(triangle, deformed(rng, 0.0), gradient);
            CHECK(energy < 1e-18);
            CHECK(gradient.cwiseAbs().maxCoeff() < 1e-8);  // of 1e5 uN/mm
        }
    }

    TEST_CASE("gradient and tangent are derivatives, by differences, however far it has turned and bent") {
        Rng rng(2, "states");
        for (const double size : {0.05, 0.3, 0.8}) {
            for (int i = 0; i < 20; ++i) {
                const ShellTriangle triangle = sample(i % 2 == 0 ? 0.42 : 0.0);
                const ShellCorners corners = deformed(rng, size);
                Vec18 gradient;
                Mat18 hessian;
                shell_hessian(triangle, corners, ShellTangent::consistent, gradient, hessian);
                check_derivatives(triangle, corners, gradient, hessian);
                CHECK((hessian - hessian.transpose()).cwiseAbs().maxCoeff() < 1e-12 * hessian.cwiseAbs().maxCoeff());
                Vec18 alone;
                shell_gradient(triangle, corners, alone);
                CHECK(alone == gradient);
            }
        }
    }

    TEST_CASE(
        "with a natural deformation of its own gradient and tangent still are derivatives, and turning changes "
        "nothing") {
        Rng rng(7, "natural");
        for (int i = 0; i < 20; ++i) {
            ShellTriangle triangle = sample();
            for (double& number : triangle.natural) {
                number = 0.4 * rng.uniform() - 0.2;
            }
            const ShellCorners corners = deformed(rng, 0.3);
            Vec18 gradient;
            Mat18 hessian;
            shell_hessian(triangle, corners, ShellTangent::consistent, gradient, hessian);
            check_derivatives(triangle, corners, gradient, hessian);
            const Vec15 d = shell_deformation(triangle, corners);
            CHECK(0.5 * shell_product(triangle, d - triangle.natural, d - triangle.natural) ==
                  doctest::Approx(shell_energy(triangle, corners)).epsilon(1e-12));
            ShellCorners elsewhere;
            const Mat3 turn = any_turn(rng);
            for (std::size_t a = 0; a < 3; ++a) {
                elsewhere.position[a] = turn * corners.position[a] + Vec3(-1.0, 2.0, 0.5);
                elsewhere.rotation[a] = turn * corners.rotation[a];
            }
            CHECK((shell_deformation(triangle, elsewhere) - d).cwiseAbs().maxCoeff() < 1e-12);
            CHECK(shell_energy(triangle, elsewhere) == doctest::Approx(shell_energy(triangle, corners)).epsilon(1e-12));
            triangle.natural = d;
            CHECK(shell_gradient(triangle, corners, gradient) == 0.0);
            CHECK(gradient.isZero(0.0));
        }
    }

    TEST_CASE("forces and moments of a triangle balance") {
        Rng rng(3, "states");
        for (int i = 0; i < 20; ++i) {
            const ShellCorners corners = deformed(rng, 0.4);
            Vec18 gradient;
            shell_gradient(sample(), corners, gradient);
            Vec3 force = Vec3::Zero();
            Vec3 moment = Vec3::Zero();
            for (std::size_t a = 0; a < 3; ++a) {
                const Vec3 own = gradient.segment<3>(static_cast<Eigen::Index>(6 * a));
                force += own;
                moment += corners.position[a].cross(own) + gradient.segment<3>(static_cast<Eigen::Index>(6 * a + 3));
            }
            CHECK(force.norm() < 1e-11 * gradient.norm());
            CHECK(moment.norm() < 1e-11 * gradient.norm());
        }
    }

    TEST_CASE("the definite tangent gives no energy back, and is the consistent one at rest") {
        Rng rng(4, "states");
        const ShellTriangle triangle = sample();
        for (int i = 0; i < 30; ++i) {
            Vec18 gradient;
            Mat18 definite;
            shell_hessian(triangle, deformed(rng, 0.5), ShellTangent::definite, gradient, definite);
            const VecX values = scenes::eigenvalues(definite);
            CHECK(values[0] > -1e-12 * values[17]);
            const ShellCorners rest = deformed(rng, 0.0);
            Mat18 consistent;
            shell_hessian(triangle, rest, ShellTangent::definite, gradient, definite);
            shell_hessian(triangle, rest, ShellTangent::consistent, gradient, consistent);
            CHECK((definite - consistent).cwiseAbs().maxCoeff() < 1e-10 * consistent.cwiseAbs().maxCoeff());
        }
    }

    TEST_CASE("energy does not depend on the numbering, the frame or where it is (T8)") {
        Rng rng(5, "states");
        for (int i = 0; i < 40; ++i) {
            const ShellCorners c = deformed(rng, 0.4);
            const double energy = shell_energy(sample(), c);
            const ShellTriangle shifted =
                shell_triangle({rest_points[2], rest_points[0], rest_points[1]}, thickness, young, 0.42);
            const ShellCorners same{{c.position[2], c.position[0], c.position[1]},
                                    {c.rotation[2], c.rotation[0], c.rotation[1]}};
            CHECK(shell_energy(shifted, same) == doctest::Approx(energy).epsilon(1e-12));
            const ShellTriangle flipped =
                shell_triangle({rest_points[1], rest_points[0], rest_points[2]}, thickness, young, 0.42);
            const ShellCorners mirrored{{c.position[1], c.position[0], c.position[2]},
                                        {c.rotation[1], c.rotation[0], c.rotation[2]}};
            CHECK(shell_energy(flipped, mirrored) == doctest::Approx(energy).epsilon(1e-12));
            const Mat3 turn = any_turn(rng);
            ShellCorners turned;
            for (std::size_t a = 0; a < 3; ++a) {
                turned.position[a] = turn * c.position[a];
                turned.rotation[a] = turn * c.rotation[a];
            }
            CHECK(shell_energy(sample(), turned) == doctest::Approx(energy).epsilon(1e-12));
        }
    }

    TEST_CASE("patch test through a large turn: stretched the same everywhere, nothing pulls within") {
        const std::vector<Vec3> nodes{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0},   {1.0, 1.0, 0.0},
                                      {0.0, 1.0, 0.0}, {0.37, 0.58, 0.0}, {0.62, 0.0, 0.0}};
        const std::vector<std::array<int, 3>> triangles{{0, 5, 4}, {5, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
        Rng rng(6, "stretch");
        for (int i = 0; i < 10; ++i) {
            Mat3 stretch = Mat3::Identity();
            stretch(0, 0) += 0.2 * rng.uniform();
            stretch(1, 1) -= 0.1 * rng.uniform();
            stretch(0, 1) = stretch(1, 0) = 0.1 * rng.uniform();
            const Mat3 turn = any_turn(rng);
            Vec6 inner = Vec6::Zero();
            double largest = 0.0;
            for (const std::array<int, 3>& t : triangles) {
                Points rest;
                ShellCorners corners;
                for (std::size_t a = 0; a < 3; ++a) {
                    rest[a] = nodes[static_cast<std::size_t>(t[a])];
                    corners.position[a] = turn * stretch * rest[a];
                    corners.rotation[a] = turn;
                }
                Vec18 gradient;
                shell_gradient(shell_triangle(rest, thickness, young, 0.42), corners, gradient);
                largest = std::max(largest, gradient.cwiseAbs().maxCoeff());
                for (std::size_t a = 0; a < 3; ++a) {
                    inner +=
                        t[a] == 4 ? Vec6(gradient.segment<6>(static_cast<Eigen::Index>(6 * a))) : Vec6(Vec6::Zero());
                }
            }
            CHECK(inner.cwiseAbs().maxCoeff() < 1e-10 * largest);
        }
    }

    TEST_CASE("numbers stay finite where a triangle has collapsed or a corner has turned half round") {
        Rng rng(7, "collapsed");
        const ShellTriangle triangle = sample();
        for (const Points& x : {Points{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)},
                                Points{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}}) {
            Vec18 gradient;
            CHECK(std::isfinite(shell_gradient(triangle, {x, {}}, gradient)));
        }
        ShellCorners half{rest_points, {}};
        half.rotation[0] = Eigen::AngleAxisd(M_PI, Vec3::UnitX()).toRotationMatrix();
        Vec18 gradient;
        CHECK(std::isfinite(shell_gradient(triangle, half, gradient)));
        CHECK(gradient.allFinite());
    }
}
