// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/shells.hpp"

#include <cmath>
#include <utility>

#include "mesh/io.hpp"
#include "scenes/bodies.hpp"

namespace rhexis::scenes {

Result<LiftedDisc> lifted_disc(const std::string& folder) {
    const std::string base = folder + "/tests/data/meshes/shell_743";
    Result<TriMesh> mesh = read_tri_mesh(base + ".vtk");
    if (!mesh.ok()) {
        return mesh.error();
    }
    const Result<std::vector<int>> fixed = read_nodes(base + ".fixed.txt", mesh.value().nodes.size());
    const Result<std::vector<int>> lifted = read_nodes(base + ".load.txt", mesh.value().nodes.size());
    if (!fixed.ok() || !lifted.ok()) {
        return fixed.ok() ? lifted.error() : fixed.error();
    }
    LiftedDisc disc;
    disc.model = uniform_shell("shell_743", std::move(mesh).value(), 0.3);
    disc.model.damping_mass = 0.1;
    disc.model.damping_stiffness = 0.01;
    for (const int node : fixed.value()) {
        disc.model.holds.push_back({node, {true, true, true, true, true, true}});
    }
    disc.lifted = lifted.value();
    return disc;
}

ShellLoad disc_load(const LiftedDisc& disc, double share) {
    ShellLoad load;
    load.force.assign(disc.model.mesh.nodes.size(), Vec3::Zero());
    for (const int node : disc.lifted) {
        load.force[static_cast<std::size_t>(node)] = share / static_cast<double>(disc.lifted.size()) * disc.load;
    }
    return load;
}

double moving_share(double time_s) { return 0.5 - 0.5 * std::cos(2.0 * M_PI * time_s / 0.5); }

}  // namespace rhexis::scenes
