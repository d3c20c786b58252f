// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/implicit_trials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "base/rng.hpp"
#include "energy/corotational_tet.hpp"
#include "mesh/shapes.hpp"
#include "physics/solid/implicit_solid.hpp"
#include "physics/solid/solid_share.hpp"
#include "scenes/bodies.hpp"
#include "scenes/explicit_trials.hpp"
#include "scenes/measures.hpp"

namespace rhexis::scenes {
namespace {

/// A solid stepped without contact.
class Free {
public:
    explicit Free(const SolidModel& model)
        : model_(model),
          pool_(1),
          solid_(std::move(ImplicitSolid::create(model, pool_)).value()),
          state(rest_state(model)) {}

    ImplicitReport step(const Vec3& gravity, double dt, const ImplicitSettings& settings) {
        const ImplicitReport report = solid_.step(state, gravity, {}, dt, settings, {}, none_, next_);
        next_.present = state.present;
        next_.fraction = state.fraction;
        std::swap(state, next_);
        return report;
    }
    [[nodiscard]] std::vector<double> mass() const {
        return node_mass(model_, state, tet_stiffness(model_, state)).inertia;
    }
    void forget() { solid_.drop_caches(); }

private:
    const SolidModel& model_;
    ThreadPool pool_;
    ImplicitSolid solid_;
    SolidState next_;
    std::vector<RigidUnknown> none_;

public:
    SolidState state;
};

Vec3 contorted(const Vec3& rest, Contortion contortion) {
    if (contortion == Contortion::twisted) {
        const double angle = std::numbers::pi * rest.x() / 4.0;
        const double y = rest.y() - 0.5;
        const double z = rest.z() - 0.5;
        return {rest.x(), 0.5 + std::cos(angle) * y - std::sin(angle) * z,
                0.5 + std::sin(angle) * y + std::cos(angle) * z};
    }
    const double radius = 4.0 / std::numbers::pi;
    const double angle = rest.x() / radius;
    const double away = radius - (rest.z() - 0.5);
    return {away * std::sin(angle), rest.y(), 0.5 + radius - away * std::cos(angle)};
}

constexpr ImplicitSettings linear_step{.tolerance = 1e-9, .max_newton = 1};

}  // namespace

Untangling untangle(Contortion contortion, bool smooth, int across, double dt) {
    SolidModel model = clamped_bar(4 * across, across, across, 1.0 / across, 3000.0, 0.45);
    const std::vector<int> end = nodes_on_plane(model.coarse, Vec3(4.0, 0.0, 0.0), Vec3::UnitX());
    model.fixed_nodes.insert(model.fixed_nodes.end(), end.begin(), end.end());
    std::sort(model.fixed_nodes.begin(), model.fixed_nodes.end());
    SolidState start = rest_state(model);
    for (std::size_t i = 0; i < start.position.size(); ++i) {
        const Vec3& rest = model.coarse.nodes[i];
        if (smooth || rest.x() > 4.0 - 1e-9) {
            start.position[i] = contorted(rest, contortion);
        }
    }
    Untangling result;
    result.inverted_start = inverted_share(model, start);
    double before = HUGE_VAL;
    // a step cut after 2, 3, 4 ... iterations gives the residual of each: the same step every time
    for (int limit = 2; limit <= 60; ++limit) {
        Free body(model);
        body.state = start;
        const ImplicitReport report =
            body.step(Vec3::Zero(), dt, {.tolerance = 1e-9, .max_newton = limit, .newton_tolerance = 1e-8});
        result.worst_ratio = std::max(result.worst_ratio, report.force / before);
        before = report.force;
        result.iterations = report.newton_iterations;
        result.residual = report.newton_residual;
        result.inverted_end = inverted_share(model, body.state);
        if (report.converged) {
            break;
        }
    }
    return result;
}

Sag sag(int across, double poisson_ratio, double reference, double sliver) {
    SolidModel model = clamped_bar(4 * across, across, across, 1.0 / across, 3000.0, poisson_ratio);
    if (sliver < 1.0) {
        flatten_one(model, sliver);
    }
    model.fine = FineMesh{};
    model.damping_mass = 200.0;  // [1/s], about twice the first bending frequency
    Free body(model);
    Sag result;
    result.converged = true;
    for (int i = 0; i < 60; ++i) {
        const ImplicitReport report = body.step(Vec3(0.0, 0.0, -1.0 / model.materials[0].density), 0.01, linear_step);
        result.converged = result.converged && report.converged;
        result.linear = std::max(result.linear, report.linear_iterations);
        result.residual = std::max(result.residual, report.residual);
    }
    result.ratio = tip_sag(model, body.state.position) / reference;
    return result;
}

Staleness grow_stale(int steps) {
    const SolidModel model = clamped_bar(12, 3, 3, 1.0 / 3.0, 3000.0, 0.45);
    Free fresh(model);
    Free stale(model);
    Staleness result;
    for (int i = 0; i < steps; ++i) {
        fresh.forget();
        result.fresh += fresh.step(Vec3(0.0, 0.0, -2000.0), 0.01, linear_step).linear_iterations;
        result.stale += stale.step(Vec3(0.0, 0.0, -2000.0), 0.01, linear_step).linear_iterations;
    }
    result.fresh /= steps;
    result.stale /= steps;
    for (std::size_t i = 0; i < model.coarse.nodes.size(); ++i) {
        result.difference = std::max(result.difference, (fresh.state.position[i] - stale.state.position[i]).norm());
        result.moved = std::max(result.moved, (fresh.state.position[i] - model.coarse.nodes[i]).norm());
    }
    return result;
}

QuietEnd remove_all(const SolidModel& model, int per_step) {
    Free body(model);
    const double whole = remaining_mass(model, body.state);
    Rng rng(4, "deletion");
    std::vector<int> left(model.coarse.tets.size());
    std::iota(left.begin(), left.end(), 0);
    QuietEnd result;
    result.converged = true;
    double removed = 0.0;
    while (!left.empty()) {
        for (int k = 0; k < per_step && !left.empty(); ++k) {
            const std::int64_t pick = rng.integer(0, static_cast<std::int64_t>(left.size()) - 1);
            const int t = left[static_cast<std::size_t>(pick)];
            left[static_cast<std::size_t>(pick)] = left.back();
            left.pop_back();
            removed += tet_mass(model, t);
            body.state.present[at(t)] = 0;
            for (int child = 8 * t; !body.state.fraction.empty() && child < 8 * t + 8; ++child) {
                body.state.fraction[at(child)] = 0.0;
            }
        }
        const ImplicitReport report =
            body.step(Vec3(0.0, 0.0, -9810.0), 0.01, {.tolerance = 1e-6, .max_newton = 8, .newton_tolerance = 1e-3});
        result.converged = result.converged && report.converged;
        result.mass_error =
            std::max(result.mass_error, std::abs(removed + remaining_mass(model, body.state) - whole) / whole);
        result.rest_speed = 0.0;
        for (const Vec3& velocity : body.state.velocity) {
            result.rest_speed = std::max(result.rest_speed, velocity.norm());
        }
        result.fastest = std::max(result.fastest, result.rest_speed);
        ++result.steps;
    }
    result.finite = std::isfinite(result.fastest) && std::isfinite(body.state.position[0].sum());
    return result;
}

Drift drift(SolidModel model, int steps, double dt) {
    model.damping_mass = 0.0;
    model.damping_stiffness = 0.0;
    model.fixed_nodes.clear();
    Free body(model);
    const Vec3 spin(3.0, -2.0, 5.0);
    for (std::size_t i = 0; i < body.state.position.size(); ++i) {
        body.state.velocity[i] = Vec3(2.0, 1.0, -1.0) + spin.cross(body.state.position[i]);
        body.state.position[i] = body.state.position[i].cwiseProduct(Vec3(1.05, 0.97, 1.02));
    }
    const std::vector<double> mass = body.mass();
    const Motion first = motion_of(body.state, mass);
    const double whole = first.kinetic + elastic_energy(model, body.state);
    Motion last = first;
    double energy = whole;
    Drift result;
    Vec3 own = Vec3::Zero();
    for (int i = 0; i < steps; ++i) {
        const std::vector<Vec3> before = body.state.velocity;
        body.step(Vec3::Zero(), dt, {.tolerance = 1e-12, .max_newton = 12, .newton_tolerance = 1e-13});
        for (std::size_t k = 0; k < before.size(); ++k) {
            own += dt * mass[k] * body.state.velocity[k].cross(before[k]);
        }
        last = motion_of(body.state, mass);
        const double now = last.kinetic + elastic_energy(model, body.state);
        result.rise = std::max(result.rise, (now - energy) / whole);
        energy = now;
    }
    result.linear = (last.linear - first.linear).norm() / first.linear_scale / steps;
    result.angular = (last.angular - first.angular - own).norm() / last.angular_scale / steps;
    result.left = energy / whole;
    return result;
}

Recovery recover_implicit(SolidModel model, BadStart start, double seconds, double dt) {
    Free body(model);
    place_badly(body.state, start);
    const std::vector<double> mass = body.mass();
    const auto energy = [&] { return elastic_energy(model, body.state) + motion_of(body.state, mass).kinetic; };
    Recovery result;
    result.inverted_at_start = inverted_share(model, body.state);
    const double first = energy();
    double last = first;
    for (double time = 0.0; time < seconds - 1e-9; time += dt) {
        body.step(Vec3::Zero(), dt, {.tolerance = 0.03, .max_newton = 16, .newton_tolerance = 1e-4});
        const double now = energy();
        result.largest_rise = std::max(result.largest_rise, (now - last) / first);
        last = now;
    }
    result.finite = std::isfinite(last);
    result.energy_left = last / first;
    result.inverted_at_end = inverted_share(model, body.state);
    return result;
}

}  // namespace rhexis::scenes
