// SPDX-License-Identifier: GPL-3.0-or-later
// The plate and the membrane of the shell triangle by themselves: linear, in a plane.
#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "base/index.hpp"
#include "energy/dkt_plate.hpp"
#include "energy/drilling_membrane.hpp"
#include "scenes/eigenvalues.hpp"

using namespace rhexis;

namespace {

/// A square of 1 mm with one node within, in no symmetric place, and one at a side.
struct Patch {
    std::vector<Vec2> nodes{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.37, 0.58}, {0.62, 0.0}};
    std::vector<std::array<int, 3>> triangles{{0, 5, 4}, {5, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    static constexpr int inner = 4;

    [[nodiscard]] PlaneCorners corners(std::size_t t) const {
        return {nodes[at(triangles[t][0])], nodes[at(triangles[t][1])], nodes[at(triangles[t][2])]};
    }
};

template <typename Stiffness>
MatX assembled(const std::vector<std::array<int, 3>>& triangles, std::size_t nodes, const Stiffness& stiffness) {
    const Eigen::Index n = static_cast<Eigen::Index>(3 * nodes);
    MatX k = MatX::Zero(n, n);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Mat9 own = stiffness(t);
        for (int i = 0; i < 9; ++i) {
            for (int j = 0; j < 9; ++j) {
                k(3 * triangles[t][at(i / 3)] + i % 3, 3 * triangles[t][at(j / 3)] + j % 3) += own(i, j);
            }
        }
    }
    return k;
}

const Mat3 material = plane_stress(3.0e5, 0.42);
const PlaneCorners skew_corners{Vec2(0.1, -0.2), Vec2(1.3, 0.1), Vec2(0.4, 0.9)};

int zero_modes(const Mat9& k) {
    const VecX values = scenes::eigenvalues(k);
    CHECK(values[0] > -1e-12 * values[8]);
    return static_cast<int>((values.array() < 1e-10 * values[8]).count());
}

template <typename Field>
VecX freedoms(const std::vector<Vec2>& nodes, const Field& field) {
    VecX d(static_cast<Eigen::Index>(3 * nodes.size()));
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        d.segment<3>(static_cast<Eigen::Index>(3 * n)) = field(nodes[n]);
    }
    return d;
}

/// Renumbered so that what was corner 0 is corner 2.
Mat9 shifted(const Mat9& k) {
    Mat9 result;
    for (int i = 0; i < 9; ++i) {
        for (int j = 0; j < 9; ++j) {
            result((i + 6) % 9, (j + 6) % 9) = k(i, j);
        }
    }
    return result;
}

}  // namespace

TEST_SUITE("plate triangle") {
    TEST_CASE("exactly the three rigid movements cost nothing") {
        CHECK(zero_modes(dkt_stiffness(skew_corners, material)) == 3);
    }

    TEST_CASE("patch test: constant curvature leaves no force within, and the right energy") {
        const Patch patch;
        const MatX k = assembled(patch.triangles, patch.nodes.size(),
                                 [&](std::size_t t) { return dkt_stiffness(patch.corners(t), material); });
        for (const Vec3& c : {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0), Vec3(0.7, -0.4, 1.1)}) {
            const VecX d = freedoms(patch.nodes, [&](const Vec2& p) {
                const Vec2 slope(c[0] * p.x() + 0.5 * c[2] * p.y(), c[1] * p.y() + 0.5 * c[2] * p.x());
                return Vec3(0.5 * (c[0] * p.x() * p.x() + c[1] * p.y() * p.y() + c[2] * p.x() * p.y()), slope.y(),
                            -slope.x());
            });
            const VecX force = k * d;
            CHECK(force.segment<3>(3 * Patch::inner).cwiseAbs().maxCoeff() < 1e-10 * force.cwiseAbs().maxCoeff());
            CHECK(0.5 * d.dot(force) == doctest::Approx(0.5 * c.dot(material * c)).epsilon(1e-10));
        }
    }

    TEST_CASE("numbering and frame change nothing") {
        const Mat9 k = dkt_stiffness(skew_corners, material);
        const Mat9 again = dkt_stiffness({skew_corners[1], skew_corners[2], skew_corners[0]}, material);
        CHECK((again - shifted(k)).cwiseAbs().maxCoeff() < 1e-12 * k.cwiseAbs().maxCoeff());
        Mat2 turn;
        turn << 0.6, -0.8, 0.8, 0.6;
        const Mat9 turned =
            dkt_stiffness({turn * skew_corners[0], turn * skew_corners[1], turn * skew_corners[2]}, material);
        Mat9 map = Mat9::Identity();
        for (int a = 0; a < 3; ++a) {
            map.block<2, 2>(3 * a + 1, 3 * a + 1) = turn;
        }
        CHECK((map.transpose() * turned * map - k).cwiseAbs().maxCoeff() < 1e-12 * k.cwiseAbs().maxCoeff());
    }
}

TEST_SUITE("membrane triangle with drilling") {
    TEST_CASE("exactly the three rigid movements cost nothing") {
        CHECK(zero_modes(drilling_stiffness(skew_corners, material, optimal_higher_share(0.42))) == 3);
    }

    TEST_CASE("patch test: constant strain leaves no force within, and the right energy") {
        const Patch patch;
        const MatX k = assembled(patch.triangles, patch.nodes.size(), [&](std::size_t t) {
            return drilling_stiffness(patch.corners(t), material, optimal_higher_share(0.42));
        });
        for (const Vec3& e : {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0), Vec3(0.7, -0.4, 1.1)}) {
            const double turn = 0.3;
            const VecX d = freedoms(patch.nodes, [&](const Vec2& p) {
                return Vec3(e[0] * p.x() + (0.5 * e[2] - turn) * p.y(), e[1] * p.y() + (0.5 * e[2] + turn) * p.x(),
                            turn);
            });
            const VecX force = k * d;
            CHECK(force.segment<3>(3 * Patch::inner).cwiseAbs().maxCoeff() < 1e-10 * force.cwiseAbs().maxCoeff());
            CHECK(0.5 * d.dot(force) == doctest::Approx(0.5 * e.dot(material * e)).epsilon(1e-10));
        }
    }

    TEST_CASE("numbering changes nothing") {
        const Mat9 k = drilling_stiffness(skew_corners, material, 0.3);
        const Mat9 again = drilling_stiffness({skew_corners[1], skew_corners[2], skew_corners[0]}, material, 0.3);
        CHECK((again - shifted(k)).cwiseAbs().maxCoeff() < 1e-12 * k.cwiseAbs().maxCoeff());
    }

    TEST_CASE("two triangles that make a rectangle bend in their plane as a beam does, whatever their aspect") {
        // pure bending of a rectangle a by b: energy M^2 a / (2 E I) per unit thickness, I = b^3 / 12
        const double young = 2.0e5;
        for (const double nu : {0.0, 0.25, 0.42}) {
            const Mat3 stress = plane_stress(young, nu);
            for (const double a : {0.25, 1.0, 4.0, 16.0}) {
                const std::vector<Vec2> nodes{{0.0, -0.5}, {a, -0.5}, {a, 0.5}, {0.0, 0.5}};
                const double curvature = 1e-2;
                const VecX d = freedoms(nodes, [&](const Vec2& p) {
                    const double x = p.x() - 0.5 * a;
                    return Vec3(-curvature * x * p.y(), 0.5 * curvature * (x * x + nu * p.y() * p.y()), curvature * x);
                });
                double energy = 0.0;
                const std::vector<std::vector<std::array<int, 3>>> cuts{{{{0, 1, 2}}, {{0, 2, 3}}},
                                                                        {{{0, 1, 3}}, {{1, 2, 3}}}};
                for (const std::vector<std::array<int, 3>>& cut : cuts) {
                    const MatX k = assembled(cut, 4, [&](std::size_t t) {
                        return drilling_stiffness({nodes[at(cut[t][0])], nodes[at(cut[t][1])], nodes[at(cut[t][2])]},
                                                  stress, optimal_higher_share(nu));
                    });
                    energy += 0.25 * d.dot(k * d);
                }
                CAPTURE(nu);
                CAPTURE(a);
                CHECK(energy == doctest::Approx(0.5 * young / 12.0 * curvature * curvature * a).epsilon(1e-10));
            }
        }
    }

    TEST_CASE("Cook's panel: from below to 23.96, by less than half at every halving") {
        const auto tip = [](int n) {
            std::vector<Vec2> nodes;
            for (int j = 0; j <= n; ++j) {
                for (int i = 0; i <= n; ++i) {
                    const double x = 48.0 * i / n;
                    const double low = 44.0 * i / n;
                    const double high = 44.0 + 16.0 * i / n;
                    nodes.emplace_back(x, low + (high - low) * j / n);
                }
            }
            std::vector<std::array<int, 3>> triangles;
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    const int k = i + (n + 1) * j;
                    triangles.push_back({k, k + 1, k + n + 1});  // along the shorter diagonal
                    triangles.push_back({k + 1, k + n + 2, k + n + 1});
                }
            }
            MatX k = assembled(triangles, nodes.size(), [&](std::size_t t) {
                return drilling_stiffness(
                    {nodes[at(triangles[t][0])], nodes[at(triangles[t][1])], nodes[at(triangles[t][2])]},
                    plane_stress(1.0, 1.0 / 3.0), optimal_higher_share(1.0 / 3.0));
            });
            VecX load = VecX::Zero(k.rows());
            for (int j = 0; j <= n; ++j) {
                load[3 * (n + (n + 1) * j) + 1] = (j == 0 || j == n ? 0.5 : 1.0) / n;
                for (int c = 0; c < 3; ++c) {
                    const Eigen::Index held = 3 * (n + 1) * j + c;
                    k.row(held).setZero();
                    k.col(held).setZero();
                    k(held, held) = 1.0;
                }
            }
            const VecX d = k.llt().solve(load);
            return d[3 * (n + (n + 1) * (n / 2)) + 1];
        };
        // 22.00, 23.24, 23.72
        const double reference = 23.96;
        const double errors[3] = {reference - tip(4), reference - tip(8), reference - tip(16)};
        CHECK(errors[2] > 0.0);
        CHECK(errors[2] < 0.4 * errors[1]);
        CHECK(errors[1] < 0.4 * errors[0]);
        CHECK(errors[2] < 0.011 * reference);
    }
}
