// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to solve contact of a shell against a lifted cantilever's elastica: error of the force and penetration against
// CPU time, springs of several stiffnesses and compliance warping.
#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "bench/bench_shell.hpp"
#include "bench/methods/warped_contact.hpp"
#include "scenes/lifted_strip.hpp"
#include "scenes/shell_contacts.hpp"

namespace rhexis::bench {
namespace {

constexpr double dt = 0.05;
constexpr int raising = 20;  // steps
constexpr int steps = 60;
constexpr ImplicitSettings balanced{.tolerance = 1e-4, .max_newton = 60, .newton_tolerance = 1e-7};

struct Outcome {
    double force = 0.0;     ///< [uN]
    double deepest = 0.0;   ///< over thickness
    double step_s = 0.0;    ///< CPU of a step
    double contacts = 0.0;  ///< that touch, mean of the steps
    double gate_error = 0.0;
    int factors = 0;
};

/// Repeated, for the shortest time.
template <typename Run>
Outcome best(const BenchOptions& options, const Run& run) {
    Outcome outcome = run();
    for (int i = 1; i < std::min(options.repeats, 3); ++i) {
        outcome.step_s = std::min(outcome.step_s, run().step_s);
    }
    return outcome;
}

Outcome by_springs(const scenes::LiftedStrip& strip, double stiffer) {
    const ShellModel model = strip.model();
    ShellContactSettings contact;
    contact.stiffer = stiffer;
    scenes::TouchingShell shell(model, contact);
    Outcome outcome;
    for (int i = 1; i <= steps; ++i) {
        const PlaneModel plane = strip.plane(std::min(1.0, static_cast<double>(i) / raising));
        ShellPartners partners;
        partners.planes = {&plane, 1};
        partners.layers = false;
        const double start = thread_cpu_seconds();
        shell.step(partners, {}, Vec3::Zero(), dt);
        outcome.step_s += (thread_cpu_seconds() - start) / steps;
        outcome.contacts += shell.contacts.touching() / static_cast<double>(steps);
        outcome.force = shell.contacts.force_of(ContactPartner::plane, 0).dot(plane.normal);
    }
    outcome.deepest = shell.contacts.deepest();
    return outcome;
}

Outcome by_warping(const scenes::LiftedStrip& strip, double gate) {
    const ShellModel model = strip.model();
    WarpedContact contact(model, dt, gate);
    ShellState state = rest_state(model);
    Outcome outcome;
    for (int i = 1; i <= steps; ++i) {
        const PlaneModel plane = strip.plane(std::min(1.0, static_cast<double>(i) / raising));
        const double start = thread_cpu_seconds();
        contact.step(plane, balanced, state);
        outcome.step_s += (thread_cpu_seconds() - start) / steps;
        outcome.contacts += contact.touching() / static_cast<double>(steps);
        outcome.gate_error = std::max(outcome.gate_error, contact.error());
    }
    outcome.force = contact.force();
    outcome.deepest = contact.deepest();
    outcome.factors = contact.factors();
    return outcome;
}

nlohmann::json row(const char* method, const scenes::LiftedStrip& strip, const Outcome& outcome) {
    return {{"name", "shell_contact_solvers"},
            {"method", method},
            {"lift_mm", strip.lift},
            {"us_per_contact", 1e6 * outcome.step_s / std::max(1.0, outcome.contacts)},
            {"us_per_step", 1e6 * outcome.step_s},
            {"contacts", outcome.contacts},
            {"deepest", outcome.deepest},
            {"gate_error", outcome.gate_error},
            {"factors", outcome.factors},
            {"error", std::abs(outcome.force / strip.force() - 1.0)},
            {"error_kind", "force of the plane against the elastica"}};
}

nlohmann::json rows_of(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    for (const auto& [lift, tilt] : {std::pair(0.1, 0.05), std::pair(1.0, 0.3), std::pair(3.0, 0.7)}) {
        scenes::LiftedStrip strip;
        strip.lift = lift;
        strip.tilt = tilt;
        for (const auto& [name, stiffer] :
             {std::pair("springs_quarter", 1.25), std::pair("springs", 5.0), std::pair("springs_four_times", 20.0)}) {
            rows.push_back(row(name, strip, best(options, [&] { return by_springs(strip, stiffer); })));
        }
        for (const auto& [name, gate] :
             {std::pair("warped", HUGE_VAL), std::pair("warped_gate", 0.3), std::pair("true_compliance", 0.0)}) {
            rows.push_back(row(name, strip, best(options, [&] { return by_warping(strip, gate); })));
        }
        if (options.quick) {
            break;
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> shell_contact_solver_cases() {
    return {{"shell_contact_solvers",
             "a lifted cantilever by springs of contact and by compliance warping, against the elastica", rows_of}};
}

}  // namespace rhexis::bench
