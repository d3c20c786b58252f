// SPDX-License-Identifier: GPL-3.0-or-later
// Gates of thin sheets, and of how they tear.
#include <cmath>

#include "mesh/shapes.hpp"
#include "scenes/membrane_trials.hpp"
#include "scenes/random_tears.hpp"
#include "scenes/split_run.hpp"
#include "scenes/stability_gates.hpp"
#include "scenes/tear_paths.hpp"
#include "scenes/tears.hpp"

namespace rhexis::scenes {
namespace {

constexpr double rounding = 1e-9;

/// Nodes and triangles that a split in every step adds, and what its steps leave.
void add_splits(Gates& gates, int steps) {
    SplitRun run(1500);
    const double nodes = static_cast<double>(run.state().sheet->mesh.nodes.size());
    double residual = 0.0;
    double splits = 0.0;
    for (int i = 0; i < steps; ++i) {
        splits += run.split() ? 1.0 : 0.0;
        residual = std::max(residual, run.step().residual);
    }
    const std::string id = "T18 in every step";
    gates.push_back({id, "steps without a split, share", 1.0 - splits / steps, 0.1});
    gates.push_back({id, "nodes added per split",
                     (static_cast<double>(run.state().sheet->mesh.nodes.size()) - nodes) / splits, 3.0});
    gates.push_back({id, "relative residual of the linear solve of a step", residual, 1e-4});
}

}  // namespace

Gates gates_of_taut_sheets(bool quick) {
    Gates gates;
    for (const double dt : {1e-4, 1e-3, 1e-2}) {
        gates.push_back({"T5 steps of " + std::to_string(dt) + " s",
                         "largest distance from the plane over that at the start",
                         shake_taut(dt, quick ? 200 : 1000).swing, 1.001});
    }
    return gates;
}

Gates gates_of_slack_sheets(bool quick) {
    const Slackness found = crumple(quick ? 100 : 300);
    return {
        {"T6 crumpled", "relative residual of a linear solve", found.residual, 1e-6},
        {"T6 crumpled", "largest rise of the energy in a step, share of that at the start", found.rise, 1e-7},
        {"T6 crumpled", "energy left, share of that at the start", found.left, 0.02},
        {"T6 crumpled", "least eigenvalue of a triangle's stiffness, negative, over its norm", -found.least, rounding}};
}

Gates gates_of_fibres(bool) {
    Gates gates;
    for (const auto& [name, material] :
         {std::pair{"4 : 1", Orthotropic{1e6, 2.5e5, 0.45, 0.0}}, std::pair{"10 : 1", Orthotropic{1e6, 1e5, 0.3, 2e5}},
          std::pair{"1 : 5", Orthotropic{2e5, 1e6, 0.2, 0.0}}, std::pair{"1 : 1", isotropic(1e6, 0.47)}}) {
        const FibreSweep found = sweep_fibres(material);
        const std::string id = std::string("T7 along : across ") + name;
        gates.push_back(
            {id, "largest eigenvalue of the stiffness over the smallest at any angle", found.condition, 20.0});
        gates.push_back({id, "change of the eigenvalues with the angle, relative", found.spread, 1e-12});
        gates.push_back(
            {id, "least eigenvalue of a triangle's stiffness, negative, over its norm", -found.least, rounding});
    }
    return gates;
}

Gates gates_of_numbering(bool) {
    const Renumbering found = renumber();
    return {{"T8 membrane renumbered", "change of the energy, relative", found.renumbered, 1e-12},
            {"T8 membrane turned", "change of the energy, relative", found.turned, 1e-12}};
}

Gates gates_of_random_tears(bool quick) {
    Gates gates;
    add_splits(gates, quick ? 50 : 200);
    const RandomTears found = random_tears({.operations = quick ? 2000 : 10000});
    const std::string id = "T18 at random";
    const auto add = [&](const char* what, double measured, double limit) {
        gates.push_back({id, what, found.fault.empty() ? measured : NAN, limit});
    };
    add("cosine of the smallest angle over that of 15 degrees or of the smallest at the start", found.most_cosine, 0.0);
    add("a tenth of the mean edge over the shortest", 0.1 / found.least_edge, 1.0);
    add("triangles, share of the stated bound", found.most_of_bound, 1.0);
    add("nodes per triangle", found.most_per_triangle, 3.0);
    add("area against that at the start, relative", found.area_off, 1e-12);
    add("mass against that at the start, relative", found.mass_off, 1e-12);
    add("area torn against the edges that are there, relative", found.torn_off, 1e-10);
    add("energy torn against that area, relative", found.energy_off, 1e-10);
    add("elastic energy changed by an edit, relative", found.elastic_off, 1e-10);
    add("steps given up", static_cast<double>(found.given_up), 0.0);
    return gates;
}

Gates gates_of_tear_meshes(bool quick) {
    Gates gates;
    std::vector<double> edges;
    std::vector<double> loads;
    for (const int triangles : quick ? std::vector<int>{400, 1600} : std::vector<int>{400, 1600, 6400}) {
        const MiddleCrack crack = middle_crack(triangles);
        edges.push_back(mean_edge(crack.sheet->model().sheet->mesh));
        loads.push_back(std::sqrt(crack.half_length / crack.release));
    }
    gates.push_back({"T19 load", "slope of the logarithm of a tear's load over that of the edge",
                     std::abs(slope(edges, loads)), 0.05});
    for (const double across : {1.0, 2.0}) {
        for (const int triangles : quick ? std::vector<int>{400} : std::vector<int>{400, 1600}) {
            const TriMesh even = round_sheet(4.0, triangles);
            double mean = 0.0;
            std::vector<TearPath> paths;
            for (const TriMesh& mesh : {even, jittered(even, 0.2, 3), turned(even, 0.3)}) {
                paths.push_back(tear_path(mesh, Vec3(1.0, across > 1.0 ? 0.5 : 0.0, 0.0), across));
                mean += angle_of(paths.back()) / 3.0;
            }
            double off = 0.0;
            for (const TearPath& path : paths) {
                off = path.places.empty() ? NAN : std::max(off, off_line(path, mean) / mean_edge(even));
            }
            gates.push_back({std::string("T19 path ") + (across > 1.0 ? "fibres " : "isotropic ") +
                                 std::to_string(even.triangles.size()),
                             "largest distance of three meshes' paths from their mean, in edges", off, 0.6});
        }
    }
    return gates;
}

}  // namespace rhexis::scenes
