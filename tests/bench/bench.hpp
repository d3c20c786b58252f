// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of benchmarks: `rhexis bench [NAME...]` runs them, `rhexis bench --list` names them.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rhexis::bench {

struct BenchOptions {
    bool quick = false;  ///< smaller meshes and fewer repeats: does it run at all
    int repeats = 9;     ///< the minimum of so many is reported, and their spread
    int threads = 1;
    std::function<void(double)> progress = [](double) {};  ///< told the share of a long benchmark that is done
};

/// One benchmark gives one or more rows. A row is an object with at least "name", and where they apply "elements",
/// "nodes", "steps_per_second", "cpu_s_per_s", "error", "error_kind", "ratio" and "spread" (see docs/).
struct BenchCase {
    std::string name;
    std::string summary;
    std::function<nlohmann::json(const BenchOptions&)> run;  ///< an array of rows
    nlohmann::json about{};                                  ///< of a chart: its labels (bench/chart.hpp)
};

/// All benchmarks, in the order of --list.
std::vector<BenchCase> bench_cases();

}  // namespace rhexis::bench
