// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/timing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rhexis {
namespace {

double five_places(double value) { return std::round(value * 1e5) / 1e5; }

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

nlohmann::json Timing::performance(double simulated_s) const {
    std::vector<float> sorted = wall_ms_;
    std::sort(sorted.begin(), sorted.end());
    const double count = static_cast<double>(sorted.size());
    const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
    const std::size_t p99 = static_cast<std::size_t>(std::max(0.0, std::ceil(0.99 * count) - 1.0));
    return {{"steps", sorted.size()},
            {"cpu_s_per_s", simulated_s > 0.0 ? five_places(cpu_s_ / simulated_s) : 0.0},
            {"mean_step_ms", sorted.empty() ? 0.0 : five_places(sum / count)},
            {"p99_step_ms", sorted.empty() ? 0.0 : five_places(sorted[p99])},
            {"worst_step_ms", sorted.empty() ? 0.0 : five_places(sorted.back())},
            {"rollbacks", rollbacks_}};
}

nlohmann::json simulated_parts(const Session& session) {
    nlohmann::json parts = nlohmann::json::array();
    for (const auto& [name, part] : session.profile().parts) {
        parts.push_back(
            {{"part", name}, {"elements", elements_of(session.world(), name)}, {"cpu_s", five_places(part.cpu_s)}});
    }
    return parts;
}

}  // namespace rhexis
