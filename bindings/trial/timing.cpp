// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/timing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rhexis {
namespace {

/// Elements behind a part of the profile: a body's coarse tetrahedra or triangles, else those of all bodies.
std::size_t elements_of(const WorldModel& world, const std::string& part) {
    std::size_t all = 0;
    std::size_t own = 0;
    const auto count = [&](const std::string& name, std::size_t elements) {
        all += elements;
        own += part == name ? elements : 0;
    };
    for (const SolidModel& solid : world.solids) {
        count(solid.name, solid.coarse.tets.size());
    }
    for (const MembraneModel& membrane : world.membranes) {
        count(membrane.name, membrane.sheet->mesh.triangles.size());
    }
    for (const ShellModel& shell : world.shells) {
        count(shell.name, shell.mesh.triangles.size());
    }
    return own > 0 ? own : all;
}

}  // namespace

Status Timing::stepped(const TrialStep& step) {
    cpu_s_ += step.cpu_s;
    wall_ms_.push_back(static_cast<float>(step.wall_s * 1e3));
    rollbacks_ += step.outcome.rollbacks;
    return success();
}

Performance Timing::performance(double simulated_s) const {
    std::vector<float> sorted = wall_ms_;
    std::sort(sorted.begin(), sorted.end());
    Performance cost;
    cost.steps = sorted.size();
    cost.cpu_s_per_s = simulated_s > 0.0 ? cpu_s_ / simulated_s : 0.0;
    cost.rollbacks = rollbacks_;
    if (!sorted.empty()) {
        const double count = static_cast<double>(sorted.size());
        const std::size_t p99 = static_cast<std::size_t>(std::max(0.0, std::ceil(0.99 * count) - 1.0));
        cost.mean_step_ms = std::accumulate(sorted.begin(), sorted.end(), 0.0) / count;
        cost.p99_step_ms = sorted[p99];
        cost.worst_step_ms = sorted.back();
    }
    return cost;
}

std::vector<SimulatedPart> simulated_parts(const Session& session) {
    std::vector<SimulatedPart> parts;
    for (const auto& [name, part] : session.profile().parts) {
        parts.push_back({name, elements_of(session.world(), name), part.cpu_s});
    }
    return parts;
}

}  // namespace rhexis
