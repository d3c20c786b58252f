// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_calculix.hpp"

#include <filesystem>

#include "bench/calculix.hpp"

namespace rhexis::bench {
namespace {

nlohmann::json row(const std::string& name, const scenes::LensPoke& poke, double compliance, double reference) {
    return {{"name", name},
            {"elements", poke.lens.coarse.tets.size()},
            {"nodes", poke.lens.coarse.nodes.size()},
            {"compliance_mm_per_mN", 1000.0 * compliance},
            {"error", compliance / reference - 1.0},
            {"error_kind", "depth under a given load against C3D10 on the same mesh"}};
}

nlohmann::json run_calculix(const BenchOptions& options) {
    const std::vector<int> sizes =
        options.quick ? std::vector<int>{1000} : std::vector<int>{1000, 3000, 6000, 12000, 24000};
    const std::string folder = (std::filesystem::temp_directory_path() / "rhexis-calculix").string();
    nlohmann::json rows = nlohmann::json::array();
    for (const int size : sizes) {
        const scenes::LensPoke poke = scenes::lens_poke(size);
        const std::string label = std::string("/").append(std::to_string(size));
        const Result<double> quadratic = calculix_compliance(poke, CalculixElement::c3d10, folder);
        const Result<double> linear = calculix_compliance(poke, CalculixElement::c3d4, folder);
        if (!quadratic || !linear) {
            rows.push_back({{"name", std::string("calculix").append(label)},
                            {"skipped", (!quadratic ? quadratic : linear).error().text()}});
            break;
        }
        const double reference = quadratic.value();
        rows.push_back(row(std::string("C3D10").append(label), poke, reference, reference));
        rows.push_back(row(std::string("C3D4").append(label), poke, linear.value(), reference));
        rows.push_back(row(std::string("linear").append(label), poke,
                           scenes::linear_compliance(poke, Formulation::linear), reference));
        rows.push_back(row(std::string("edge_smoothed").append(label), poke,
                           scenes::linear_compliance(poke, Formulation::edge_smoothed), reference));
        rows.push_back(row(std::string("nodal_pressure").append(label), poke,
                           scenes::linear_compliance(poke, Formulation::nodal_pressure), reference));
    }
    std::filesystem::remove_all(folder);
    return rows;
}

}  // namespace

std::vector<BenchCase> calculix_cases() {
    return {{"calculix",
             "the poked lens here and in CalculiX (needs calculix-ccx): linear, smoothed, quadratic elements",
             run_calculix}};
}

}  // namespace rhexis::bench
