// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/run_out.hpp"

#include <algorithm>

#include "base/rng.hpp"
#include "flow/viscoelastic.hpp"
#include "tools/rhexis_tools.hpp"

namespace rhexis::scenes {
namespace {

constexpr double arc_at_start = 1.2;          ///< [rad]
constexpr FlapPull leading{10.0, 80.0, 1.5};  ///< of a hand that steers
constexpr double rescued_within = 0.3;        ///< of the planned radius [mm]
constexpr double edge_radius = 4.1;           ///< the sheet ends at 4.3 mm [mm]
constexpr int pulls_at_start = 2;
constexpr int settling_steps = 60;        ///< until lens and capsule are at rest
constexpr double mean_habit = 10.0;       ///< [degrees]
constexpr double spread_of_habit = 12.0;  ///< standard deviation [degrees]
constexpr double spread_of_pulls = 8.0;   ///< likewise

}  // namespace

double push_of_vitreous(const Chamber& chamber) {
    const ViscoelasticModel model{.vitreous_pressure = chamber.vitreous_mmhg * pascal_per_mmhg};
    const ViscoelasticState state{.fill = chamber.fill};
    return model.area * (model.vitreous_pressure - viscoelastic_pressure(model, state));
}

Pulls steady_pulls(double inwards) {
    Pulls pulls;
    pulls.fill(inwards);
    return pulls;
}

Pulls pulls_of_beginner(std::uint64_t seed) {
    Rng rng(seed, "beginner's pulls");
    const double habit = mean_habit + spread_of_habit * rng.normal();
    Pulls pulls{};
    for (double& pull : pulls) {
        pull = habit + spread_of_pulls * rng.normal();
    }
    return pulls;
}

RunOutTrial::RunOutTrial(double age, std::uint64_t mesh_seed, int triangles)
    : scene_(age, {.triangles = triangles, .mesh_seed = mesh_seed}, {capsulorhexis_forceps()}) {
    scene_.settle(settling_steps);
    scene_.open_flap(1.0, planned_radius, arc_at_start);
    const MembraneState& sheet = scene_.sheet();
    FlapHand hand(scene_, sheet.sheet->mesh.nodes[static_cast<std::size_t>(sheet.tips.back().node)]);
    scene_.settle(settling_steps);
    for (int i = 0; i < pulls_at_start; ++i) {
        hand.pull(leading);
    }
    start_ = {sheet, hand.end()};
}

RunOutResult RunOutTrial::run(const Chamber& chamber, const Pulls& pulls, double out_by) {
    scene_.sheet() = start_.sheet;
    scene_.sheet().support.push = push_of_vitreous(chamber);
    scene_.settle(settling_steps);
    FlapHand hand(scene_, start_.end);
    RunOutResult result;
    for (const double inwards : pulls) {
        const PullResult pull =
            hand.pull({.inwards = inwards, .farthest_radius = planned_radius + out_by, .farthest_round = far_enough});
        ++result.pulls;
        result.peak_force = std::max(result.peak_force, pull.peak_force);
        result.end_lost = pull.end == PullEnd::end_lost;
        if (pull.end == PullEnd::too_far_out || pull.end == PullEnd::gone_round) {
            result.fate = pull.end == PullEnd::too_far_out ? Fate::ran_out : Fate::kept;
            break;
        }
        if (result.end_lost) {
            break;
        }
    }
    result.radius = hand.radius();
    result.round = hand.round();
    end_ = hand.end();
    return result;
}

RescueResult RunOutTrial::rescue(const TornFlap& from, const Chamber& chamber, double inwards) {
    scene_.sheet() = from.sheet;
    scene_.sheet().support.push = push_of_vitreous(chamber);
    scene_.settle(settling_steps);
    FlapHand hand(scene_, from.end);
    const FlapPull pull{.inwards = inwards,
                        .held_behind = 0.5,
                        .height = 0.05,
                        .unfold = true,
                        .length = 0.8,
                        .farthest_radius = edge_radius};
    RescueResult result;
    while (result.pulls < most_pulls && !result.rescued && !result.reached_edge) {
        const PullEnd end = hand.pull(pull).end;
        ++result.pulls;
        result.rescued = hand.radius() < planned_radius + rescued_within;
        result.reached_edge = end == PullEnd::too_far_out || (end == PullEnd::end_lost && !result.rescued);
    }
    result.radius = hand.radius();
    return result;
}

}  // namespace rhexis::scenes
