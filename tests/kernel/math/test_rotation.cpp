// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <vector>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "math/rotation.hpp"
#include "math/symmetric_eigen.hpp"

using namespace rhexis;

namespace {

struct Reference {
    Mat3 rotation;
    double gap = 0.0;  ///< smallest sum of two signed stretches over |F|: distance from the singular set
};

Reference by_svd(const Mat3& f) {
    const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Mat3 u = svd.matrixU();
    const Mat3 v = svd.matrixV();
    const double sign = (u * v.transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    u.col(2) *= sign;
    return {u * v.transpose(), (svd.singularValues()[1] + sign * svd.singularValues()[2]) / f.norm()};
}

Mat3 random_matrix(Rng& rng) {
    Mat3 m;
    for (int i = 0; i < 9; ++i) {
        m.data()[i] = 2.0 * rng.uniform() - 1.0;
    }
    return m;
}

Mat3 random_rotation(Rng& rng, double degrees) {
    const Vec3 axis = normal3(rng).normalized();
    return Eigen::AngleAxisd(degrees * M_PI / 180.0, axis).toRotationMatrix();
}

double error(const Mat3& f) {
    const Reference reference = by_svd(f);
    return (polar_rotation(f) - reference.rotation).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_SUITE("math") {
    TEST_CASE("the rotation of strained and turned matrices is that of the singular value decomposition") {
        Rng rng(1, "rotation");
        double worst = 0.0;
        for (int degrees = 0; degrees <= 180; degrees += 5) {
            for (int k = 0; k < 50; ++k) {
                const Mat3 strain = Mat3::Identity() + 0.3 * random_matrix(rng);
                worst = std::max(worst, error(random_rotation(rng, degrees) * strain));
            }
        }
        CHECK(worst < 1e-12);
    }

    TEST_CASE("the rotation of any matrix away from the singular set is that of the singular value decomposition") {
        Rng rng(2, "rotation");
        int inverted = 0;
        int checked = 0;
        double worst = 0.0;
        for (int k = 0; k < 20000; ++k) {
            const Mat3 f = random_matrix(rng) * std::pow(10.0, 6.0 * rng.uniform() - 3.0);
            if (by_svd(f).gap < 0.05) {
                continue;
            }
            ++checked;
            inverted += f.determinant() < 0.0 ? 1 : 0;
            worst = std::max(worst, error(f));
        }
        CHECK(checked > 10000);
        CHECK(inverted > 3000);
        CHECK(worst < 1e-12);
    }

    TEST_CASE("the rotation of a flat matrix is that of its plane") {
        Rng rng(3, "rotation");
        double worst = 0.0;
        for (int k = 0; k < 1000; ++k) {
            const Vec2 above_half = uniform2(rng);
            const Vec3 stretches(0.5 + above_half.x(), 0.5 + above_half.y(), 0.0);
            const Mat3 v = random_rotation(rng, 180.0 * rng.uniform());
            const Mat3 r = random_rotation(rng, 180.0 * rng.uniform());
            const Mat3 f = r * v * stretches.asDiagonal() * v.transpose();
            worst = std::max(worst, (polar_rotation(f) - r).cwiseAbs().maxCoeff());
        }
        CHECK(worst < 1e-12);
    }

    TEST_CASE("on the singular set the result is a rotation that makes the stretch symmetric, near the previous one") {
        Rng rng(4, "rotation");
        for (int k = 0; k < 200; ++k) {
            const double s = 0.2 + rng.uniform();
            const Mat3 v = random_rotation(rng, 180.0 * rng.uniform());
            // two stretches cancel: any rotation about the first axis is as good as any other
            const Vec3 exact(0.2 + rng.uniform() + s, s, -s * (1.0 + (k % 2 == 0 ? 0.0 : 1e-9)));
            const Mat3 previous = random_rotation(rng, 5.0);
            const Mat3 f = v * exact.asDiagonal() * v.transpose();
            const Mat3 r = polar_rotation(f, previous);
            CHECK((r.transpose() * r - Mat3::Identity()).norm() < 1e-13);
            CHECK(r.determinant() > 0.0);
            CHECK(skew_vector(r.transpose() * f).norm() < 1e-8);
            CHECK(r.cwiseProduct(f).sum() == doctest::Approx(exact.sum()).epsilon(1e-8));
        }
        const Mat3 turned = random_rotation(rng, 77.0);
        CHECK(polar_rotation(Mat3::Zero(), turned) == turned);
        CHECK(polar_rotation(1e-200 * turned, turned).allFinite());
        const Vec3 line(1.0, 0.0, 0.0);
        CHECK((polar_rotation(turned * line.asDiagonal(), turned) - turned).norm() < 1e-8);
    }

    TEST_CASE("eigenvectors of a symmetric matrix are orthogonal and rebuild it, also with equal eigenvalues") {
        Rng rng(5, "eigen");
        for (int k = 0; k < 300; ++k) {
            const Mat3 v = random_rotation(rng, 180.0 * rng.uniform());
            const Vec3 values(rng.normal(), k % 3 == 0 ? 0.5 : rng.normal(), k % 3 == 0 ? 0.5 : 1e-12);
            const Mat3 matrix = v * values.asDiagonal() * v.transpose();
            const SymmetricEigen3 eigen = symmetric_eigen(matrix);
            CHECK((eigen.vectors.transpose() * eigen.vectors - Mat3::Identity()).norm() < 1e-14);
            const Mat3 rebuilt = eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose();
            CHECK((rebuilt - matrix).norm() < 1e-13);
        }
    }

    TEST_CASE("the turn that lays the z axis along a direction is the shortest one, also for -z") {
        Rng rng(6, "directions");
        for (int i = 0; i < 200; ++i) {
            const Vec3 d = uniform3(rng) - Vec3::Constant(0.5);
            const Quat turn = turn_of_z(d);
            CHECK((turn * Vec3::UnitZ() - d.normalized()).norm() < 1e-14);
            CHECK(std::abs(turn.z()) < 1e-15);  // its axis lies across z
        }
        for (const Vec3& d : {Vec3(0.0, 0.0, 2.0), Vec3(0.0, 0.0, -2.0), Vec3(1e-9, 0.0, -1.0)}) {
            CHECK((turn_of_z(d) * Vec3::UnitZ() - d.normalized()).norm() < 1e-8);
            CHECK(turn_of_z(d).norm() == doctest::Approx(1.0));
        }
    }

    TEST_CASE("the Cayley map is a rotation that matches the angle to third order") {
        const Vec3 w(0.01, -0.02, 0.015);
        const Mat3 exact = Eigen::AngleAxisd(w.norm(), w.normalized()).toRotationMatrix();
        CHECK((cayley(w) - exact).norm() < std::pow(w.norm(), 3));
        CHECK((cayley(w).transpose() * cayley(w) - Mat3::Identity()).norm() < 1e-15);
    }
}
