// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/sculpt.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/material_points.hpp"
#include "physics/contact/tissue_near.hpp"
#include "physics/contact/tool_shape.hpp"

namespace rhexis {

namespace {

constexpr double sculpt_reach = 0.20;  ///< of the zone from the tip's surface [mm]
constexpr double blur = 0.10;          ///< over which its border fades, so that tissue enters gradually [mm]
constexpr double behind_mouth = 0.20;  ///< the zone goes on this far behind the plane of the mouth [mm]
constexpr int max_passes = 4;          ///< to hand on energy that vanished tetrahedra left over

/// A fine tetrahedron that the zone reaches.
struct Touched {
    int fine = 0;
    double weight = 0.0;   ///< share of it in the zone
    double volume = 0.0;   ///< at rest [mm^3]
    double energy = 0.0;   ///< to emulsify it [mJ/mm^3]
    double density = 0.0;  ///< [g/mm^3]
};

double fade(double depth) { return std::clamp(0.5 + depth / blur, 0.0, 1.0); }

/// The two bounds of the zone, 0 to 1: within reach of the tip's surface, on the front side of its mouth.
double around_tip(double distance) { return fade(sculpt_reach - distance); }
double ahead_of_mouth(const SculptZone& zone, const Vec3& point) {
    return fade(zone.facing.dot(point - zone.mouth) + behind_mouth);
}

double tet_weight(const ToolModel& tool, const SculptZone& zone, const Pose& pose, const std::array<Vec3, 4>& corners) {
    double weight = 0.0;
    for (const Vec3& place : material_places(corners)) {
        weight += 0.25 * zone_weight(tool, zone, pose.to_body(place));
    }
    return weight;
}

double rest_volume(const TetMesh& mesh, const std::array<int, 4>& tet) {
    return tet_volume(mesh.nodes[tet[0]], mesh.nodes[tet[1]], mesh.nodes[tet[2]], mesh.nodes[tet[3]]);
}

std::vector<Touched> find_touched(const SolidModel& model, const SolidState& state, const ToolModel& tool,
                                  const SculptZone& zone, const Pose& pose) {
    std::vector<Touched> touched;
    for (const FineTissue& fine : tissue_near(model, state, tool.parts.front(), pose, sculpt_reach + blur)) {
        const double weight = tet_weight(tool, zone, pose, fine.corners);
        if (weight > 0.0) {
            const int coarse = fine.tet / 8;
            const Material& material = model.materials[model.coarse.region[coarse]];
            const double volume = rest_volume(model.coarse, model.coarse.tets[coarse]) / 8.0;
            touched.push_back({fine.tet, weight, volume, material.ablation_energy, material.density});
        }
    }
    return touched;
}

/// A material point that the zone reaches.
struct TouchedPoint {
    std::size_t tissue = 0;  ///< index of its fine tetrahedron in what is near
    std::size_t point = 0;
    double weight = 0.0;  ///< how much it counts as inside
    double volume = 0.0;  ///< at rest [mm^3]
};

std::vector<TouchedPoint> touched_points(const SolidModel& model, const SolidState& state, const ToolModel& tool,
                                         const SculptZone& zone, const Pose& pose,
                                         const std::vector<FineTissue>& near) {
    std::vector<TouchedPoint> touched;
    for (std::size_t i = 0; i < near.size(); ++i) {
        const FineTissue& fine = near[i];
        const std::array<Vec3, 4> places = material_places(fine.corners);
        const std::array<double, 4> left = left_of_points(state, fine.tet);
        const double volume = rest_volume(model.coarse, model.coarse.tets[fine.tet / 8]) / 32.0;
        for (std::size_t p = 0; p < 4; ++p) {
            const double weight = left[p] > 0.0 ? zone_weight(tool, zone, pose.to_body(places[p])) : 0.0;
            if (weight > 0.0) {
                touched.push_back({i, p, weight, volume});
            }
        }
    }
    return touched;
}

/// Gives every point what its place in the zone is given by the power [mW] in dt [s]: P w / V of the zone, whatever the
/// others do, so that neither the mesh nor what is left around it matters. Returns the share of the power that found
/// tissue.
double spend_on_points(const SolidModel& model, const ToolModel& tool, const SculptZone& zone, const Pose& pose,
                       double power, double dt, SolidState& solid, WorldState& state) {
    const std::vector<FineTissue> near = tissue_near(model, solid, tool.parts.front(), pose, sculpt_reach + blur);
    const std::vector<TouchedPoint> touched = touched_points(model, solid, tool, zone, pose, near);
    double volume = 0.0;
    for (const TouchedPoint& point : touched) {
        volume += point.weight * point.volume;
    }
    const double density = power * dt / std::max(volume, zone.volume);  // of energy where the weight is 1 [mJ/mm^3]
    for (std::size_t first = 0, last = 0; first < touched.size(); first = last) {
        const int fine = near[touched[first].tissue].tet;
        const Material& material = model.materials[model.coarse.region[fine / 8]];
        std::array<double, 4> left = left_of_points(solid, fine);
        double lost = 0.0;
        for (last = first; last < touched.size() && touched[last].tissue == touched[first].tissue; ++last) {
            const TouchedPoint& point = touched[last];
            if (!(material.ablation_energy > 0.0)) {
                continue;  // takes up its share and stays
            }
            double& now = left[point.point];
            const double gone = std::min(now, density * point.weight / material.ablation_energy);
            lost += now - gone < least_fraction ? now : gone;
            now = now - gone < least_fraction ? 0.0 : now - gone;
        }
        set_points(solid, fine, left);
        lost *= touched[first].volume;
        state.removed_mass += lost * material.density;
        state.ablation_energy += lost * material.ablation_energy;
    }
    return std::min(1.0, volume / zone.volume);
}

/// Spends up to `energy` [mJ] on what is touched; returns what could not be used.
double spend(double energy, const std::vector<Touched>& touched, SolidState& solid, WorldState& state) {
    double total = 0.0;
    for (const Touched& tet : touched) {
        total += solid.fraction[tet.fine] > 0.0 ? tet.weight * tet.volume : 0.0;
    }
    double left = 0.0;
    for (const Touched& tet : touched) {
        double& fraction = solid.fraction[tet.fine];
        if (!(fraction > 0.0)) {
            continue;
        }
        const double share = energy * tet.weight * tet.volume / total;
        if (!(tet.energy > 0.0)) {
            continue;  // takes up its share and stays
        }
        double lost = std::min(fraction, share / (tet.energy * tet.volume));
        left += share - lost * tet.energy * tet.volume;
        if (fraction - lost < least_fraction) {
            lost = fraction;
        }
        fraction = lost == fraction ? 0.0 : fraction - lost;
        state.removed_mass += lost * tet.volume * tet.density;
        state.ablation_energy += lost * tet.volume * tet.energy;
    }
    return total > 0.0 ? left : 0.0;
}

}  // namespace

SculptZone sculpt_zone(const ToolModel& tool) {
    SculptZone zone;
    if (tool.kind != ToolKind::phaco || tool.parts.empty() || !(tool.max_power > 0.0)) {
        return zone;
    }
    const RoundedCone& end = tool.parts.front();
    const Mouth mouth = tip_mouth(tool);
    zone.mouth = mouth.centre;
    zone.facing = mouth.facing;
    // Volume by summing a grid, inside the tip left out
    constexpr double cell = 0.02;
    const int half = static_cast<int>(std::ceil((end.radius_a + sculpt_reach + blur) / cell));
    for (int i = -half; i <= half; ++i) {
        for (int j = -half; j <= half; ++j) {
            for (int k = -half; k <= 2 * half; ++k) {
                const Vec3 point = end.a + cell * Vec3(i, j, k);
                const double ahead = ahead_of_mouth(zone, point);
                if (!(ahead > 0.0)) {
                    continue;  // the distance, which costs most here, need not be known
                }
                const double distance = cone_distance(end, point).distance;
                if (distance >= 0.0) {
                    zone.volume += cell * cell * cell * std::min(around_tip(distance), ahead);
                }
            }
        }
    }
    return zone;
}

double zone_weight(const ToolModel& tool, const SculptZone& zone, const Vec3& point) {
    const double ahead = ahead_of_mouth(zone, point);
    return ahead > 0.0 ? std::min(around_tip(cone_distance(tool.parts.front(), point).distance), ahead) : 0.0;
}

double sculpt(const WorldModel& model, int tool, const ToolState& tool_state, const SculptZone& zone, double dt,
              WorldState& state) {
    if (!tool_state.present || !(tool_state.power > 0.0) || !(zone.volume > 0.0)) {
        return 0.0;
    }
    const ToolModel& tool_model = model.tools[tool];
    double unused = 1.0;  // share
    for (std::size_t s = 0; s < model.solids.size(); ++s) {
        SolidState& solid = state.solids[s];
        if (solid.fraction.empty()) {
            continue;
        }
        if (model.solids[s].by_points) {
            unused -= spend_on_points(model.solids[s], tool_model, zone, tool_state.pose,
                                      tool_state.power * tool_model.max_power, dt, solid, state);
            unused = std::max(0.0, unused);
            continue;
        }
        const std::vector<Touched> touched = find_touched(model.solids[s], solid, tool_model, zone, tool_state.pose);
        double volume = 0.0;
        for (const Touched& tet : touched) {
            volume += tet.weight * tet.volume;
        }
        const double coverage = std::min(1.0, volume / zone.volume);
        double energy = tool_state.power * tool_model.max_power * dt * coverage;
        // What vanished tetrahedra leave over is used by the others only where energy is what limits.
        for (int pass = 0; pass < (coverage < 1.0 ? 1 : max_passes) && energy > 0.0; ++pass) {
            energy = spend(energy, touched, solid, state);
        }
        unused = std::max(0.0, unused - coverage);
    }
    return unused * tool_state.power * tool_model.max_power * dt;
}

}  // namespace rhexis
