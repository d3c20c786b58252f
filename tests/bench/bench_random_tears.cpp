// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_random_tears.hpp"

#include <unistd.h>

#include <fstream>

#include "scenes/random_tears.hpp"

namespace rhexis::bench {
namespace {

constexpr double allowed_growth_mb = 10.0;  ///< from the first tenth of a run to its end

/// What this process holds in memory now [MB].
double resident_mb() {
    std::ifstream file("/proc/self/statm");
    double whole = 0.0;
    double resident = 0.0;
    file >> whole >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

nlohmann::json row_of(const std::string& name, const scenes::RandomTearsTask& task) {
    scenes::RandomTearsTask first = task;
    first.operations = task.operations / 10;
    scenes::random_tears(first);
    const double before = resident_mb();
    const scenes::RandomTears found = scenes::random_tears(task);
    const double growth = resident_mb() - before;
    const bool sound = found.fault.empty() && found.most_cosine <= 0.0 && found.most_of_bound <= 1.0;
    return {{"name", name},
            {"operations", found.operations},
            {"sheets", found.sheets},
            {"sheets_torn_up", found.torn_up},
            {"pieces_taken_out", found.taken_out},
            {"edits", found.edits},
            {"refused", found.refused},
            {"refused_mad", found.mad},
            {"grasps", found.grasps},
            {"pulls", found.pulls},
            {"punctures_by_needle", found.punctures},
            {"steps_that_tore", found.torn_by_pull},
            {"steps", found.steps},
            {"steps_given_up", found.given_up},
            {"least_angle_deg", found.least_angle},
            {"least_edge", found.least_edge},
            {"most_nodes", found.most_nodes},
            {"most_triangles", found.most_triangles},
            {"most_of_bound", found.most_of_bound},
            {"nodes_per_triangle", found.most_per_triangle},
            {"area_off", found.area_off},
            {"mass_off", found.mass_off},
            {"torn_area_off", found.torn_off},
            {"torn_energy_off", found.energy_off},
            {"elastic_energy_off", found.elastic_off},
            {"resident_mb", before + growth},
            {"growth_mb", growth},
            {"failure", found.fault},
            {"passed", sound && growth < allowed_growth_mb}};
}

nlohmann::json run_mixed(const BenchOptions& options) {
    return nlohmann::json::array({row_of("random_tears", {.operations = options.quick ? 1000 : 100000})});
}

nlohmann::json run_to_scraps(const BenchOptions& options) {
    const int operations = options.quick ? 1000 : 100000;
    return nlohmann::json::array({row_of(
        "random_tears_to_scraps", {.operations = operations, .longest_sheet = operations, .by_instrument = 0.0})});
}

}  // namespace

std::vector<BenchCase> random_tears_cases() {
    return {
        {"random_tears", "100,000 random splits, grasps and pulls: slivers, faults, accounts and memory", run_mixed},
        {"random_tears_to_scraps", "100,000 random edits of sheets until little is left of them", run_to_scraps}};
}

}  // namespace rhexis::bench
