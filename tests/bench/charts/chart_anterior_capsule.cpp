// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "bench/charts/models.hpp"
#include "bench/methods/tear_strength.hpp"
#include "bench/timing.hpp"
#include "scenes/tears.hpp"

namespace rhexis::bench {
namespace {

constexpr int usual_capsule = 1600;  ///< a mesh as fine as that of exercises (docs/accuracy.md)
const std::vector<int> crack_meshes{400, 1600, 6400};

/// One mesh: at which load its crack goes on by each criterion, per root of its length, and what a look costs.
struct Looked {
    std::size_t triangles = 0;
    bool goes_on = false;    ///< at both ends
    double by_energy = 0.0;  ///< over the handbook's
    double by_radius = 0.0;  ///< in the unit of its strength, as the next
    double by_ring = 0.0;
    double energy_s = 0.0;
    double radius_s = 0.0;
    double ring_s = 0.0;
};

double stress_over_strength(const TipStress& tip) {
    return search_directions(tip.stress, {1e6, 1e6, 1.0}, tip.fibre, Vec2::Zero(), 0.0).ratio;
}

Looked look(int triangles, int repeats) {
    scenes::MiddleCrack crack = scenes::middle_crack(triangles);
    const MembraneModel& model = crack.sheet->model();
    const MembraneState& state = crack.sheet->state();
    MembraneModel due = model;  // a tear that does not go on is looked at for less
    due.toughness = {0.5 * crack.release, 0.5 * crack.release};
    std::size_t proposals = 0;
    double ring = 0.0;
    double radius = 0.0;
    const auto sum_rings = [&] {
        ring = 0.0;
        for (const TearTip& tip : state.tips) {
            ring += stress_over_strength(one_ring_stress(model, state, tip)) / static_cast<double>(state.tips.size());
        }
    };
    const auto sum_radii = [&] {
        radius = 0.0;
        for (const TearTip& tip : state.tips) {
            radius += stress_over_strength(stress_at(model, state, tip.node, tip.direction)) /
                      static_cast<double>(state.tips.size());
        }
    };
    const std::vector<Timing> times =
        time_interleaved({[&] { proposals = propose_tears(due, state).size(); }, sum_radii, sum_rings}, repeats);
    const double root = std::sqrt(crack.half_length);
    return {model.sheet->mesh.triangles.size(),
            proposals == state.tips.size(),
            std::sqrt(crack.expected / crack.release),
            root / radius,
            root / ring,
            times[0].seconds,
            times[1].seconds,
            times[2].seconds};
}

std::vector<ChartPoint> measure_anterior_capsule(const ChartOptions& options) {
    std::vector<Looked> looks;
    for (const int triangles : crack_meshes) {
        if (!options.only_default || triangles == usual_capsule) {
            looks.push_back(look(triangles, options.repeats));
        }
    }
    std::vector<ChartPoint> points;
    const auto setting = [](const Looked& one) { return std::to_string(one.triangles) + " triangles"; };
    for (const Looked& one : looks) {
        const bool is_default = options.only_default || &one == &looks[1];
        points.push_back(point_of("kernel: energy that comes free", setting(one), is_default,
                                  std::abs(one.by_energy - 1.0), one.energy_s));
        points.back().failure = one.goes_on ? "" : "what was looked at is no tear that goes on";
    }
    for (const Looked& one : looks) {
        if (options.only_default || &one == &looks.back()) {
            break;
        }
        points.push_back(point_of("strength within 0.4 mm, set on the finest", setting(one), false,
                                  std::abs(one.by_radius / looks.back().by_radius - 1.0), one.radius_s));
        points.push_back(point_of("strength at the tip, set on the finest [Dequidt2013]", setting(one), false,
                                  std::abs(one.by_ring / looks.back().by_ring - 1.0), one.ring_s));
    }
    return points;
}

}  // namespace

Chart chart_anterior_capsule() {
    return {"anterior_capsule",
            "Load at which a tear of 2 mm in the middle of a pulled sheet goes on",
            "CPU seconds for one look at the tear's ends",
            "load, as a share of the answer",
            "the handbook's stress intensity of a middle crack [Tada1973]",
            true,
            measure_anterior_capsule};
}

}  // namespace rhexis::bench
