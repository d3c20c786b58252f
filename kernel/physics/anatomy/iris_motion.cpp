// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/iris_motion.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

constexpr double iris_catching = 0.3;  ///< share of the mouth that the iris must cover to be caught. Proposal
constexpr double tear_rate = 2.0;      ///< of the arc, while stretched beyond what it bears [mm/s]. Proposal

/// The edge of the pupil nearest to a place, at rest.
Vec3 edge_near(const IrisState& iris, const Vec3& place) {
    const double rho = place.head<2>().norm();
    const Vec2 direction = rho > 0.0 ? Vec2(place.head<2>() / rho) : Vec2(Vec2::UnitX());
    return {iris.pupil_radius * direction.x(), iris.pupil_radius * direction.y(), iris.z};
}

void catch_edge(std::span<const ToolState> tools, std::span<const MouthProbe> probes, WorldState& state) {
    IrisState& iris = *state.iris;
    for (std::size_t i = 0; i < tools.size() && iris.tool < 0; ++i) {
        if (state.tips[i].iris >= iris_catching && state.tips[i].suction >= least_suction) {
            iris.tool = static_cast<int>(i);
            iris.place = edge_near(iris, tools[i].pose.to_world(probes[i].mouth.centre));
        }
    }
}

void pull_edge(const IrisModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes, double dt,
               WorldState& state) {
    IrisState& iris = *state.iris;
    const TipState& tip = state.tips[iris.tool];
    const double pull = (tools[iris.tool].pose.to_world(probes[iris.tool].mouth.centre) - iris.place).norm();
    iris.strain = pull / (model.root_radius - model.pupil_radius);
    if (iris.strain > model.tear_strain) {
        iris.torn += tear_rate * dt;
    }
    if (tip.suction < least_suction || model.stiffness * pull > tip.suction * probes[iris.tool].area) {
        iris.tool = -1;
    }
}

}  // namespace

void move_iris(const WorldModel& model, std::span<const ToolState> tools, std::span<const MouthProbe> probes, double dt,
               WorldState& state) {
    IrisState& iris = *state.iris;
    const WoundsState* const wounds = state.wounds ? &*state.wounds : nullptr;
    const double shift =
        state.chamber ? diaphragm_shift(*model.chamber, volume_in_front(*state.chamber, wounds), 0.0) : 0.0;
    iris.z = model.iris->rest_z + shift;
    iris.pupil_radius = model.iris->pupil_radius * std::clamp(1.0 - model.iris->widening * shift, 0.5, 1.5);
    if (state.hydrodissection) {
        iris.z += forward_shift(*model.hydrodissection, *state.hydrodissection);
        iris.pupil_radius *= pupil_share(*model.hydrodissection, *state.hydrodissection);
    }
    iris.strain = 0.0;
    if (iris.tool >= 0 && !tools[iris.tool].present) {
        iris.tool = -1;
    }
    if (iris.tool < 0) {
        catch_edge(tools, probes, state);
    }
    if (iris.tool >= 0) {
        pull_edge(*model.iris, tools, probes, dt, state);
    }
}

}  // namespace rhexis
