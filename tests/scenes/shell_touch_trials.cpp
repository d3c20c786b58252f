// SPDX-License-Identifier: GPL-3.0-or-later
// Shells between jaws, under weights, on planes.
#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes/lifted_strip.hpp"
#include "scenes/shell_account.hpp"
#include "scenes/shell_trials.hpp"

namespace rhexis::scenes {
namespace {

const Vec3 earth(0.0, 0.0, -9810.0);  // [mm/s^2]

ShellContactSettings with_accounts() {
    ShellContactSettings settings;
    settings.accounts = true;
    return settings;
}

/// Mean and, from step to step, rms change of a series over its mean.
double jitter_of(const std::vector<double>& force) {
    double mean = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        mean += force[i] / static_cast<double>(force.size());
        square += i > 0 ? (force[i] - force[i - 1]) * (force[i] - force[i - 1]) : 0.0;
    }
    return std::sqrt(square / static_cast<double>(force.size() - 1)) / std::abs(mean);
}

std::vector<Plate> plates_of(bool heavy) {
    if (heavy) {
        return {{1.0, 0.1, 4, 0.06}, {10.0, 1.0, 10, 0.62}};
    }
    std::vector<Plate> list;
    for (int i = 0; i < 5; ++i) {
        list.push_back({2.0, 0.2, 4, 0.11 + 0.21 * i});
    }
    return list;
}

}  // namespace

Squeeze squeeze_strip() {
    ShellModel model = flat_strip(3.0, 1.0, 0.2, 12, 4);
    hold_line(model, 0.0);
    model.damping_mass = 20.0;
    TouchingShell shell(model, with_accounts());
    shell.settings.most_travel = 0.1;
    const ToolModel jaws[2] = {rod(0.2, 1.0), rod(0.2, 1.0)};
    const auto half_gap = [](int i) { return 0.31 - 0.001 * std::min(i, 15); };
    ShellAccount account(model);
    Squeeze found;
    std::vector<double> force;
    double excess = 0.0;
    for (int i = 1; i <= 60; ++i) {
        const Vec3 up(0.0, 0.0, half_gap(i));
        const Vec3 before(0.0, 0.0, half_gap(i - 1));
        const Vec3 place(2.0, 0.5, 0.0);
        const ToolState now[2] = {moving_tool(place + before, place + up), moving_tool(place - before, place - up)};
        ShellPartners partners;
        partners.tools = jaws;
        partners.tool_states = now;
        account.step(shell, partners, {}, Vec3::Zero(), 1e-3);
        found.deepest = std::max(found.deepest, shell.contacts.deepest());
        excess = std::max(excess, account.sum.gain + account.sum.contact - account.sum.external);
        if (i > 30) {
            force.push_back(shell.contacts.force_of(ContactPartner::tool, 1).z());
            found.uneven = std::max(
                found.uneven, std::abs(1.0 + shell.contacts.force_of(ContactPartner::tool, 0).z() / force.back()));
        }
    }
    found.jitter = jitter_of(force);
    found.gain = std::max(0.0, excess) / account.brought;
    found.failures = account.unbalanced;
    return found;
}

Stack stack_plates(bool heavy) {
    ShellModel model = plates(plates_of(heavy));
    model.damping_mass = 1.0;
    TouchingShell shell(model, with_accounts());
    shell.settings = {.tolerance = 1e-4, .max_newton = 100, .newton_tolerance = 1e-8, .most_travel = 0.05};
    const PlaneModel ground{Vec3::Zero(), Vec3::UnitZ(), 0.3};
    ShellPartners partners;
    partners.planes = {&ground, 1};
    ShellAccount account(model);
    Stack found;
    ShellState middle;
    for (int i = 0; i < 200; ++i) {
        const ShellStepEnergy e = account.step(shell, partners, {}, earth, 1e-3);
        found.deepest = std::max(found.deepest, shell.contacts.deepest());
        found.gain = std::max(found.gain, (e.gain + e.contact - e.external - std::abs(e.renewed)) / account.brought);
        middle = i == 99 ? shell.state : middle;
    }
    for (std::size_t n = 0; n < middle.position.size(); ++n) {
        found.drift = std::max(found.drift, (shell.state.position[n] - middle.position[n]).norm() / 0.1);
    }
    found.borne = shell.contacts.force_of(ContactPartner::plane, 0).z() / (-earth.z() * shell_mass(model));
    found.unbalanced = account.unbalanced;
    return found;
}

LiftedForce lift_strip(double lift, double tilt) {
    constexpr int raising = 20;  // steps
    LiftedStrip strip;
    strip.lift = lift;
    strip.tilt = tilt;
    const ShellModel model = strip.model();
    TouchingShell shell(model);
    LiftedForce found;
    double force = 0.0;
    for (int i = 1; i <= 60; ++i) {
        const PlaneModel plane = strip.plane(std::min(1.0, static_cast<double>(i) / raising));
        ShellPartners partners;
        partners.planes = {&plane, 1};
        partners.layers = false;
        found.unbalanced += shell.step(partners, {}, Vec3::Zero(), 0.05).converged ? 0 : 1;
        found.deepest = std::max(found.deepest, shell.contacts.deepest());
        force = shell.contacts.force_of(ContactPartner::plane, 0).dot(plane.normal);
    }
    found.error = std::abs(force / strip.force() - 1.0);
    return found;
}

}  // namespace rhexis::scenes
