// SPDX-License-Identifier: GPL-3.0-or-later
// When a tear starts, by criterion and size of the triangles; where it goes, by mesh; what a tear in every step costs.
#include "bench/bench_tear.hpp"

#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "bench/methods/tear_strength.hpp"
#include "mesh/shapes.hpp"
#include "scenes/split_run.hpp"
#include "scenes/tear_paths.hpp"
#include "scenes/tears.hpp"

namespace rhexis::bench {
namespace {

/// The load at which each criterion starts the tear of a middle crack, over that of the finest mesh's energy.
nlohmann::json run_load(const BenchOptions& options) {
    const std::vector<int> meshes =
        options.quick ? std::vector<int>{400, 1600} : std::vector<int>{400, 1600, 6400, 25600};
    std::vector<double> edge, ring, radius, energy;
    nlohmann::json rows = nlohmann::json::array();
    for (const int triangles : meshes) {
        const double start = thread_cpu_seconds();
        scenes::MiddleCrack crack = scenes::middle_crack(triangles);
        const double seconds = thread_cpu_seconds() - start;
        const MembraneModel& model = crack.sheet->model();
        const MembraneState& state = crack.sheet->state();
        double by_ring = 0.0;
        double by_radius = 0.0;
        for (const TearTip& tip : state.tips) {
            const TipStress near = one_ring_stress(model, state, tip);
            const TipStress far = stress_at(model, state, tip.node, tip.direction);
            const Strength strength{1e6, 1e6, 1.0};
            by_ring += 0.5 * search_directions(near.stress, strength, near.fibre, Vec2::Zero(), 0.0).ratio;
            by_radius += 0.5 * search_directions(far.stress, strength, far.fibre, Vec2::Zero(), 0.0).ratio;
        }
        // loads are per root of the crack's length: the meshes' cracks differ by an edge
        const double root = std::sqrt(crack.half_length);
        edge.push_back(mean_edge(model.sheet->mesh));
        ring.push_back(root / by_ring);
        radius.push_back(root / by_radius);
        energy.push_back(root / std::sqrt(crack.release));
        rows.push_back({{"name", "tear_load/" + std::to_string(model.sheet->mesh.triangles.size())},
                        {"elements", model.sheet->mesh.triangles.size()},
                        {"edge_mm", edge.back()},
                        {"load_one_ring", ring.back()},
                        {"load_fixed_radius", radius.back()},
                        {"load_energy", energy.back()},
                        {"error", std::abs(std::sqrt(crack.expected / crack.release) - 1.0)},
                        {"error_kind", "load by energy against the handbook's"},
                        {"cpu_s", seconds}});
    }
    for (nlohmann::json& row : rows) {
        row["load_one_ring"] = row["load_one_ring"].get<double>() / ring.back();
        row["load_fixed_radius"] = row["load_fixed_radius"].get<double>() / radius.back();
        row["load_energy"] = row["load_energy"].get<double>() / energy.back();
    }
    rows.push_back({{"name", "tear_load/slope"},
                    {"load_one_ring", scenes::slope(edge, ring)},
                    {"load_fixed_radius", scenes::slope(edge, radius)},
                    {"load_energy", scenes::slope(edge, energy)},
                    {"error", std::abs(scenes::slope(edge, energy))},
                    {"error_kind", "slope of log load over log edge, by energy"}});
    return rows;
}

nlohmann::json run_path(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const std::vector<int> meshes = options.quick ? std::vector<int>{400} : std::vector<int>{400, 1600, 6400};
    for (const double across : {1.0, 2.0}) {
        for (const int triangles : meshes) {
            const TriMesh even = round_sheet(4.0, triangles);
            const std::pair<const char*, TriMesh> kinds[] = {
                {"structured", even}, {"jittered", jittered(even, 0.2, 3)}, {"rotated", scenes::turned(even, 0.3)}};
            double mean = 0.0;
            std::vector<scenes::TearPath> paths;
            for (const auto& [name, mesh] : kinds) {
                paths.push_back(scenes::tear_path(mesh, Vec3(1.0, across > 1.0 ? 0.5 : 0.0, 0.0), across));
                mean += scenes::angle_of(paths.back()) / 3.0;
            }
            for (std::size_t i = 0; i < 3; ++i) {
                rows.push_back({{"name", std::string("tear_path/") + (across > 1.0 ? "fibres/" : "isotropic/") +
                                             kinds[i].first + "/" + std::to_string(even.triangles.size())},
                                {"elements", even.triangles.size()},
                                {"angle_deg", scenes::angle_of(paths[i]) * 180.0 / M_PI},
                                {"cpu_s_per_s", paths[i].cpu_s / paths[i].simulated_s},
                                {"error", scenes::off_line(paths[i], mean) / mean_edge(even)},
                                {"error_kind", "largest distance from the mean path, in edges"}});
            }
        }
    }
    return rows;
}

/// 1 ms steps of a taut sheet of 1,500 triangles that is split in each.
nlohmann::json run_split(const BenchOptions& options) {
    scenes::SplitRun run(1500);
    const std::size_t elements = run.state().sheet->mesh.triangles.size();
    const int steps = options.quick ? 20 : 200;
    double seconds = 0.0;
    double worst = 0.0;
    int splits = 0;
    for (int i = 0; i < steps; ++i) {
        const double start = thread_cpu_seconds();
        splits += run.split() ? 1 : 0;
        run.step();
        propose_tears(run.model(), run.state());
        const double used = thread_cpu_seconds() - start;
        seconds += used;
        worst = std::max(worst, used);
    }
    return {{"name", "tear_split"},
            {"elements", elements},
            {"elements_at_the_end", run.state().sheet->mesh.triangles.size()},
            {"splits_per_step", static_cast<double>(splits) / steps},
            {"steps_per_second", steps / seconds},
            {"cpu_s_per_s", seconds / (scenes::SplitRun::step_s * steps)},
            {"slowest_step_ms", 1e3 * worst}};
}

}  // namespace

std::vector<BenchCase> tear_cases() {
    return {{"tear_load", "load at which a tear starts, by criterion and size of the triangles", run_load},
            {"tear_path", "path of a tear on structured, jittered and rotated meshes", run_path},
            {"tear_split", "1 ms steps of 1,500 triangles with a split in each",
             [](const BenchOptions& options) { return nlohmann::json::array({run_split(options)}); }}};
}

}  // namespace rhexis::bench
