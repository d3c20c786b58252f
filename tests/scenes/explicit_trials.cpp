// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/explicit_trials.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/index.hpp"
#include "base/rng.hpp"

namespace rhexis::scenes {
namespace {

ExplicitSolid solid_of(const SolidModel& model) { return ExplicitSolid::create(model, "").value(); }

double mass_left(const SolidModel& model, const SolidState& state) {
    double sum = 0.0;
    for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
        const TetPoints x = corners(model.coarse.nodes, model.coarse.tets[t]);
        sum += state.present[t] != 0
                   ? tet_volume(x[0], x[1], x[2], x[3]) * model.materials[at(model.coarse.region[t])].density
                   : 0.0;
    }
    return sum;
}

Motion motion_of(const ExplicitSolid& solid, SolidState& state) {
    solid.store(state);
    std::vector<double> mass;
    for (int i = 0; i < static_cast<int>(state.position.size()); ++i) {
        mass.push_back(solid.mass(i));
    }
    return scenes::motion_of(state, mass);
}

}  // namespace

double total_energy(const SolidModel& model, const SolidState& state, const ExplicitSolid& solid) {
    double energy = elastic_energy(model, state);
    for (std::size_t i = 0; i < state.velocity.size(); ++i) {
        energy += 0.5 * solid.mass(static_cast<int>(i)) * state.velocity[i].squaredNorm();
    }
    return energy;
}

Recovery recover(SolidModel model, BadStart start, double seconds) {
    SolidState state = rest_state(model);
    place_badly(state, start);
    ExplicitSolid solid = solid_of(model);
    solid.load(state);
    Recovery result;
    result.inverted_at_start = inverted_share(model, state);
    const double first = total_energy(model, state, solid);
    // far from rest the stiffness is up to twice that at rest: half a stable step
    const double dt = 0.5 * solid.stable_step();
    constexpr int samples = 50;
    const int between = std::max(1, static_cast<int>(seconds / dt / samples));
    double last = first;
    for (int s = 0; s < samples; ++s) {
        for (int k = 0; k < between; ++k) {
            solid.predict(dt, Vec3::Zero(), {});
            solid.move(dt);
        }
        solid.store(state);
        const double now = total_energy(model, state, solid);
        result.largest_rise = std::max(result.largest_rise, (now - last) / first);
        last = now;
    }
    result.finite = solid.finite();
    result.energy_left = last / first;
    result.inverted_at_end = inverted_share(model, state);
    return result;
}

Deletion delete_all(SolidModel model, int per_round, int round) {
    SolidState state = rest_state(model);
    ExplicitSolid solid = solid_of(model);
    const double whole = solid.stable_step();
    const double mass = mass_left(model, state);
    Rng rng(4, "deletion");
    std::vector<int> left(model.coarse.tets.size());
    std::iota(left.begin(), left.end(), 0);
    Deletion result;
    result.smallest_step = 1.0;
    double removed = 0.0;
    while (!left.empty()) {
        for (int k = 0; k < per_round && !left.empty(); ++k) {
            const std::int64_t pick = rng.integer(0, static_cast<std::int64_t>(left.size()) - 1);
            const int t = left[static_cast<std::size_t>(pick)];
            left[static_cast<std::size_t>(pick)] = left.back();
            left.pop_back();
            state.present[at(t)] = 0;
            const TetPoints x = corners(model.coarse.nodes, model.coarse.tets[at(t)]);
            removed += tet_volume(x[0], x[1], x[2], x[3]) * model.materials[at(model.coarse.region[at(t)])].density;
        }
        solid.load(state);
        const double limit = solid.stable_step();
        result.smallest_step = std::min(result.smallest_step, limit / whole);
        const double dt = 0.8 * std::min(limit, whole);
        for (int k = 0; k < round; ++k, ++result.steps) {
            solid.predict(dt, Vec3(0.0, 0.0, -9810.0), {});
            solid.move(dt);
        }
        solid.store(state);
        for (const Vec3& v : state.velocity) {
            result.fastest = std::max(result.fastest, v.norm());
        }
        result.mass_error = std::max(result.mass_error, std::abs(removed + mass_left(model, state) - mass) / mass);
        if (!solid.finite()) {
            return result;
        }
    }
    result.finite = solid.finite();
    return result;
}

Flight fly(SolidModel model, int steps, double share) {
    model.damping_mass = 0.0;
    model.damping_stiffness = 0.0;
    model.fixed_nodes.clear();
    SolidState state = rest_state(model);
    const Vec3 spin(3.0, -2.0, 5.0);
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        state.velocity[i] = Vec3(2.0, 1.0, -1.0) + spin.cross(state.position[i]);
        state.position[i] = state.position[i].cwiseProduct(Vec3(1.05, 0.97, 1.02));
    }
    ExplicitSolid solid = solid_of(model);
    solid.load(state);
    const double dt = share * solid.stable_step();
    const Motion before = motion_of(solid, state);
    constexpr int samples = 1000;
    std::vector<double> energy;
    std::vector<double> heat;
    for (int k = 0; k < steps; ++k) {
        solid.predict(dt, Vec3::Zero(), {});
        solid.move(dt);
        if ((k + 1) % std::max(1, steps / samples) == 0) {
            heat.push_back(motion_of(solid, state).heat);
            energy.push_back(total_energy(model, state, solid));
        }
    }
    const Motion after = motion_of(solid, state);
    const auto drift = [](const std::vector<double>& series) {
        const auto tenth = static_cast<std::ptrdiff_t>(series.size() / 10);
        const double first = std::accumulate(series.begin(), series.begin() + tenth, 0.0);
        return std::accumulate(series.end() - tenth, series.end(), 0.0) / first - 1.0;
    };
    Flight result;
    result.linear_drift = (after.linear - before.linear).norm() / before.linear_scale / steps;
    result.angular_drift = (after.angular - before.angular).norm() / before.angular_scale / steps;
    result.energy_drift = drift(energy);
    result.temperature = drift(heat);
    return result;
}

Limit probe_limit(const SolidModel& model) {
    const auto bounded_at = [&model](double factor) {
        ExplicitSolid solid = solid_of(model);
        const double dt = factor * solid.stable_step();
        Rng rng(6, "kick");
        const int nodes = static_cast<int>(model.coarse.nodes.size());
        for (int i = 0; i < nodes; ++i) {
            solid.set_velocity(i, 10.0 * Vec3(rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5));
        }
        for (int k = 0; k < 1500; ++k) {
            solid.predict(dt, Vec3::Zero(), {});
            solid.move(dt);
        }
        double fastest = 0.0;
        for (int i = 0; i < nodes; ++i) {
            fastest = std::max(fastest, solid.velocity(i).norm());
        }
        return solid.finite() && fastest < 100.0;
    };
    Limit limit;
    limit.step = solid_of(model).stable_step();
    limit.below = bounded_at(0.97);
    limit.beyond = !bounded_at(1.1);
    return limit;
}

void flatten_one(SolidModel& model, double share) {
    const std::array<int, 4>& tet = model.coarse.tets[0];
    std::vector<Vec3>& x = model.coarse.nodes;
    const Vec3 across = (x[at(tet[2])] - x[at(tet[1])]).cross(x[at(tet[3])] - x[at(tet[1])]).normalized();
    const double height = (x[at(tet[0])] - x[at(tet[1])]).dot(across);
    x[at(tet[0])] -= (1.0 - share) * height * across;
}

}  // namespace rhexis::scenes
