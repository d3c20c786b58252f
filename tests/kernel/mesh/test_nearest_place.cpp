// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "mesh/nearest_place.hpp"

using namespace rhexis;

TEST_SUITE("nearest place") {
    TEST_CASE("nearest point of a triangle to a segment: no sampled point is nearer") {
        Rng rng(3, "triangles");
        const auto random = [&] { return uniform3(rng); };
        for (int i = 0; i < 100; ++i) {
            const std::array<Vec3, 3> t{random(), random(), random()};
            const Vec3 a = random();
            const Vec3 b = random();
            const std::array<double, 3> w = nearest_to_segment(t, a, b);
            CHECK(w[0] + w[1] + w[2] == doctest::Approx(1.0));
            CHECK(*std::min_element(w.begin(), w.end()) >= -1e-12);
            const auto to_segment = [&](const Vec3& p) {
                const double s = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
                return (a + s * (b - a) - p).norm();
            };
            const double found = to_segment(place_in(t, w));
            for (int k = 0; k < 200; ++k) {
                double u = rng.uniform();
                double v = rng.uniform();
                if (u + v > 1.0) {
                    u = 1.0 - u;
                    v = 1.0 - v;
                }
                CHECK(found <= to_segment(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0])) + 1e-12);
            }
        }
    }
}
