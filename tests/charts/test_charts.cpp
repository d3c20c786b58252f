// SPDX-License-Identifier: GPL-3.0-or-later
// The default of each model is as far from its answer as the chart in docs/ says (scripts/dev/charts.py).
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "bench/chart.hpp"
#include "tracking/measure/detector_chart.hpp"

using namespace rhexis;

namespace {

constexpr const char* folder = "docs/data/charts/";

/// Fields of a line of CSV; none of a chart's has quotes within quotes.
std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> found(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            found.emplace_back();
        } else {
            found.back() += c;
        }
    }
    return found;
}

struct Kept {
    std::string way;
    std::string setting;
    double error = -1.0;
};

/// The rows of a chart's file that are marked as its default.
std::vector<Kept> kept_defaults(const std::string& name) {
    std::ifstream file(folder + name + ".csv");
    std::vector<Kept> found;
    for (std::string line; std::getline(file, line);) {
        const std::vector<std::string> row = fields(line);
        if (!line.starts_with("#") && row.size() == 6 && row[2] == "yes") {
            found.push_back({row[0], row[1], row[4].empty() ? -1.0 : std::stod(row[4])});
        }
    }
    return found;
}

/// What is beyond rounding may not move.
void check_error(double error, const Kept& kept) { CHECK(std::abs(error - kept.error) <= 0.01 * kept.error + 1e-9); }

}  // namespace

TEST_CASE("each model's default is as far from the answer as its chart says") {
    std::set<std::string> names;
    for (const bench::Chart& chart : bench::charts()) {
        CAPTURE(chart.name);
        CHECK_MESSAGE(names.insert(chart.name).second, "two charts have this name");
        const std::vector<Kept> kept = kept_defaults(chart.name);
        REQUIRE_MESSAGE(kept.size() == 1, "scripts/dev/charts.py has not measured it");
        bench::ChartOptions options;
        options.only_default = true;
        options.repeats = 1;
        const std::vector<bench::ChartPoint> points = chart.measure(options);
        REQUIRE(points.size() == 1);
        const bench::ChartPoint& point = points.front();
        CHECK(point.is_default);
        CHECK(point.failure == "");
        CHECK(point.way == kept[0].way);
        CHECK(point.setting == kept[0].setting);
        check_error(point.error, kept[0]);
    }
    CHECK_FALSE(names.empty());
}

TEST_CASE("tracked tips are as far from the true ones as their chart says") {
    const std::vector<Kept> kept = kept_defaults("tracking");
    REQUIRE(kept.size() == 1);
    const Result<tracking::Setting> setting = tracking::setting_of({}, 301);
    REQUIRE(setting.ok());
    const Result<tracking::Numbers> numbers = tracking::measure_detectors(setting.value());
    REQUIRE(numbers.ok());
    const tracking::ChartRow row = tracking::chart_rows(numbers.value()).front();
    CHECK(row.detector + ", " + std::to_string(row.markers) + " markers" == kept[0].way);
    CHECK(std::to_string(row.cameras) + " cameras" == kept[0].setting);
    check_error(row.tip.of_95, kept[0]);
}
