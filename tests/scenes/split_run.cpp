// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/split_run.hpp"

#include <cmath>

#include "base/index.hpp"
#include "mesh/shapes.hpp"

namespace rhexis::scenes {
namespace {

MembraneModel sheet_held_around(int triangles, double damping) {
    MembraneModel model = membrane("sheet", round_sheet(4.6, triangles), isotropic(1e6, 0.45));
    model.damping_mass = damping;
    const TriMesh& rest = model.sheet->mesh;
    for (int n = 0; n < static_cast<int>(rest.nodes.size()); ++n) {
        if (rest.nodes[at(n)].norm() > 4.59) {
            model.fixed_nodes.push_back(n);
        }
    }
    return model;
}

}  // namespace

SplitRun::SplitRun(int triangles, double damping) : held_(sheet_held_around(triangles, damping)) {
    for (Vec3& x : held_.state().position) {
        x *= 1.03;
    }
}

bool SplitRun::split() {
    const int i = tries_++;
    MembraneState& state = held_.state();
    Result<MembraneEdit> edit = Error{};
    if (state.tips.empty()) {
        const TriMesh& mesh = state.sheet->mesh;
        const int triangle = (i * 131) % static_cast<int>(mesh.triangles.size());
        edit = puncture(model(), state, triangle, mesh.nodes[at(mesh.triangles[at(triangle)][0])], Vec3::UnitX());
    } else {
        angle_ += 0.25;
        edit = tear(model(), state, 0, Vec3(std::cos(angle_), std::sin(angle_), 0.0) + state.tips[0].direction);
    }
    if (!edit.ok()) {
        state.tips.clear();
        return false;
    }
    state = applied(state, edit.value());
    return true;
}

ImplicitReport SplitRun::step() { return held_.step(step_s, {}, {.tolerance = 1e-4, .max_newton = 1}); }

}  // namespace rhexis::scenes
