// SPDX-License-Identifier: GPL-3.0-or-later
// When a tear starts, by criterion and size of the triangles; where it goes, by mesh; what a tear in every step costs.
#include "bench/bench_tear.hpp"

#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "bench/methods/tear_strength.hpp"
#include "bench/split_run.hpp"
#include "mesh/shapes.hpp"
#include "scenes/tears.hpp"

namespace rhexis::bench {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Slope of log y against log x.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / static_cast<double>(x.size());
        mean_y += std::log(y[i]) / static_cast<double>(x.size());
    }
    double up = 0.0;
    double down = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        up += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
        down += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    }
    return up / down;
}

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
                    {"load_one_ring", slope(edge, ring)},
                    {"load_fixed_radius", slope(edge, radius)},
                    {"load_energy", slope(edge, energy)},
                    {"error", std::abs(slope(edge, energy))},
                    {"error_kind", "slope of log load over log edge, by energy"}});
    return rows;
}

/// A sheet with a slit across the pull tears until its tip nears the edge; the path of one tip.
struct Path {
    std::vector<Vec3> places;
    double cpu_s = 0.0;
    double simulated_s = 0.0;
};

Path tear_path(TriMesh mesh, const Vec3& fibre, double across) {
    const double side = 8.0;
    MembraneModel model = scenes::membrane("sheet", std::move(mesh), Orthotropic{1e6, 1e6, 0.45, 0.0}, fibre);
    model.toughness = {2e3, 2e3 * across * across};
    model.tear_radius = 0.8;
    model.damping_mass = 200.0;
    std::vector<int> low;
    std::vector<int> high;
    const TriMesh& rest = model.sheet->mesh;
    for (int n = 0; n < static_cast<int>(rest.nodes.size()); ++n) {
        const Vec3& x = rest.nodes[at(n)];
        // a round sheet, gripped over two arcs
        if (x.norm() > 0.5 * side - 1e-6 && std::abs(x.x()) < std::abs(x.y())) {
            (x.y() < 0.0 ? low : high).push_back(n);
        }
    }
    scenes::hold(model, low, high);
    scenes::HeldSheet held(model);
    int middle = 0;
    for (int n = 0; n < static_cast<int>(rest.nodes.size()); ++n) {
        middle = rest.nodes[at(n)].norm() < rest.nodes[at(middle)].norm() ? n : middle;
    }
    const int triangle = model.sheet->neighbours.triangles[at(model.sheet->neighbours.offset[at(middle)])];
    const Result<MembraneEdit> slit = puncture(model, held.state(), triangle, rest.nodes[at(middle)], Vec3::UnitX());
    Path path;
    if (!slit.ok()) {
        return path;
    }
    held.state() = applied(held.state(), slit.value());
    const double start = thread_cpu_seconds();
    for (int i = 0; i < 2000; ++i) {
        for (const int node : low) {
            held.state().position[at(node)].y() -= 0.002;
        }
        for (const int node : high) {
            held.state().position[at(node)].y() += 0.002;
        }
        for (int k = 0; k < 3; ++k) {
            held.step(0.01, {}, {.tolerance = 1e-4, .max_newton = 6, .newton_tolerance = 1e-3});
            path.simulated_s += 0.01;
        }
        scenes::tear_once(held.model(), held.state());
        const auto right = std::max_element(
            held.state().tips.begin(), held.state().tips.end(), [&](const TearTip& a, const TearTip& b) {
                return held.state().sheet->mesh.nodes[at(a.node)].x() < held.state().sheet->mesh.nodes[at(b.node)].x();
            });
        if (right == held.state().tips.end()) {
            break;
        }
        const Vec3& place = held.state().sheet->mesh.nodes[at(right->node)];
        if (path.places.empty() || (path.places.back() - place).norm() > 1e-9) {
            path.places.push_back(place);
        }
        if (place.norm() > 0.5 * side - 1.2) {
            break;
        }
    }
    path.cpu_s = thread_cpu_seconds() - start;
    return path;
}

/// Largest distance of a path's points from a line through the middle at an angle.
double off_line(const Path& path, double angle) {
    double most = 0.0;
    const Vec3 normal(-std::sin(angle), std::cos(angle), 0.0);
    for (const Vec3& place : path.places) {
        most = std::max(most, std::abs(normal.dot(place)));
    }
    return most;
}

double angle_of(const Path& path) {
    return path.places.empty() ? 0.0 : std::atan2(path.places.back().y(), path.places.back().x());
}

TriMesh turned(TriMesh mesh, double angle) {
    const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    for (Vec3& x : mesh.nodes) {
        x = turn * x;
    }
    return mesh;
}

nlohmann::json run_path(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const std::vector<int> meshes = options.quick ? std::vector<int>{400} : std::vector<int>{400, 1600, 6400};
    for (const double across : {1.0, 2.0}) {
        for (const int triangles : meshes) {
            const TriMesh even = round_sheet(4.0, triangles);
            const std::pair<const char*, TriMesh> kinds[] = {
                {"structured", even}, {"jittered", jittered(even, 0.2, 3)}, {"rotated", turned(even, 0.3)}};
            double mean = 0.0;
            std::vector<Path> paths;
            for (const auto& [name, mesh] : kinds) {
                paths.push_back(tear_path(mesh, Vec3(1.0, across > 1.0 ? 0.5 : 0.0, 0.0), across));
                mean += angle_of(paths.back()) / 3.0;
            }
            for (std::size_t i = 0; i < 3; ++i) {
                rows.push_back({{"name", std::string("tear_path/") + (across > 1.0 ? "fibres/" : "isotropic/") +
                                             kinds[i].first + "/" + std::to_string(even.triangles.size())},
                                {"elements", even.triangles.size()},
                                {"angle_deg", angle_of(paths[i]) * 180.0 / M_PI},
                                {"cpu_s_per_s", paths[i].cpu_s / paths[i].simulated_s},
                                {"error", off_line(paths[i], mean) / mean_edge(even)},
                                {"error_kind", "largest distance from the mean path, in edges"}});
            }
        }
    }
    return rows;
}

/// 1 ms steps of a taut sheet of 1,500 triangles that is split in each.
nlohmann::json run_split(const BenchOptions& options) {
    SplitRun run(1500);
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
            {"cpu_s_per_s", seconds / (SplitRun::step_s * steps)},
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
