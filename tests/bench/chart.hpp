// SPDX-License-Identifier: GPL-3.0-or-later
// Charts of speed against accuracy, one for each model: what its ways and settings cost, and how far each is from an
// answer that is not ours wherever there is one. `rhexis bench chart_NAME` measures one, scripts/dev/charts.py keeps
// and draws them, tests/charts checks that the default is where its chart says.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/bench.hpp"

namespace rhexis::bench {

/// One setting of one way.
struct ChartPoint {
    std::string way;          ///< a line of the chart: "kernel's", "explicit Euler", ...
    std::string setting;      ///< beside the point: "10 ms", "3,000 tetrahedra"
    bool is_default = false;  ///< what exercises use; one of each chart
    double cost = 0.0;        ///< as Chart::cost says; never negative
    double error = 0.0;       ///< as a share of what the answer is: 0.1 is 10 %
    std::string failure;      ///< why there is no error; drawn at the top
};

struct ChartOptions {
    bool only_default = false;  ///< that point alone, whatever it costs
    int repeats = 5;            ///< the fastest of so many is its cost
    std::function<void(double)> progress = [](double) {};
};

struct Chart {
    std::string name;    ///< lower case with underscores, a word of the model's
    std::string title;   ///< what is looked at
    std::string cost;    ///< label of the axis: cpu_per_second, or what else
    std::string error;   ///< label of the axis: of what, in which norm
    std::string answer;  ///< whose it is, with its key of kernel/references.bib
    bool outside =
        true;  ///< false: our own, refined, because none was found (the model's page says what was looked for)
    std::function<std::vector<ChartPoint>(const ChartOptions&)> measure;
};

inline constexpr const char* cpu_per_second = "CPU seconds per simulated second";

/// All of them, in the order of docs/accuracy.md.
std::vector<Chart> charts();

/// Each as a benchmark: chart_NAME.
std::vector<BenchCase> chart_cases();

/// A point that has an error.
ChartPoint point_of(std::string way, std::string setting, bool is_default, double error, double cost);

/// "10 ms", "0.1 ms".
std::string milliseconds(double seconds);

/// Root of the mean of squared differences, as a share of the greatest size of `answer`. 1 where a value is not finite.
double rms_share(const std::vector<double>& found, const std::vector<double>& answer);

}  // namespace rhexis::bench
