// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/shell_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenes/shell_problems.hpp"

namespace rhexis::scenes {

ShellModel flat_strip(double length, double width, double thickness, int along, int across) {
    const auto map = [&](double s, double t) { return Vec3(length * s, width * t, 0.0); };
    ShellModel model = uniform_shell("strip", grid_mesh(along, across, GridCut::alternate, map), thickness);
    model.material.poisson_ratio = 0.0;
    return model;
}

ShellModel plates(const std::vector<Plate>& list) {
    ShellModel all = flat_strip(1.0, 1.0, 0.1, 1, 1);
    all.mesh = {};
    all.thickness.clear();
    for (const Plate& plate : list) {
        const ShellModel one = flat_strip(plate.size, plate.size, plate.thickness, plate.cuts, plate.cuts);
        const int first = static_cast<int>(all.mesh.nodes.size());
        for (const Vec3& node : one.mesh.nodes) {
            all.mesh.nodes.push_back(node + Vec3(-0.5 * plate.size, -0.5 * plate.size, plate.z));
        }
        for (const std::array<int, 3>& n : one.mesh.triangles) {
            all.mesh.triangles.push_back({n[0] + first, n[1] + first, n[2] + first});
            all.thickness.push_back(plate.thickness);
        }
    }
    return all;
}

void hold_line(ShellModel& model, double x) {
    for (int n = 0; n < static_cast<int>(model.mesh.nodes.size()); ++n) {
        if (std::abs(model.mesh.nodes[static_cast<std::size_t>(n)].x() - x) < 1e-9) {
            model.holds.push_back({n, {true, true, true, true, true, true}});
        }
    }
    std::sort(model.holds.begin(), model.holds.end(),
              [](const ShellHold& a, const ShellHold& b) { return a.node < b.node; });
}

ShellState rolled_strip(const ShellModel& model, double inner_radius, double pitch) {
    ShellState state = rest_state(model);
    const double growth = pitch / (2.0 * M_PI);  // of the radius, per angle
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        const Vec3& rest = model.mesh.nodes[n];
        double angle = 0.0;
        for (int i = 0; i < 20; ++i) {  // Newton on the length along the spiral, its slope left out
            const double length = inner_radius * angle + 0.5 * growth * angle * angle;
            angle += (rest.x() - length) / (inner_radius + growth * angle);
        }
        const double radius = inner_radius + growth * angle;
        state.position[n] = Vec3(radius * std::sin(angle), rest.y(), inner_radius - radius * std::cos(angle));
        state.rotation[n] = Quat(Eigen::AngleAxisd(-angle, Vec3::UnitY()));
    }
    return state;
}

ToolModel rod(double radius, double half_length) {
    ToolModel tool;
    tool.name = "rod";
    tool.parts = {{Vec3(0.0, -half_length, 0.0), Vec3(0.0, half_length, 0.0), radius, radius}};
    tool.friction = 0.0;
    return tool;
}

ToolModel forceps(double reach, double hold) {
    ToolModel tool;
    tool.name = "forceps";
    tool.kind = ToolKind::forceps;
    tool.lens_reach = reach;
    tool.hold = hold;
    return tool;
}

ToolState moving_tool(const Vec3& from, const Vec3& to) {
    ToolState state;
    state.present = true;
    state.previous_pose.position = from;
    state.pose.position = to;
    return state;
}

TouchingShell::TouchingShell(const ShellModel& model, const ShellContactSettings& contact)
    : state(rest_state(model)), contacts(model, contact), stepper(std::move(ShellStepper::create(model)).value()) {}

ImplicitReport TouchingShell::step(const ShellPartners& partners, const ShellLoad& load, const Vec3& gravity,
                                   double dt) {
    contacts.look(state, partners);
    return stepper.step(state, load, gravity, dt, settings, state, &contacts);
}

}  // namespace rhexis::scenes
