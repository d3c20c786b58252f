// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

#include "base/rng.hpp"
#include "energy/membrane_triangle.hpp"
#include "energy/metric_strain.hpp"
#include "energy/orthotropic.hpp"
#include "math/random_vectors.hpp"
#include "scenes/eigenvalues.hpp"
#include "support/finite_difference.hpp"

using namespace rhexis;

namespace {

const TrianglePoints rest_points{Vec3(0.1, 0.0, 0.2), Vec3(0.9, 0.1, 0.25), Vec3(0.2, 0.7, 0.1)};
const Orthotropic fibrous{1.0e6, 2.5e5, 0.45, 0.0};

Vec2 at_angle(double degrees) { return {std::cos(degrees * M_PI / 180.0), std::sin(degrees * M_PI / 180.0)}; }

MembraneTriangle triangle_of(const TrianglePoints& rest, const Vec3& fibre, const Orthotropic& material,
                             double compression) {
    const PlaneFrame frame = plane_frame(rest);
    const double area = 0.5 * (rest[1] - rest[0]).cross(rest[2] - rest[0]).norm();
    return {shape_gradients(rest, frame), 0.01 * area, plane_stiffness(material, frame.to_plane(fibre).normalized()),
            compression};
}

VecX flat(const TrianglePoints& x) {
    VecX result(9);
    result << x[0], x[1], x[2];
    return result;
}

TrianglePoints unflat(const VecX& v) { return {Vec3(v.segment<3>(0)), Vec3(v.segment<3>(3)), Vec3(v.segment<3>(6))}; }

TrianglePoints moved(const Mat3& map) {
    TrianglePoints x;
    for (std::size_t a = 0; a < 3; ++a) {
        x[a] = map * rest_points[a] + Vec3(0.3, -0.2, 0.5);
    }
    return x;
}

Mat3 random_map(Rng& rng, double size) {
    Mat3 m = Mat3::Identity();
    for (int i = 0; i < 9; ++i) {
        m.data()[i] += size * (2.0 * rng.uniform() - 1.0);
    }
    const Vec2 beside = uniform2(rng);
    return Eigen::AngleAxisd(3.0 * rng.uniform(), Vec3(beside.x(), 1.0, -beside.y()).normalized()) * m;
}

MatX full(const TriangleBlocks& blocks) {
    MatX result(9, 9);
    std::size_t slot = 0;
    for (int a = 0; a < 3; ++a) {
        for (int b = a; b < 3; ++b, ++slot) {
            result.block<3, 3>(3 * a, 3 * b) = blocks[slot];
            result.block<3, 3>(3 * b, 3 * a) = blocks[slot].transpose();
        }
    }
    return result;
}

}  // namespace

TEST_SUITE("orthotropic sheet") {
    TEST_CASE("stiffness is that of the rotated matrix, and positive for every angle of the fibre (T7)") {
        for (const Orthotropic& material :
             {fibrous, Orthotropic{1e6, 1e5, 0.3, 2e5}, Orthotropic{2e5, 1e6, 0.2, 0.0}, isotropic(1e6, 0.47)}) {
            const Mat3 own = plane_stiffness(material, Vec2(1.0, 0.0));
            for (int angle = 0; angle <= 180; ++angle) {
                const Vec2 f = at_angle(angle);
                const double c = f.x();
                const double s = f.y();
                Mat3 turn;  // strain in the frame of the fibre from that in the frame
                turn << c * c, s * s, c * s, s * s, c * c, -c * s, -2.0 * c * s, 2.0 * c * s, c * c - s * s;
                const Mat3 k = plane_stiffness(material, f);
                CHECK((k - turn.transpose() * own * turn).cwiseAbs().maxCoeff() < 1e-15 * own.norm() * 10.0);
                CHECK(scenes::eigenvalues(k)[0] > 0.0);
            }
        }
    }

    TEST_CASE("as printed in [Dequidt2013] the matrix gives energy back for some strains") {
        const double e_f = fibrous.along;
        const double e_t = fibrous.across;
        const double g = e_f / (1.0 + fibrous.poisson_ratio);
        const double n = fibrous.poisson_ratio * e_t;
        int indefinite = 0;
        for (int angle = 0; angle <= 90; ++angle) {
            const double c = at_angle(angle).x();
            const double s = at_angle(angle).y();
            const double c2 = c * c;
            const double s2 = s * s;
            Mat3 k;
            k(0, 0) = c2 * c2 * e_f + s2 * s2 * e_t + 2.0 * c2 * s2 * (n + 2.0 * g);
            k(1, 1) = s2 * s2 * e_f + c2 * c2 * e_t + 2.0 * c2 * s2 * (n + 2.0 * g);
            k(2, 2) = c2 * s2 * (e_f + e_t - 2.0 * n) + (c2 - s2) * g;
            k(0, 1) = k(1, 0) = c2 * s2 * (e_f + e_t - 4.0 * g) + (c2 * c2 + s2 * s2) * n;
            k(0, 2) = k(2, 0) = -c * s * (c2 * e_f - s2 * e_t - (c2 - s2) * (n + 2.0 * g));
            k(1, 2) = k(2, 1) = -c * s * (s2 * e_f - c2 * e_t + (c2 - s2) * (n + 2.0 * g));
            indefinite += scenes::eigenvalues(k)[0] < 0.0 ? 1 : 0;
        }
        CHECK(indefinite > 30);
    }

    TEST_CASE("modulus off the fibre's axis: the closed form, and its table") {
        // E / E_across with the harmonic shear modulus, ratio 4 and 10, every 15 degrees
        const double four[7] = {4.0, 3.331, 2.286, 1.6, 1.231, 1.053, 1.0};
        const double ten[7] = {10.0, 6.239, 3.077, 1.818, 1.290, 1.064, 1.0};
        for (int i = 0; i < 7; ++i) {
            const double angle = i * M_PI / 12.0;
            CHECK(off_axis_modulus({4.0e5, 1.0e5, 0.45, 0.0}, angle) / 1e5 == doctest::Approx(four[i]).epsilon(5e-4));
            CHECK(off_axis_modulus({1.0e6, 1.0e5, 0.45, 0.0}, angle) / 1e5 == doctest::Approx(ten[i]).epsilon(5e-4));
            const Mat3 compliance = plane_stiffness(fibrous, at_angle(-15.0 * i)).inverse();
            CHECK(1.0 / compliance(0, 0) == doctest::Approx(off_axis_modulus(fibrous, angle)).epsilon(1e-12));
        }
    }

    TEST_CASE("an isotropic sheet has the same stiffness whatever the fibre") {
        const Orthotropic harmonic{1e6, 1e6, 0.3, 0.0};
        const Mat3 k = plane_stiffness(isotropic(1e6, 0.3), Vec2(1.0, 0.0));
        for (int angle = 0; angle < 180; angle += 15) {
            CHECK((plane_stiffness(harmonic, at_angle(angle)) - k).norm() < 1e-9);
        }
    }

    TEST_CASE("inadmissible material is refused, with field and range") {
        const auto refused = [](const Orthotropic& m, const std::string& part) {
            const Status status = check_orthotropic(m, "capsule");
            CHECK_FALSE(status.ok());
            if (!status.ok()) {
                CHECK(status.error().text().find(part) != std::string::npos);
                CHECK(status.error().text().find("capsule") != std::string::npos);
            }
        };
        refused({0.0, 1e6, 0.3, 0.0}, "along");
        refused({1e6, -1.0, 0.3, 0.0}, "across");
        refused({1e6, 1e6, 0.3, -5.0}, "shear_modulus");
        refused({1e6, 4e6, 0.5, 0.0}, "poisson_ratio is 0.5");
        refused({1e6, 1e6, std::nan(""), 0.0}, "poisson_ratio");
        refused({1e6, std::nan(""), 0.3, 0.0}, "across");
        CHECK(check_orthotropic({4e6, 1e6, 1.9, 1e5}, "capsule").ok());
    }
}

TEST_SUITE("membrane triangle") {
    TEST_CASE("strain of a metric: value at a stretch, derivatives by differences") {
        MetricStrain s;
        metric_strain(Vec3(1.0, 1.0, 0.0), s);
        CHECK(s.strain.norm() < 1e-15);
        metric_strain(Vec3(1.44, 0.81, 0.0), s);
        CHECK((s.strain - Vec3(0.2, -0.1, 0.0)).norm() < 1e-6);
        Rng rng(3, "metrics");
        for (int i = 0; i < 50; ++i) {
            const Mat3 map = random_map(rng, 0.4);
            const Vec3 c(map.col(0).squaredNorm(), map.col(1).squaredNorm(), map.col(0).dot(map.col(1)));
            metric_strain_twice(c, s);
            const auto value = [](const VecX& v) {
                MetricStrain there;
                metric_strain(Vec3(v), there);
                return VecX(there.strain);
            };
            CHECK(rhexis::test::derivative_error(value, c, s.first, 1e-4) < 1e-7);
            for (int k = 0; k < 3; ++k) {
                const auto row = [k](const VecX& v) {
                    MetricStrain there;
                    metric_strain(Vec3(v), there);
                    return VecX(there.first.row(k).transpose());
                };
                CHECK(rhexis::test::derivative_error(row, c, s.second[static_cast<std::size_t>(k)], 1e-4) < 1e-5);
            }
        }
    }

    TEST_CASE("energy of a sheet that wrinkles: stress and tangent by differences, no compression, convex") {
        Rng rng(5, "strains");
        int states[3] = {0, 0, 0};
        for (int i = 0; i < 300; ++i) {
            const Mat3 k = plane_stiffness(i % 2 == 0 ? fibrous : isotropic(1e6, 0.45), at_angle(7.0 * i));
            const Vec3 e = 0.1 * (2.0 * uniform3(rng) - Vec3::Ones());
            const TensionField field = tension_field(e, k, 1e-3);
            ++states[static_cast<int>(field.state)];
            const auto energy = [&](const VecX& v) {
                return VecX(VecX::Constant(1, tension_field(Vec3(v), k, 1e-3).energy));
            };
            const auto stress = [&](const VecX& v) { return VecX(tension_field(Vec3(v), k, 1e-3).stress); };
            CHECK(rhexis::test::derivative_error(energy, e, field.stress.transpose(), 1e-6) < 1e-5);
            CHECK(rhexis::test::derivative_error(stress, e, field.tangent, 1e-6) < 1e-3);  // kinks between states
            const Mat3 symmetric = 0.5 * (field.tangent + field.tangent.transpose());
            CHECK((symmetric - field.tangent).norm() < 1e-9 * field.tangent.norm());
            CHECK(scenes::eigenvalues(symmetric)[0] > 0.0);
            Mat2 s;
            s << field.stress[0], field.stress[2], field.stress[2], field.stress[1];
            const double least = scenes::eigenvalues(s)[0];
            CHECK(least > -2e-3 * (k * e).norm());
            CHECK(field.energy <= 0.5 * e.dot(k * e) * (1.0 + 1e-12));
        }
        CHECK(states[0] > 20);
        CHECK(states[1] > 20);
        CHECK(states[2] > 20);
    }

    TEST_CASE("forces and stiffness by differences: taut, wrinkled, slack, folded flat") {
        Rng rng(9, "maps");
        for (int i = 0; i < 120; ++i) {
            const Orthotropic& material = i % 2 == 0 ? fibrous : isotropic(1e6, 0.45);
            const MembraneTriangle triangle = triangle_of(rest_points, Vec3(1.0, 0.2 * i, 0.1), material, 1e-3);
            const TrianglePoints x = moved(random_map(rng, 0.3));
            TrianglePoints force;
            TriangleBlocks blocks;
            const double energy = membrane_stiffness(triangle, x, MembraneTangent::consistent, force, blocks);
            CHECK(energy == doctest::Approx(membrane_forces(triangle, x, force)).epsilon(1e-13));
            const auto value = [&](const VecX& v) {
                TrianglePoints f;
                return VecX(VecX::Constant(1, membrane_forces(triangle, unflat(v), f)));
            };
            const auto pull = [&](const VecX& v) {
                TrianglePoints f;
                membrane_forces(triangle, unflat(v), f);
                return VecX(-flat(f));
            };
            CHECK(rhexis::test::derivative_error(value, flat(x), -flat(force).transpose(), 1e-6) < 1e-5);
            CHECK(rhexis::test::derivative_error(pull, flat(x), full(blocks), 1e-6) < 1e-3);
            membrane_stiffness(triangle, x, MembraneTangent::definite, force, blocks);
            const MatX definite = full(blocks);
            CHECK(scenes::eigenvalues(definite)[0] > -1e-9 * definite.norm());
        }
        const MembraneTriangle triangle = triangle_of(rest_points, Vec3(1.0, 0.3, 0.1), fibrous, 1e-3);
        TrianglePoints force;
        TriangleBlocks blocks;
        for (const TrianglePoints& x : {TrianglePoints{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)},
                                        TrianglePoints{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)},
                                        TrianglePoints{Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(0.5, 0, 0)}}) {
            CHECK(std::isfinite(membrane_stiffness(triangle, x, MembraneTangent::consistent, force, blocks)));
            CHECK(full(blocks).allFinite());
            CHECK(flat(force).allFinite());
        }
    }

    TEST_CASE("energy does not depend on the numbering, the frame or where it is (T8)") {
        Rng rng(11, "maps");
        for (int i = 0; i < 40; ++i) {
            const Vec3 fibre(1.0, 0.1 * i, -0.2);
            const TrianglePoints x = moved(random_map(rng, 0.3));
            TrianglePoints force;
            const double energy = membrane_forces(triangle_of(rest_points, fibre, fibrous, 1e-3), x, force);
            const TrianglePoints renumbered{rest_points[2], rest_points[0], rest_points[1]};
            const double again =
                membrane_forces(triangle_of(renumbered, fibre, fibrous, 1e-3), {x[2], x[0], x[1]}, force);
            CHECK(again == doctest::Approx(energy).epsilon(1e-12));
            const Mat3 turn = Eigen::AngleAxisd(1.1 * i, Vec3(1, 2, 0.5).normalized()).toRotationMatrix();
            const double turned = membrane_forces(triangle_of(rest_points, fibre, fibrous, 1e-3),
                                                  {turn * x[0], turn * x[1], turn * x[2]}, force);
            CHECK(turned == doctest::Approx(energy).epsilon(1e-12));
        }
    }
}
