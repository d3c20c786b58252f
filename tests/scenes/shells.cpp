// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/shells.hpp"

#include <cmath>
#include <utility>

#include "mesh/io.hpp"
#include "physics/shell/shell_statics.hpp"
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

FoldedOptic folded_optic(int triangles) {
    ImplantShape shape;
    shape.triangles = triangles;
    FoldedOptic result{std::move(make_implant(shape)).value(), {}, 0};
    ShellModel& model = result.implant.model;
    const std::vector<Vec3>& nodes = model.mesh.nodes;
    std::vector<std::size_t> pressed;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].norm() > 0.5 * shape.optic_diameter + 1e-9) {
            continue;  // of a haptic
        }
        if (std::abs(nodes[n].x()) < 0.3) {
            model.holds.push_back({static_cast<int>(n), {true, true, true, true, true, true}});
        }
        if (std::abs(nodes[n].x()) > 2.2 && std::abs(nodes[n].y()) < 1.2) {
            pressed.push_back(n);
        }
        if (nodes[n].x() > nodes[static_cast<std::size_t>(result.edge)].x()) {
            result.edge = static_cast<int>(n);
        }
    }
    result.load.force.assign(nodes.size(), Vec3::Zero());
    for (const std::size_t n : pressed) {
        const Vec3 way(nodes[n].x() > 0.0 ? -1.0 : 1.0, 0.0, 0.5);
        result.load.force[n] = 2.0 / static_cast<double>(pressed.size()) * way;
    }
    return result;
}

ShellState folded_state(const FoldedOptic& optic, double force) {
    ShellStatics statics = std::move(ShellStatics::create(optic.implant.model)).value();
    ShellState state = rest_state(optic.implant.model);
    constexpr int loads = 4;
    for (int i = 0; i < loads; ++i) {
        statics.load_to(optic.load, force * i / loads, force * (i + 1) / loads, {}, state);
    }
    return state;
}

double fold_degrees(const FoldedOptic& optic, const ShellState& state) {
    const Vec3 way = state.rotation[static_cast<std::size_t>(optic.edge)] * Vec3::UnitX();
    const double turn = std::atan2(way.z(), way.x()) * 180.0 / M_PI;
    return turn < -90.0 ? turn + 360.0 : turn;  // it may swing through
}

}  // namespace rhexis::scenes
