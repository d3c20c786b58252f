// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_bulk.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/clock.hpp"
#include "bench/calculix.hpp"
#include "bench/methods/averaged_bulk.hpp"
#include "mesh/io.hpp"
#include "mesh/shapes.hpp"
#include "physics/solid/solid_share.hpp"

namespace rhexis::bench {
namespace {

constexpr double bar_modulus = 3000.0;  ///< of the bar [Pa]
constexpr double bar_length = 16.0;     ///< of it, along x [mm]
constexpr double bar_height = 2.0;      ///< of it, along y and z [mm]

/// A cantilever with a load along -z that is spread over the nodes of its free end.
scenes::LensPoke cantilever(TetMesh mesh, double poisson_ratio) {
    scenes::LensPoke bar;
    Material material;
    material.young_modulus = bar_modulus;
    material.poisson_ratio = poisson_ratio;
    bar.lens.materials = {material};
    mesh.region.assign(mesh.tets.size(), 0);
    std::vector<int> tip;
    for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
        const double x = mesh.nodes[static_cast<std::size_t>(i)].x();
        if (x < 1e-6) {
            bar.lens.fixed_nodes.push_back(i);
        } else if (x > bar_length - 1e-6) {
            tip.push_back(i);
        }
    }
    bar.nodal_load.assign(mesh.nodes.size(), Vec3::Zero());
    for (const int node : tip) {
        bar.nodal_load[static_cast<std::size_t>(node)] = Vec3(0.0, 0.0, -1.0 / static_cast<double>(tip.size()));
    }
    bar.lens.coarse = std::move(mesh);
    return bar;
}

/// Deflection per load after Timoshenko [mm/uN].
double timoshenko(double poisson_ratio) {
    const double area = bar_height * bar_height;
    const double second = area * area / 12.0;
    const double shear = 0.5 * bar_modulus / (1.0 + poisson_ratio);
    return std::pow(bar_length, 3) / (3.0 * bar_modulus * second) + bar_length / (5.0 / 6.0 * shear * area);
}

struct Problem {
    std::string name;  ///< of the field in a row
    scenes::LensPoke poke;
    double expected = 0.0;  ///< depth per load [mm/uN]
};

std::vector<Problem> problems(bool quick) {
    std::vector<Problem> list;
    for (const auto& [size, compliance] : kept_compliances()) {
        if (size <= (quick ? 1000 : 6000)) {
            list.push_back({"lens_" + std::to_string(size), scenes::lens_poke(size), compliance});
        }
    }
    std::vector<std::pair<std::string, TetMesh>> bars{{"bar_2", bar(16, 2, 2, 1.0)}};
    if (!quick) {
        bars.emplace_back("bar_4", bar(32, 4, 4, 0.5));
    }
    if (Result<MeshFile> file = read_tet_mesh("tests/data/meshes/cantilever.msh"); file) {
        bars.emplace_back("bar_gmsh", std::move(file).value().mesh);
    }
    for (const auto& [name, mesh] : bars) {
        for (const int percent : {30, 45, 49}) {
            list.push_back({std::string(name).append("_").append(std::to_string(percent)),
                            cantilever(mesh, 0.01 * percent), timoshenko(0.01 * percent)});
        }
    }
    return list;
}

using Elements = std::vector<GradientElements>;

/// Errors of depth per load, and the CPU time of making and solving all problems against that of linear tetrahedra.
template <typename Make>
nlohmann::json row(const std::string& name, const std::vector<Problem>& all, const Make& make, double& linear_s) {
    nlohmann::json result = {{"name", "bulk/" + name},
                             {"error_kind",
                              "depth under a load: lens against C3D10 on the same mesh, bar against "
                              "Timoshenko at a Poisson's ratio of 0.30, 0.45, 0.49"}};
    const double start = thread_cpu_seconds();
    double largest = 0.0;
    for (const Problem& problem : all) {
        const double error = scenes::linear_compliance(problem.poke, make(problem.poke)) / problem.expected - 1.0;
        result[problem.name] = error;
        largest = std::max(largest, std::abs(error));
    }
    const double took = thread_cpu_seconds() - start;
    linear_s = linear_s > 0.0 ? linear_s : took;
    result["error"] = largest;
    result["ratio"] = took / linear_s;
    return result;
}

nlohmann::json run_bulk(const BenchOptions& options) {
    const std::vector<Problem> all = problems(options.quick);
    const auto stiffness = [](const scenes::LensPoke& poke) { return tet_stiffness(poke.lens, rest_state(poke.lens)); };
    const auto kernel = [&](Formulation formulation) {
        return [&stiffness, formulation](const scenes::LensPoke& poke) {
            const TetMesh& mesh = poke.lens.coarse;
            return Elements{make_elements(mesh, element_domains(mesh, formulation), stiffness(poke))};
        };
    };
    double linear_s = 0.0;
    nlohmann::json rows = nlohmann::json::array();
    rows.push_back(row("linear tetrahedra", all, kernel(Formulation::linear), linear_s));
    const std::vector<std::pair<std::string, AveragedBulk>> ways{
        {"all over edges", {BulkOver::edges}},
        {"all over nodes", {BulkOver::nodes}},
        {"all over patches around nodes", {BulkOver::node_patches}},
        {"all over patches of 5", {BulkOver::patches, 5}},
        {"all over patches of 4", {BulkOver::patches, 4}},
        {"beyond 2 mu over patches of 4", {BulkOver::patches, 4, 2.0}},
        {"beyond mu over patches of 6", {BulkOver::patches, 6, 1.0}},
        {"beyond mu over patches of 2", {BulkOver::patches, 2, 1.0}}};
    for (const auto& [name, way] : ways) {
        const auto make = [&stiffness, &way = way](const scenes::LensPoke& poke) {
            return averaged_bulk(poke.lens.coarse, stiffness(poke), way);
        };
        rows.push_back(row(name, all, make, linear_s));
    }
    rows.push_back(
        row("edge_smoothed: beyond mu over patches of 4", all, kernel(Formulation::edge_smoothed), linear_s));
    return rows;
}

}  // namespace

std::vector<BenchCase> bulk_cases() {
    return {{"bulk", "what the change of volume is averaged over: the poked lens, and bars that bend", run_bulk}};
}

}  // namespace rhexis::bench
