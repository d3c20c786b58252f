// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/rim_rupture.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace rhexis {
namespace {

constexpr double edge_reach = 0.5;  // each way along the edge, at rest [mm]: about what a test pulls at

/// A place of an edge with what is within reach of it.
struct Stretch {
    int node = -1;
    double ratio = 0.0;
    Vec3 along = Vec3::Zero();  ///< the edge, at rest
};

/// About place i of a closed loop of nodes.
Stretch stretch_at(const MembraneState& state, const std::vector<int>& loop, std::size_t i) {
    const std::vector<Vec3>& rest = state.sheet->mesh.nodes;
    Stretch result;
    result.node = loop[i];
    double then = 0.0;
    double now = 0.0;
    for (const bool ahead : {true, false}) {
        double way = 0.0;
        std::size_t from = i;
        for (std::size_t steps = 0; way < edge_reach && steps < loop.size() / 2; ++steps) {
            const std::size_t to = (from + (ahead ? 1 : loop.size() - 1)) % loop.size();
            const double length = (rest[at(loop[to])] - rest[at(loop[from])]).norm();
            way += length;
            then += length;
            now += (state.position[at(loop[to])] - state.position[at(loop[from])]).norm();
            from = to;
        }
        result.along += (ahead ? 1.0 : -1.0) * rest[at(loop[from])];
    }
    result.ratio = then > 0.0 ? now / then : 0.0;
    return result;
}

/// From a node on an edge into the sheet, at a right angle to the edge, at rest.
Vec3 inwards(const MembraneSheet& sheet, const Stretch& edge) {
    Vec3 way = Vec3::Zero();
    for (int i = sheet.neighbours.offset[at(edge.node)]; i < sheet.neighbours.offset[at(edge.node) + 1]; ++i) {
        way += triangle_middle(sheet.mesh, sheet.neighbours.triangles[at(i)]) - sheet.mesh.nodes[at(edge.node)];
    }
    const Vec3 along = edge.along.normalized();
    return (way - way.dot(along) * along).normalized();
}

}  // namespace

std::vector<NotchProposal> propose_notches(const MembraneModel& model, const MembraneState& state) {
    if (!(model.rupture_stretch > 0.0)) {
        return {};
    }
    const MembraneSheet& sheet = *state.sheet;
    Stretch most;
    for (const std::vector<int>& loop : boundary_loops(sheet.mesh, sheet.neighbours)) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Stretch own = stretch_at(state, loop, i);
            most = own.ratio > most.ratio ? own : most;
        }
    }
    const bool torn = std::any_of(state.tips.begin(), state.tips.end(), [&](const TearTip& tip) {
        return (sheet.mesh.nodes[at(tip.node)] - sheet.mesh.nodes[at(most.node)]).norm() < edge_reach;
    });
    if (!(most.ratio > model.rupture_stretch) || torn) {
        return {};
    }
    return {{most.node, inwards(sheet, most)}};
}

}  // namespace rhexis
