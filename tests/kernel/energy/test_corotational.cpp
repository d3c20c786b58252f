// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

#include "base/rng.hpp"
#include "energy/corotational_tet.hpp"
#include "math/random_vectors.hpp"
#include "scenes/eigenvalues.hpp"
#include "support/finite_difference.hpp"

using namespace rhexis;

namespace {

const TetPoints rest_points{Vec3(0.1, 0.0, 0.0), Vec3(0.8, 0.1, -0.05), Vec3(0.0, 0.7, 0.1), Vec3(0.2, 0.15, 0.9)};

TetPoints moved(const Mat3& map, const Vec3& shift = Vec3::Zero()) {
    TetPoints x;
    for (std::size_t a = 0; a < 4; ++a) {
        x[a] = map * rest_points[a] + shift;
    }
    return x;
}

VecX flat(const TetPoints& x) {
    VecX result(12);
    result << x[0], x[1], x[2], x[3];
    return result;
}

TetPoints unflat(const VecX& v) {
    return {Vec3(v.segment<3>(0)), Vec3(v.segment<3>(3)), Vec3(v.segment<3>(6)), Vec3(v.segment<3>(9))};
}

Mat3 strain_of(Rng& rng, double size) {
    Mat3 m = Mat3::Identity();
    for (int i = 0; i < 9; ++i) {
        m.data()[i] += size * (2.0 * rng.uniform() - 1.0);
    }
    return m;
}

Mat3 turn(double degrees, const Vec3& axis) {
    return Eigen::AngleAxisd(degrees * M_PI / 180.0, axis.normalized()).toRotationMatrix();
}

/// Maps to test at: stretched, sheared, turned by much, compressed, inverted.
std::vector<Mat3> sample_maps() {
    Rng rng(7, "maps");
    std::vector<Mat3> maps;
    for (int k = 0; k < 20; ++k) {
        maps.push_back(turn(9.0 * k, Vec3(1.0, 0.3 * k, -0.5)) * strain_of(rng, 0.3));
    }
    maps.push_back(turn(70.0, Vec3(1, 1, 0)) * Vec3(0.5, 0.6, 0.7).asDiagonal());
    maps.push_back(turn(70.0, Vec3(1, 1, 0)) * Vec3(1.9, 1.6, 1.4).asDiagonal());
    maps.push_back(turn(30.0, Vec3(0, 1, 1)) * Vec3(1.1, 0.9, -0.4).asDiagonal());
    return maps;
}

const Lame material = lame(3000.0, 0.45);

}  // namespace

TEST_SUITE("energy") {
    TEST_CASE("a corotational tetrahedron at rest, moved and turned, has neither energy nor force") {
        const RestTet tet = rest_tet(rest_points);
        for (const double degrees : {0.0, 35.0, 120.0, 180.0}) {
            const TetPoints x = moved(turn(degrees, Vec3(1, -2, 0.5)), Vec3(3, -4, 5));
            CHECK(std::abs(corotational_tet_energy(tet, material, x)) < 1e-20);
            CHECK(corotational_tet_gradient(tet, material, x).norm() < 1e-9);
        }
    }

    TEST_CASE("the gradient of a corotational tetrahedron is the derivative of its energy") {
        const RestTet tet = rest_tet(rest_points);
        const auto energy = [&](const VecX& v) {
            return VecX::Constant(1, corotational_tet_energy(tet, material, unflat(v)));
        };
        for (const Mat3& map : sample_maps()) {
            const TetPoints x = moved(map);
            const MatX closed = corotational_tet_gradient(tet, material, x).transpose();
            CHECK(test::derivative_error(energy, flat(x), closed, 1e-3) < 1e-6);
        }
    }

    TEST_CASE("the consistent tangent of a corotational tetrahedron is the derivative of its gradient") {
        const RestTet tet = rest_tet(rest_points);
        const auto gradient = [&](const VecX& v) { return VecX(corotational_tet_gradient(tet, material, unflat(v))); };
        for (const Mat3& map : sample_maps()) {
            const TetPoints x = moved(map);
            const Mat12 closed = corotational_tet_hessian(tet, material, x, Tangent::consistent);
            CHECK(test::derivative_error(gradient, flat(x), closed, 2e-4) < 1e-6);
            CHECK((closed - closed.transpose()).norm() < 1e-12 * closed.norm());
        }
    }

    TEST_CASE(
        "warped and projected tangents are positive semidefinite and agree with the consistent one where they can") {
        const RestTet tet = rest_tet(rest_points);
        for (const Mat3& map : sample_maps()) {
            const TetPoints x = moved(map);
            const Mat12 consistent = corotational_tet_hessian(tet, material, x, Tangent::consistent);
            for (const Tangent kind : {Tangent::warped, Tangent::projected}) {
                const Mat12 k = corotational_tet_hessian(tet, material, x, kind);
                CHECK((k - k.transpose()).norm() < 1e-12 * k.norm());
                const double least = scenes::eigenvalues(k)[0];
                CHECK(least > -1e-12 * k.norm());
            }
            // the projection drops exactly the negative part of the consistent tangent's twist modes: it can only add
            const Mat12 added = corotational_tet_hessian(tet, material, x, Tangent::projected) - consistent;
            const double least = scenes::eigenvalues(added)[0];
            CHECK(least > -1e-9 * consistent.norm());
        }
        const Mat12 stretched =
            corotational_tet_hessian(tet, material, moved(1.2 * Mat3::Identity()), Tangent::projected);
        const Mat12 same = corotational_tet_hessian(tet, material, moved(1.2 * Mat3::Identity()), Tangent::consistent);
        CHECK((stretched - same).norm() < 1e-12 * same.norm());
    }

    TEST_CASE("the change of stress is what the blocks of the tangent say") {
        Rng rng(11, "blocks");
        const CorotationalPoint point = corotational_point(turn(50.0, Vec3(1, 2, 3)) * strain_of(rng, 0.3));
        for (const Tangent kind : {Tangent::consistent, Tangent::warped, Tangent::projected}) {
            const CorotationalTangent tangent = corotational_tangent(point, material, kind);
            const Vec3 a(0.3, -1.0, 0.7);
            const Vec3 b(-0.4, 0.2, 1.1);
            const Vec3 u(0.5, 0.25, -2.0);
            const Vec3 by_block = tangent.block(a, b) * u;
            const Vec3 by_stress = tangent.stress_change(u * b.transpose()) * a;
            CHECK((by_block - by_stress).norm() < 1e-12 * by_block.norm());
        }
    }

    TEST_CASE("the energy of a strained tetrahedron does not change when it is turned by 10 to 170 degrees") {
        const RestTet tet = rest_tet(rest_points);
        Rng rng(8, "invariance");
        for (int degrees = 10; degrees <= 170; degrees += 10) {
            const Mat3 strain = strain_of(rng, 0.3);
            const double at_first = corotational_tet_energy(tet, material, moved(strain));
            const Vec3 axis = normal3(rng);
            const double turned = corotational_tet_energy(tet, material, moved(turn(degrees, axis) * strain));
            CHECK(std::abs(turned - at_first) < 1e-12 * at_first);
        }
    }

    TEST_CASE("an inverted tetrahedron is pushed back out with a finite force") {
        const RestTet tet = rest_tet(rest_points);
        for (const double stretch : {-0.05, -0.3, -0.8}) {
            const Mat3 map = Vec3(1.0, 1.0, stretch).asDiagonal();
            const Vec12 gradient = corotational_tet_gradient(tet, material, moved(map));
            CHECK(gradient.allFinite());
            // energy falls as the element is opened along the inverted axis
            const Mat3 opening = Vec3(0.0, 0.0, 1.0).asDiagonal();
            CHECK(gradient.dot(Vec12(flat(moved(opening)))) < 0.0);
            CHECK(gradient.norm() < 1e5);
        }
    }

    TEST_CASE("a share of load follows the fraction left, stops at its floor, and ends with the element") {
        CHECK(load_bearing_share(1.0, 0.02) == 1.0);
        CHECK(load_bearing_share(0.5, 0.02) == 0.5);
        CHECK(load_bearing_share(0.001, 0.02) == 0.02);
        CHECK(load_bearing_share(0.0, 0.02) == 0.0);
    }
}
