// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/suction_grip.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

constexpr double sound = 0.3;              ///< a fine tetrahedron with less of it left shuts nothing
constexpr double farthest_shutting = 1.0;  ///< tissue that shuts the mouth, by its middle [mm]
constexpr double least_reach = 0.8;        ///< of the patch from the mouth [mm]
constexpr double most_grip_reach = 2.0;

double longest_edge(const std::vector<Vec3>& x, const std::array<int, 4>& tet) {
    double square = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            square = std::max(square, (x[tet[i]] - x[tet[j]]).squaredNorm());
        }
    }
    return std::sqrt(square);
}

/// Coarse tetrahedra with tissue right before the mouth.
std::vector<int> seeds_of(const WorldModel& model, const WorldState& state, int tool, const Mouth& mouth,
                          const Pose& pose) {
    std::vector<int> found;
    for (const BeforeMouth& near : before_mouth(model, state, tool, mouth, pose)) {
        if (near.distance < farthest_shutting && state.solids[0].fraction[near.fine] > sound) {
            found.push_back(near.fine / 8);
        }
    }
    return found;
}

/// Mass per node of what hangs together with the seeds by nodes within `reach` of a place; fades towards its border.
std::vector<double> patch_mass(const SolidModel& model, const SolidState& state, const std::vector<int>& seeds,
                               const Vec3& place, double reach) {
    const std::vector<Vec3>& x = state.position;
    std::vector<int> near;
    for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
        const std::array<int, 4>& tet = model.coarse.tets[t];
        const bool within = std::any_of(tet.begin(), tet.end(),
                                        [&](int node) { return (x[node] - place).squaredNorm() < reach * reach; });
        if (within && state.present[t] != 0) {
            near.push_back(static_cast<int>(t));
        }
    }
    std::vector<std::uint8_t> reached(x.size(), 0);
    const auto reach_all = [&](int t) {
        for (const int node : model.coarse.tets[t]) {
            reached[node] = (x[node] - place).squaredNorm() < reach * reach ? 1 : reached[node];
        }
    };
    std::for_each(seeds.begin(), seeds.end(), reach_all);
    std::vector<double> mass(x.size(), 0.0);
    for (std::size_t before = near.size() + 1; !near.empty() && near.size() < before;) {
        before = near.size();
        std::vector<int> rest;
        for (const int t : near) {
            const std::array<int, 4>& tet = model.coarse.tets[t];
            if (std::none_of(tet.begin(), tet.end(), [&](int node) { return reached[node] != 0; })) {
                rest.push_back(t);
                continue;
            }
            reach_all(t);
            const double quarter = 0.25 * tet_mass(model, t) * remaining_fraction(model, state, t);
            for (const int node : tet) {
                mass[node] += quarter * std::max(0.0, 1.0 - (x[node] - place).norm() / reach);
            }
        }
        near = std::move(rest);
    }
    return mass;
}

}  // namespace

void find_grips(const WorldModel& model, const WorldState& state, std::span<const ToolState> tools,
                std::span<const MouthProbe> probes, std::vector<SuctionGrip>& grips) {
    grips.clear();
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const double limit = hold_of_lens(state.tips[i]);
        if (!tools[i].present || !(limit > 0.0) || tools[i].power > 0.0 || state.solids.empty() ||
            state.solids[0].fraction.empty()) {
            continue;
        }
        // poses at the start of the step, as the positions are
        const Pose& pose = tools[i].previous_pose;
        const Mouth& mouth = probes[i].mouth;
        const std::vector<int> seeds = seeds_of(model, state, static_cast<int>(i), mouth, pose);
        double reach = 0.0;
        for (const int t : seeds) {
            reach = std::max(reach, longest_edge(model.solids[0].coarse.nodes, model.solids[0].coarse.tets[t]));
        }
        reach = std::clamp(reach, least_reach, most_grip_reach);
        const std::vector<double> mass =
            patch_mass(model.solids[0], state.solids[0], seeds, pose.to_world(mouth.centre), reach);
        SuctionGrip grip;
        grip.tool = static_cast<int>(i);
        grip.limit = limit;
        grip.mouth = mouth.centre;
        double sum = 0.0;
        for (std::size_t node = 0; node < mass.size(); ++node) {
            if (mass[node] > 0.0) {
                grip.nodes.push_back(static_cast<int>(node));
                grip.weights.push_back(mass[node]);
                sum += mass[node];
            }
        }
        if (!(sum > 0.0)) {
            continue;
        }
        for (double& weight : grip.weights) {
            weight /= sum;
        }
        grips.push_back(std::move(grip));
    }
}

void report_grips(const std::vector<SuctionGrip>& grips, std::span<const ToolState> tools, int solid, double dt,
                  ContactSet& contacts) {
    for (const SuctionGrip& grip : grips) {
        if (grip.impulse.isZero(0.0)) {
            continue;
        }
        const auto most = std::max_element(grip.weights.begin(), grip.weights.end());
        Contact contact;
        contact.solid = solid;
        contact.nodes[0] = grip.nodes[static_cast<std::size_t>(most - grip.weights.begin())];
        contact.partner_index = grip.tool;
        contact.point = tools[grip.tool].pose.to_world(grip.mouth);
        contact.normal = grip.impulse.normalized();
        contact.force = grip.impulse / dt;
        contact.sliding = grip.impulse.norm() > 0.99 * dt * grip.limit;
        contacts.push_back(contact);
    }
}

}  // namespace rhexis
