// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/viscoelastic_fill.hpp"

#include <algorithm>

namespace rhexis {
namespace {

bool inside(const ViscoelasticModel& model, const ToolState& tool) {
    const Vec3& tip = tool.pose.position;
    return tool.present && tip.x() * tip.x() + tip.y() * tip.y() < model.inner_radius * model.inner_radius;
}

}  // namespace

void fill_chamber(const WorldModel& world, std::span<const ToolState> tools, double dt, WorldState& state) {
    if (!state.viscoelastic) {
        return;
    }
    const ViscoelasticModel& model = *world.viscoelastic;
    ViscoelasticState& chamber = *state.viscoelastic;
    double lost = 0.0;
    for (std::size_t k = 0; k < tools.size(); ++k) {
        if (!inside(model, tools[k])) {
            continue;
        }
        lost += dt * model.leak * chamber.fill;
        if (world.tools[k].kind == ToolKind::cannula) {
            const double given = dt * model.injection * tools[k].jaw;
            chamber.injected += given;
            chamber.fill += given / model.volume;
        }
    }
    chamber.fill = std::max(0.0, chamber.fill - lost);
    chamber.peak_fill = std::max(chamber.peak_fill, chamber.fill);
    const double push = model.area * (model.vitreous_pressure - viscoelastic_pressure(model, chamber));
    for (MembraneState& membrane : state.membranes) {
        membrane.support.push = push;
    }
}

}  // namespace rhexis
