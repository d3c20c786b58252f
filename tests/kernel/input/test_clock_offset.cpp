// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/rng.hpp"
#include "input/clock_offset.hpp"

using namespace rhexis;

namespace {

constexpr std::int64_t unix_us = 1'790'000'000'000'000;  ///< the sender's clock counts from 1970
constexpr std::int64_t report_us = 8'000;
constexpr std::int64_t fastest_us = 200;

/// Seconds of reports whose way takes from 0.2 ms on, most of them little longer, some up to 10 ms; the sender's clock
/// gains drift_ppm. The largest error of the offset after the first second [us].
double worst_error(double seconds, double drift_ppm) {
    Rng rng(7);
    ClockOffset clock;
    double worst = 0.0;
    for (std::int64_t t = 0; t < static_cast<std::int64_t>(1e6 * seconds); t += report_us) {
        const auto drift = static_cast<std::int64_t>(1e-6 * drift_ppm * static_cast<double>(t));
        const double late = rng.uniform();
        const auto way = fastest_us + static_cast<std::int64_t>(10'000.0 * std::pow(late, 6.0));
        CHECK_FALSE(clock.take(t + drift + unix_us, t + way));
        if (t > 1'000'000) {
            const double truly = static_cast<double>(-unix_us - drift + fastest_us);
            worst = std::max(worst, std::abs(static_cast<double>(clock.offset_us()) - truly));
        }
    }
    return worst;
}

}  // namespace

TEST_SUITE("clock offset") {
    TEST_CASE("the offset of the clocks is found under jitter, and followed where they drift apart") {
        CHECK(worst_error(30.0, 0.0) < 50.0);
        CHECK(worst_error(60.0, 50.0) < 50.0 + 50.0 * 10.2);
        CHECK(worst_error(60.0, -50.0) < 50.0 + 50.0 * 10.2);
    }

    TEST_CASE("jitter is how much later than the fastest reports come, a few bad ones left out") {
        ClockOffset clock;
        for (std::int64_t i = 0; i < 900; ++i) {
            const std::int64_t way = i == 300 ? 80'000 : i % 5 == 0 ? 6'000 : 1'000;
            clock.take(unix_us + i * 10'000, i * 10'000 + way);
        }
        CHECK(clock.jitter_us() == 5'000);
        CHECK(clock.heard_for_us() > 8'900'000);
        clock.restart();
        CHECK(clock.heard_for_us() == 0);
    }

    TEST_CASE("a clock that is set forward or back is found at once; late reports are not taken for that") {
        for (const std::int64_t set_us : {5'000'000, 1'500'000, -5'000'000, -1'500'000, -200'000}) {
            ClockOffset clock;
            std::int64_t t = 0;
            for (; t < 2'000'000; t += report_us) {
                REQUIRE_FALSE(clock.take(unix_us + t, t + fastest_us));
            }
            CHECK(clock.take(unix_us + t + set_us, t + fastest_us));
            CHECK(clock.offset_us() == fastest_us - unix_us - set_us);
            CHECK_FALSE(clock.take(unix_us + t + report_us + set_us, t + report_us + fastest_us));
        }
        ClockOffset clock;
        std::int64_t t = 0;
        for (; t < 2'000'000; t += report_us) {
            REQUIRE_FALSE(clock.take(unix_us + t, t + fastest_us));
        }
        for (const std::int64_t end = t + 3'000'000; t < end;
             t += report_us) {  // a network that stood for three seconds
            CHECK_FALSE(clock.take(unix_us + t, end + fastest_us));
        }
        CHECK(clock.offset_us() == fastest_us - unix_us);
    }
}
