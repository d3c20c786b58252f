// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_energy.hpp"

#include "base/index.hpp"
#include "math/rotation.hpp"

namespace rhexis {
namespace {

Vec15 numbers_of(const std::vector<double>& all, std::size_t triangle) {
    return Eigen::Map<const Vec15>(all.data() + at(shell_deformation_length) * triangle);
}

}  // namespace

ShellLedger::ShellLedger(const ShellModel& model)
    : model_(&model),
      area_(model.mesh.nodes.size(), 0.0),
      mass_(model.mesh.nodes.size(), 0.0),
      inertia_(model.mesh.nodes.size(), 0.0) {
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        const std::array<int, 3>& n = model.mesh.triangles[t];
        const std::array<Vec3, 3> corner{model.mesh.nodes[at(n[0])], model.mesh.nodes[at(n[1])],
                                         model.mesh.nodes[at(n[2])]};
        const double h = model.thickness[t];
        triangle_.push_back(shell_triangle(corner, h, model.material.young_modulus, model.material.poisson_ratio));
        const double third = triangle_area(corner[0], corner[1], corner[2]) / 3.0;
        for (const int node : n) {
            area_[at(node)] += third;
            mass_[at(node)] += model.material.density * h * third;
            inertia_[at(node)] += model.material.density * h * third * h * h / 12.0;
        }
    }
}

std::vector<double> ShellLedger::deformation(const ShellState& state) const {
    std::vector<double> result(at(shell_deformation_length) * triangle_.size());
    for (std::size_t t = 0; t < triangle_.size(); ++t) {
        ShellCorners corners;
        for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t node = at(model_->mesh.triangles[t][a]);
            corners.position[a] = state.position[node];
            corners.rotation[a] = state.rotation[node].toRotationMatrix();
        }
        Eigen::Map<Vec15>(result.data() + at(shell_deformation_length) * t) = shell_deformation(triangle_[t], corners);
    }
    return result;
}

ShellEnergy ShellLedger::energy(const ShellState& state) const {
    ShellEnergy energy;
    for (std::size_t n = 0; n < mass_.size(); ++n) {
        energy.kinetic +=
            0.5 * (mass_[n] * state.velocity[n].squaredNorm() + inertia_[n] * state.spin[n].squaredNorm());
    }
    const std::vector<double> all = deformation(state);
    for (std::size_t t = 0; t < triangle_.size(); ++t) {
        const Vec15 d = numbers_of(all, t);
        energy.elastic += 0.5 * shell_product(triangle_[t], d, d);
        if (model_->relaxation) {
            const Vec15 h = numbers_of(state.branch, t);
            energy.branch += 0.5 * model_->relaxation->branch_share * shell_product(triangle_[t], h, h);
        }
    }
    return energy;
}

/// What the deformations would have changed by in a step had they gone on all along as they do at its end.
std::vector<double> ShellLedger::way_of_deformation(const ShellState& before, const ShellState& after,
                                                    double dt) const {
    const auto there = [&](double share) {
        ShellState state = before;
        for (std::size_t n = 0; n < state.position.size(); ++n) {
            state.position[n] += share * (after.position[n] - before.position[n]);
            state.rotation[n] = turned(before.rotation[n], share * dt * after.spin[n]);
        }
        return deformation(state);
    };
    constexpr double h = 1e-3;  // central differences of fourth order
    const std::vector<double> back2 = there(1.0 - 2.0 * h);
    const std::vector<double> back = there(1.0 - h);
    const std::vector<double> ahead = there(1.0 + h);
    const std::vector<double> ahead2 = there(1.0 + 2.0 * h);
    std::vector<double> rate(back.size());
    for (std::size_t i = 0; i < rate.size(); ++i) {
        rate[i] = (8.0 * (ahead[i] - back[i]) - (ahead2[i] - back2[i])) / (12.0 * h);
    }
    return rate;
}

/// What the dashpots take, and backward Euler from the springs: their force at the end along all of the step's way less
/// the work that they did. With s = d + share h the stress over the stiffness K at the end:
///   1/2 dd' K dd + share h' K dd - gain of the branch - dashpots + s' K (way - dd)
void ShellLedger::flow(const ShellState& before, const ShellState& after, double dt, ShellStepEnergy& result) const {
    const std::vector<double> from = deformation(before);
    const std::vector<double> to = deformation(after);
    const std::vector<double> ways = way_of_deformation(before, after, dt);
    const bool relaxes = model_->relaxation.has_value();
    const double share = relaxes ? model_->relaxation->branch_share : 0.0;
    const double time = relaxes ? relaxation_time(*model_->relaxation, model_->temperature) : 0.0;
    for (std::size_t t = 0; t < triangle_.size(); ++t) {
        const auto product = [&](const Vec15& a, const Vec15& b) { return shell_product(triangle_[t], a, b); };
        const Vec15 end = numbers_of(to, t);
        const Vec15 step = end - numbers_of(from, t);
        const Vec15 turned_on = numbers_of(ways, t) - step;
        result.integrator += 0.5 * product(step, step) + product(end, turned_on);
        if (relaxes) {
            const Vec15 h0 = numbers_of(before.branch, t);
            const Vec15 h1 = numbers_of(after.branch, t);
            const double gain = 0.5 * (product(h1, h1) - product(h0, h0));
            const double flown = time / dt * product(step, step - (h1 - h0)) - gain;
            result.viscosity += share * flown;
            result.integrator += share * (product(h1, step + turned_on) - gain - flown);
        }
    }
}

ShellStepEnergy ShellLedger::step(const ShellState& before, const ShellState& after, const ShellLoad& load,
                                  const Vec3& gravity, double dt, const ShellContactWork& contact,
                                  double stored_before) const {
    ShellStepEnergy result;
    result.external = contact.brought;
    result.contact = contact.stored - stored_before;
    result.friction = contact.friction;
    result.integrator = contact.lost;
    result.renewed = contact.found ? *contact.found - stored_before : 0.0;
    for (std::size_t n = 0; n < mass_.size(); ++n) {
        const Vec3 moved = after.position[n] - before.position[n];
        result.external += (1.0 - model_->fluid_density / model_->material.density) * mass_[n] * gravity.dot(moved);
        result.external += load.force.empty() ? 0.0 : load.force[n].dot(moved);
        result.external += load.moment.empty() ? 0.0 : dt * load.moment[n].dot(after.spin[n]);
        result.drag += model_->drag * area_[n] * moved.squaredNorm() / dt;
        result.damping += dt * model_->damping_mass *
                          (mass_[n] * after.velocity[n].squaredNorm() + inertia_[n] * after.spin[n].squaredNorm());
        result.integrator += 0.5 * (mass_[n] * (after.velocity[n] - before.velocity[n]).squaredNorm() +
                                    inertia_[n] * (after.spin[n] - before.spin[n]).squaredNorm());
    }
    flow(before, after, dt, result);
    result.gain = energy(after).all() - energy(before).all();
    result.rest = result.external + result.renewed - result.gain - result.contact - result.friction - result.viscosity -
                  result.drag - result.damping - result.integrator;
    return result;
}

}  // namespace rhexis
