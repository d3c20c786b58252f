// SPDX-License-Identifier: GPL-3.0-or-later
// The foldable lens, held by the middle of its optic, its haptics bent over: steps a second by how far they bend. And
// its mesh, for a picture.
#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "bench/bench_shell.hpp"
#include "eye/implant.hpp"
#include "physics/shell/shell_statics.hpp"
#include "physics/shell/shell_stepper.hpp"
#include "scenes/shells.hpp"

namespace rhexis::bench {
namespace {

struct HeldImplant {
    Implant implant;
    ShellLoad load;
};

HeldImplant held_implant(int triangles, double force) {
    ImplantShape shape;
    shape.triangles = triangles;
    HeldImplant held{std::move(make_implant(shape)).value(), {}};
    ShellModel& model = held.implant.model;
    model.damping_mass = 0.1;
    model.damping_stiffness = 0.01;
    for (int node = 0; node < static_cast<int>(model.mesh.nodes.size()); ++node) {
        if (model.mesh.nodes[at(node)].norm() < 1.0) {
            model.holds.push_back({node, {true, true, true, true, true, true}});
        }
    }
    held.load.force.assign(model.mesh.nodes.size(), Vec3::Zero());
    for (const int tip : held.implant.tip) {
        held.load.force[at(tip)].z() = force;
    }
    return held;
}

nlohmann::json bent_row(double force, bool balanced, const BenchOptions& options) {
    const HeldImplant held = held_implant(743, force);
    const ShellModel& model = held.implant.model;
    ShellStepper stepper = std::move(ShellStepper::create(model)).value();
    ShellState state = rest_state(model);
    ImplicitSettings settings{.tolerance = 1e-9, .max_newton = 1};
    if (balanced) {
        settings = {.tolerance = 1e-3, .max_newton = 30, .newton_tolerance = 1e-6};
    }
    const int steps = options.quick ? 10 : 200;
    const double dt = 0.01;
    double seconds = 0.0;
    double iterations = 0.0;
    double linear = 0.0;
    double residual = 0.0;
    double turn = 0.0;
    for (int i = 1; i <= steps; ++i) {
        ShellLoad load = held.load;
        for (Vec3& f : load.force) {
            f *= scenes::moving_share(i * dt);
        }
        const double start = thread_cpu_seconds();
        const ImplicitReport report = stepper.step(state, load, Vec3::Zero(), dt, settings, state);
        seconds += thread_cpu_seconds() - start;
        iterations += report.newton_iterations;
        linear += report.linear_iterations;
        residual = std::max(residual, balanced ? report.newton_residual : report.residual);
        turn = std::max(turn, Quat::Identity().angularDistance(state.rotation[at(held.implant.tip[0])]));
    }
    return {{"name", balanced ? "implant/balanced" : "implant/one_solve"},
            {"elements", model.mesh.triangles.size()},
            {"nodes", model.mesh.nodes.size()},
            {"force_uN", force},
            {"largest_turn_deg", turn * 180.0 / M_PI},
            {"steps_per_second", steps / seconds},
            {"cpu_s_per_s", seconds / (steps * dt)},
            {"newton_iterations", iterations / steps},
            {"iterations", linear / steps},
            {"error", residual},
            {"error_kind", balanced ? "largest relative residual of a balanced step"
                                    : "largest relative residual of a step's solve"}};
}

/// The optic folded by ever greater forces on its sides, by the static solver.
nlohmann::json fold_rows(int triangles) {
    const scenes::FoldedOptic optic = scenes::folded_optic(triangles);
    ShellStatics statics = std::move(ShellStatics::create(optic.implant.model)).value();
    ShellState state = rest_state(optic.implant.model);
    nlohmann::json rows = nlohmann::json::array();
    double reached = 0.0;
    for (const double force : {1e4, 2e4, 3e4, 4e4, 8e4, 16e4}) {
        const double start = thread_cpu_seconds();
        const ShellStaticReport report = statics.load_to(optic.load, reached, force, {}, state);
        const double seconds = thread_cpu_seconds() - start;
        rows.push_back({{"name", "implant_fold"},
                        {"elements", optic.implant.model.mesh.triangles.size()},
                        {"force_mN", 1e-3 * force},
                        {"turn_deg", scenes::fold_degrees(optic, state)},
                        {"iterations", report.iterations},
                        {"cpu_s", seconds},
                        {"error", report.residual},
                        {"error_kind", "what does not balance, of all forces"}});
        if (!report.converged) {
            break;
        }
        reached = force;
    }
    return rows;
}

nlohmann::json mesh_row() {
    const Implant implant = std::move(make_implant({})).value();
    const TriMesh& mesh = implant.model.mesh;
    nlohmann::json corners = nlohmann::json::array();
    for (const std::array<int, 3>& t : mesh.triangles) {
        nlohmann::json one = nlohmann::json::array();
        for (const int node : t) {
            one.push_back({mesh.nodes[at(node)].x(), mesh.nodes[at(node)].y()});
        }
        corners.push_back(one);
    }
    return {{"name", "implant/mesh"},
            {"elements", mesh.triangles.size()},
            {"nodes", mesh.nodes.size()},
            {"area_mm2", mesh_area(mesh)},
            {"mass_g", shell_mass(implant.model)},
            {"smallest_angle_deg", smallest_angle(mesh) * 180.0 / M_PI},
            {"thickness", implant.model.thickness},
            {"triangles", corners}};
}

}  // namespace

std::vector<BenchCase> implant_cases() {
    return {{"implant", "10 ms steps of the foldable lens, its haptics bent over, one solve or balanced",
             [](const BenchOptions& options) {
                 nlohmann::json rows = nlohmann::json::array();
                 for (const double force : {20.0, 100.0, 400.0}) {
                     rows.push_back(bent_row(force, false, options));
                     rows.push_back(bent_row(force, true, options));
                 }
                 return rows;
             }},
            {"implant_fold", "the foldable lens held along a diameter, its sides pressed together: equilibria",
             [](const BenchOptions& options) {
                 nlohmann::json rows = fold_rows(743);
                 for (const nlohmann::json& row : options.quick ? nlohmann::json::array() : fold_rows(3000)) {
                     rows.push_back(row);
                 }
                 return rows;
             }},
            {"implant_mesh", "the foldable lens as triangles",
             [](const BenchOptions& /*options*/) { return nlohmann::json::array({mesh_row()}); }}};
}

}  // namespace rhexis::bench
