// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "trial/spectrum.hpp"

using namespace rhexis;

namespace {

const ObservationSchema schema = {
    {"a.tip_x_mm", "mm", ""}, {"a.tip_y_mm", "mm", ""}, {"a.tip_z_mm", "mm", ""},
    {"b.tip_x_mm", "mm", ""}, {"b.tip_y_mm", "mm", ""}, {"b.tip_z_mm", "mm", ""},
};

/// a swings at 8 Hz while it drifts; b is there for a second only.
nlohmann::json spectra_of(double amplitude) {
    Spectra spectra(schema);
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i <= 1000; ++i) {
        const double t = 0.01 * i;
        const double swing = amplitude * std::sin(2.0 * std::numbers::pi * 8.0 * t);
        const double b = i < 100 ? 0.0 : none;
        spectra.add({t, {swing + 0.3 * t, 1.0, 2.0, b, b, b}});
    }
    return spectra.json();
}

}  // namespace

TEST_SUITE("cli spectrum") {
    TEST_CASE("the power of a swing is found at its frequency, drift is not") {
        const nlohmann::json a = spectra_of(0.1).at("a");
        CHECK(a.at("windows") == 9);
        double power = 0.0;
        double best_hz = 0.0;
        double best = 0.0;
        for (std::size_t i = 0; i < a.at("hz").size(); ++i) {
            const double um = a.at("um_per_sqrt_hz")[i];
            power += um * um * 0.5;
            if (um > best) {
                best = um;
                best_hz = a.at("hz")[i];
            }
        }
        CHECK(best_hz == 8.0);
        CHECK(std::sqrt(power) == doctest::Approx(100.0 / std::sqrt(2.0)).epsilon(0.02));
        CHECK(a.at("um_per_sqrt_hz")[0] < 0.01 * best);
    }

    TEST_CASE("rest has none, and who was never there for two seconds is left out") {
        const nlohmann::json still = spectra_of(0.0);
        CHECK(still.at("a").at("um_per_sqrt_hz")[14] == doctest::Approx(0.0).epsilon(1e-6));
        CHECK_FALSE(still.contains("b"));
    }
}
