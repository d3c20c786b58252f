// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/membranes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"
#include "mesh/io.hpp"
#include "scenes/bodies.hpp"

namespace rhexis::scenes {
namespace {

double fastest(const MembraneState& state) {
    double speed = 0.0;
    for (const Vec3& v : state.velocity) {
        speed = std::max(speed, v.norm());
    }
    return speed;
}

}  // namespace

MembraneModel membrane(const std::string& name, TriMesh mesh, const Orthotropic& material, const Vec3& fibre) {
    MembraneModel model;
    model.name = name;
    model.sheet = std::make_shared<const MembraneSheet>(uniform_sheet(std::move(mesh), fibre, 0.01));
    model.buoyancy_density = model.density;  // weight is no part of these
    model.material = material;
    return model;
}

std::vector<int> nodes_at(const TriMesh& mesh, int axis, double value) {
    std::vector<int> nodes;
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
        if (std::abs(mesh.nodes[at(n)][axis] - value) < 1e-9) {
            nodes.push_back(n);
        }
    }
    return nodes;
}

void hold(MembraneModel& model, const std::vector<int>& some, const std::vector<int>& others) {
    model.fixed_nodes = some;
    model.fixed_nodes.insert(model.fixed_nodes.end(), others.begin(), others.end());
    std::sort(model.fixed_nodes.begin(), model.fixed_nodes.end());
}

Result<PulledSheet> pulled_sheet(bool fibrous, const std::string& folder) {
    const std::string base = folder + "/tests/data/meshes/capsule_1500";
    Result<TriMesh> mesh = read_tri_mesh(base + ".vtk");
    if (!mesh.ok()) {
        return mesh.error();
    }
    PulledSheet sheet;
    sheet.model.name = "capsule_1500";
    sheet.model.material = fibrous ? Orthotropic{1e6, 1e6 / 3.0, 0.45, 0.0} : isotropic(1e6, 0.45);
    sheet.model.density = 1.05e-3;
    sheet.model.damping_mass = 0.1;
    sheet.model.damping_stiffness = 0.01;
    const Result<std::vector<int>> left = read_nodes(base + ".left.txt", mesh.value().nodes.size());
    const Result<std::vector<int>> right = read_nodes(base + ".right.txt", mesh.value().nodes.size());
    if (!left.ok() || !right.ok()) {
        return left.ok() ? right.error() : left.error();
    }
    sheet.model.fixed_nodes = left.value();
    sheet.pulled = right.value();
    sheet.model.sheet =
        std::make_shared<const MembraneSheet>(uniform_sheet(std::move(mesh).value(), Vec3(1.0, 1.0, 0.0), 0.015));
    return sheet;
}

std::vector<Vec3> moving_load(const PulledSheet& sheet, double time_s) {
    std::vector<Vec3> load(sheet.model.sheet->mesh.nodes.size(), Vec3::Zero());
    const double share = (0.5 - 0.5 * std::cos(2.0 * M_PI * time_s / 0.5)) / static_cast<double>(sheet.pulled.size());
    for (const int node : sheet.pulled) {
        load[at(node)] = share * sheet.load;
    }
    return load;
}

HeldSheet::HeldSheet(MembraneModel model)
    : model_(std::move(model)),
      stepper_(std::move(MembraneStepper::create(model_)).value()),
      state_(rest_state(model_)) {}

ImplicitReport HeldSheet::step(double dt, std::span<const Vec3> external, const ImplicitSettings& settings) {
    const ImplicitReport report = stepper_.step(state_, external, dt, settings, {}, next_);
    std::swap(state_, next_);
    return report;
}

bool HeldSheet::settle(std::span<const Vec3> external, double speed, int most, double dt) {
    ImplicitSettings settings;
    settings.max_newton = 20;
    settings.newton_tolerance = 1e-8;
    for (int i = 0; i < most; ++i) {
        step(dt, external, settings);
        if (fastest(state_) < speed) {
            return true;
        }
    }
    return false;
}

}  // namespace rhexis::scenes
