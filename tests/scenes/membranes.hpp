// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets for tests, benchmarks and demos, and what is pulled at in them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/membrane.hpp"
#include "physics/membrane/membrane_stepper.hpp"

namespace rhexis::scenes {

/// A sheet of 0.01 mm, E 1 MPa, without damping.
MembraneModel membrane(const std::string& name, TriMesh mesh, const Orthotropic& material,
                       const Vec3& fibre = Vec3::UnitX());

/// Nodes with x[axis] within 1e-9 mm of a value, ascending.
std::vector<int> nodes_at(const TriMesh& mesh, int axis, double value);

/// These nodes and those are moved by hand only.
void hold(MembraneModel& model, const std::vector<int>& some, const std::vector<int>& others);

/// The square of 1,516 triangles that other programs were timed with: held at its left edge, pulled at its right one.
struct PulledSheet {
    MembraneModel model;
    std::vector<int> pulled;
    Vec3 load = Vec3(1e4, 0.0, 0.0);  ///< in all [uN]
    double step_s = 0.01;
    int warm_up_steps = 100;
    int measured_steps = 400;
};
Result<PulledSheet> pulled_sheet(bool fibrous, const std::string& folder = ".");

/// Force per node at a time: the load swells and fades every half second.
std::vector<Vec3> moving_load(const PulledSheet& sheet, double time_s);

/// A sheet with nodes that are moved by hand, brought to rest.
class HeldSheet {
public:
    /// The model's fixed nodes can be moved.
    explicit HeldSheet(MembraneModel model);
    HeldSheet(const HeldSheet&) = delete;
    HeldSheet& operator=(const HeldSheet&) = delete;

    MembraneState& state() { return state_; }
    [[nodiscard]] const MembraneModel& model() const { return model_; }

    /// Steps of `dt` [s] until no node moves faster than `speed` [mm/s], or `most` steps; false then. external: per
    /// node.
    bool settle(std::span<const Vec3> external = {}, double speed = 1e-3, int most = 200, double dt = 0.01);
    /// One step.
    ImplicitReport step(double dt, std::span<const Vec3> external = {}, const ImplicitSettings& settings = {});

    [[nodiscard]] double energy() const { return elastic_energy(model_, state_); }
    /// Elastic force on the sheet summed over nodes: what holds them there gives the opposite [uN].
    [[nodiscard]] Vec3 force_on(const std::vector<int>& nodes) const { return elastic_force(model_, state_, nodes); }

private:
    MembraneModel model_;
    MembraneStepper stepper_;
    MembraneState state_;
    MembraneState next_;
};

}  // namespace rhexis::scenes
