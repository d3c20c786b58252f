// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/viscoelastic_fill.hpp"

#include <algorithm>

#include "physics/anatomy/globe_roll.hpp"

namespace rhexis {
namespace {

constexpr double sheared =
    0.1;  ///< viscosity of viscoelastic in a slit, at thousands of shears a second [Pa s]. Proposal

/// Through a wound whose lip a shaft presses, share of the chamber per second.
double burped(const WorldModel& world, std::span<const ToolState> tools, const WorldState& state) {
    if (!world.globe) {
        return 0.0;
    }
    const double pressure = std::max(0.0, viscoelastic_pressure(*world.viscoelastic, *state.viscoelastic));
    const double thinner = world.globe->viscosity / sheared;
    return thinner * pressed_open(world, tools, state) * pressure / world.viscoelastic->volume;
}

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
    double lost = dt * burped(world, tools, state);
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
