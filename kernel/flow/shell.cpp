// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/shell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "base/index.hpp"
#include "base/numbers.hpp"
#include "base/ranges.hpp"
#include "math/decay.hpp"

namespace rhexis {
namespace {

Status check_thickness(const ShellModel& model) {
    if (model.thickness.size() != model.mesh.triangles.size()) {
        return Error{std::string("thickness has ").append(std::to_string(model.thickness.size())).append(" entries"),
                     model.name, std::string("one per triangle: ").append(std::to_string(model.mesh.triangles.size()))};
    }
    for (std::size_t t = 0; t < model.thickness.size(); ++t) {
        const std::string field = std::string("thickness of triangle ").append(std::to_string(t));
        if (Status s = check_range(field, model.thickness[t], 1e-4, 100.0, model.name, " mm"); !s) {
            return s;
        }
    }
    return success();
}

Status check_numbers(const ShellModel& model) {
    return check_ranges({{"young_modulus", model.material.young_modulus, 1.0, 1e12, " Pa"},
                         {"poisson_ratio", model.material.poisson_ratio, 0.0, 0.499, ""},
                         {"density", model.material.density, 1e-7, 1.0, " g/mm^3"},
                         {"damping_mass", model.damping_mass, 0.0, 1e8, " 1/s"},
                         {"damping_stiffness", model.damping_stiffness, 0.0, 10.0, " s"},
                         {"temperature", model.temperature, -50.0, 150.0, " C"},
                         {"fluid_density", model.fluid_density, 0.0, 1.0, " g/mm^3"},
                         {"drag", model.drag, 0.0, 1e3, " g/(s mm^2)"},
                         {"friction", model.friction, 0.0, 10.0, ""},
                         {"tack", model.tack, 0.0, 1e6, " Pa"},
                         {"tack_range", model.tack_range, 1e-4, 0.1, " mm"}},
                        model.name);
}

Status check_relaxation(const ShellModel& model) {
    if (!model.relaxation) {
        return success();
    }
    const ShellRelaxation& r = *model.relaxation;
    return check_ranges({{"relaxation.branch_share", r.branch_share, 0.0, 1e4, ""},
                         {"relaxation.time", r.time, 1e-6, 1e6, " s"},
                         {"relaxation.reference_temperature", r.reference_temperature, -50.0, 150.0, " C"},
                         {"relaxation.activation_energy", r.activation_energy, 0.0, 1e6, " J/mol"}},
                        model.name);
}

Status check_holds(const ShellModel& model) {
    const int nodes = static_cast<int>(model.mesh.nodes.size());
    int last = -1;
    for (const ShellHold& hold : model.holds) {
        if (hold.node < 0 || hold.node >= nodes) {
            return Error{std::string("holds names node ").append(std::to_string(hold.node)), model.name,
                         std::string("0 to ").append(std::to_string(nodes - 1))};
        }
        if (hold.node <= last) {
            return Error{std::string("holds names node ").append(std::to_string(hold.node)).append(" after node ") +
                             std::to_string(last),
                         model.name, "ascending nodes, each once"};
        }
        last = hold.node;
    }
    return success();
}

std::size_t branch_length(const ShellModel& model) {
    return model.relaxation ? at(shell_deformation_length) * model.mesh.triangles.size() : 0;
}

bool pulls_fit(const std::vector<ShellPull>& loads, int nodes) {
    return std::all_of(loads.begin(), loads.end(), [&](const ShellPull& load) {
        return !load.nodes.empty() && load.total.allFinite() &&
               std::all_of(load.nodes.begin(), load.nodes.end(), [&](int n) { return n >= 0 && n < nodes; });
    });
}

}  // namespace

ShellModel uniform_shell(std::string name, TriMesh mesh, double thickness) {
    ShellModel model;
    model.name = std::move(name);
    model.thickness.assign(mesh.triangles.size(), thickness);
    model.mesh = std::move(mesh);
    return model;
}

Status check_shell(const ShellModel& model) {
    for (const auto& check : {+[](const ShellModel& m) { return validate_tri_mesh(m.mesh, m.name); }, check_thickness,
                              check_numbers, check_relaxation, check_holds}) {
        if (Status status = check(model); !status) {
            return status;
        }
    }
    return success();
}

Status check_shell_state(const ShellModel& model, const ShellState& state) {
    const std::size_t nodes = model.mesh.nodes.size();
    if (state.position.size() != nodes || state.rotation.size() != nodes || state.velocity.size() != nodes ||
        state.spin.size() != nodes) {
        return Error{"the state's lists differ in length from the mesh", model.name,
                     std::string("one entry per node: ").append(std::to_string(nodes))};
    }
    const std::size_t branch = branch_length(model);
    if (state.branch.size() != branch ||
        !std::all_of(state.branch.begin(), state.branch.end(), [](double value) { return std::isfinite(value); })) {
        return Error{std::string("the state's branch has ").append(std::to_string(state.branch.size())), model.name,
                     std::string("finite numbers: ").append(std::to_string(branch))};
    }
    if (!pulls_fit(state.loads, static_cast<int>(nodes))) {
        return Error{"a load on the shell is none", model.name,
                     std::string("a finite force on nodes from 0 to ").append(std::to_string(nodes - 1))};
    }
    for (const ShellTouch& touch : state.touches) {
        if (touch.index < 0 || touch.sample < 0 || !touch.stretch.allFinite()) {
            return Error{"a contact of the shell is none", model.name, "indices from 0 and a finite stretch"};
        }
    }
    for (std::size_t n = 0; n < nodes; ++n) {
        if (!state.position[n].allFinite() || !state.velocity[n].allFinite() || !state.spin[n].allFinite() ||
            !(std::abs(state.rotation[n].norm() - 1.0) < 1e-9)) {
            return Error{std::string("the state of node ").append(std::to_string(n)).append(" is no state"), model.name,
                         "finite numbers and a unit rotation"};
        }
    }
    return success();
}

ShellState rest_state(const ShellModel& model) {
    const std::size_t nodes = model.mesh.nodes.size();
    ShellState state;
    state.position = model.mesh.nodes;
    state.rotation.assign(nodes, Quat::Identity());
    state.velocity.assign(nodes, Vec3::Zero());
    state.spin.assign(nodes, Vec3::Zero());
    state.branch.assign(branch_length(model), 0.0);
    return state;
}

ShellState moved(ShellState state, const Pose& by) {
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        state.position[n] = by.to_world(state.position[n]);
        state.rotation[n] = (by.orientation * state.rotation[n]).normalized();
        state.velocity[n] = by.orientation * state.velocity[n];
        state.spin[n] = by.orientation * state.spin[n];
    }
    for (ShellPull& load : state.loads) {
        load.total = by.orientation * load.total;
    }
    for (ShellTouch& touch : state.touches) {
        if (touch.partner != ContactPartner::tool && touch.partner != ContactPartner::tube &&
            touch.partner != ContactPartner::jaws) {
            touch.stretch = by.orientation * touch.stretch;
        }
    }
    return state;
}

void stop(ShellState& state) {
    std::fill(state.velocity.begin(), state.velocity.end(), Vec3(Vec3::Zero()));
    std::fill(state.spin.begin(), state.spin.end(), Vec3(Vec3::Zero()));
}

double relaxation_time(const ShellRelaxation& relaxation, double temperature) {
    constexpr double zero_celsius = 273.15;   // [K]
    constexpr double gas_constant = 8.31446;  // [J/(mol K)]
    const double slower =
        relaxation.activation_energy / gas_constant *
        (1.0 / (temperature + zero_celsius) - 1.0 / (relaxation.reference_temperature + zero_celsius));
    const double share = decay(std::abs(slower)).left;
    return slower > 0.0 ? relaxation.time / share : relaxation.time * share;
}

double disc_drag(double viscosity, double radius) { return 16.0 * viscosity / (std::numbers::pi * radius); }

double shell_mass(const ShellModel& model) {
    double mass = 0.0;
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        const std::array<int, 3>& n = model.mesh.triangles[t];
        mass += model.material.density * model.thickness[t] *
                triangle_area(model.mesh.nodes[at(n[0])], model.mesh.nodes[at(n[1])], model.mesh.nodes[at(n[2])]);
    }
    return mass;
}

}  // namespace rhexis
