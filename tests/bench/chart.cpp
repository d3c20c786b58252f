// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chart.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::bench {
namespace {

nlohmann::json row_of(const ChartPoint& point) {
    nlohmann::json row = {{"name", point.way}, {"setting", point.setting}, {"cost", point.cost}};
    if (point.is_default) {
        row["default"] = true;
    }
    if (point.failure.empty()) {
        row["error"] = point.error;
    } else {
        row["failure"] = point.failure;
    }
    return row;
}

nlohmann::json run_chart(const Chart& chart, const BenchOptions& options) {
    ChartOptions wanted;
    wanted.only_default = options.quick;
    wanted.repeats = options.quick ? 1 : options.repeats;
    wanted.progress = options.progress;
    nlohmann::json rows = nlohmann::json::array();
    for (const ChartPoint& point : chart.measure(wanted)) {
        rows.push_back(row_of(point));
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> chart_cases() {
    std::vector<BenchCase> cases;
    for (const Chart& chart : charts()) {
        BenchCase one;
        one.name = "chart_" + chart.name;
        one.summary = chart.title + ": cost, and error against " + chart.answer;
        one.about = {{"chart", chart.name},  {"title", chart.title},   {"cost", chart.cost},
                     {"error", chart.error}, {"answer", chart.answer}, {"outside", chart.outside}};
        one.run = [chart](const BenchOptions& options) { return run_chart(chart, options); };
        cases.push_back(std::move(one));
    }
    return cases;
}

ChartPoint point_of(std::string way, std::string setting, bool is_default, double error, double cost) {
    return {std::move(way), std::move(setting), is_default, cost, error, {}};
}

std::string milliseconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%g ms", 1e3 * seconds);
    return text;
}

double rms_share(const std::vector<double>& found, const std::vector<double>& answer) {
    if (found.size() != answer.size() || answer.empty()) {
        return 1.0;
    }
    double sum = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < answer.size(); ++i) {
        sum += (found[i] - answer[i]) * (found[i] - answer[i]);
        size = std::max(size, std::abs(answer[i]));
    }
    const double share = std::sqrt(sum / static_cast<double>(answer.size())) / size;
    return std::isfinite(share) ? share : 1.0;
}

}  // namespace rhexis::bench
