// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of shells: a pressed strip against beam theory by the stiffness and sampling of contact, and the foldable
// lens rolled up by a tube that narrows.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "bench/bench_shell.hpp"
#include "eye/implant.hpp"
#include "physics/shell/shell_energy.hpp"
#include "physics/shell/shell_motion.hpp"
#include "scenes/shell_contacts.hpp"

namespace rhexis::bench {
namespace {

/// A cantilever lifted at its end by a plane; error of the force.
nlohmann::json pressed_row(double stiffer, int level, bool turns) {
    ShellModel model = scenes::flat_strip(10.0, 1.0, 0.2, 40, 2);
    scenes::hold_line(model, 0.0);
    ShellContactSettings settings;
    settings.stiffer = stiffer;
    settings.level = level;
    settings.turns = turns;
    scenes::TouchingShell shell(model, settings);
    PlaneModel plane{Vec3::Zero(), Vec3(-0.05, 0.0, 1.0).normalized(), 0.0};
    ShellPartners partners;
    partners.planes = {&plane, 1};
    partners.layers = false;
    constexpr double lift = 0.1;
    double iterations = 0.0;
    constexpr int steps = 60;
    for (int i = 1; i <= steps; ++i) {
        plane.point = Vec3(10.0, 0.0, lift * std::min(1.0, i / 20.0)) - 0.1 * plane.normal;
        iterations += shell.step(partners, {}, Vec3::Zero(), 0.05).newton_iterations;
    }
    const double expected = 3.0 * model.material.young_modulus * 0.008 / 12.0 * lift / 1000.0;
    const double force = shell.contacts.force_of(ContactPartner::plane, 0).dot(plane.normal);
    std::vector<Vec3> points(2 * shell.state.position.size(), Vec3::Zero());
    for (std::size_t n = 0; n < shell.state.position.size(); ++n) {
        points[2 * n] = shell.state.position[n];
    }
    std::vector<ContactTerm> terms;
    shell.contacts.look(shell.state, partners);
    constexpr int repeats = 200;
    const double start = thread_cpu_seconds();
    for (int i = 0; i < repeats; ++i) {
        terms.clear();
        shell.contacts.terms(points, terms);
    }
    const double seconds = (thread_cpu_seconds() - start) / repeats;
    return {{"name", "shell_contact/pressed"},
            {"stiffer", stiffer},
            {"level", level},
            {"turns", turns},
            {"us_per_contact", 1e6 * seconds / std::max(1, shell.contacts.touching())},
            {"us", 1e6 * seconds},
            {"contacts", shell.contacts.touching()},
            {"deepest", shell.contacts.deepest()},
            {"newton_iterations", iterations / steps},
            {"error", std::abs(force / expected - 1.0)},
            {"error_kind", "force of the plane against a cantilever's"}};
}

/// How the lens is pressed.
struct Roll {
    double stiffer = ShellContactSettings{}.stiffer;  ///< as of ShellContactSettings
    double friction = 0.1;                            ///< of layers and wall
    double speed = 0.5;                               ///< of the wall [mm/s]
};

/// Share of a bore's section that the lens takes where it is thickest.
double filled(const ShellModel& model, double radius) {
    constexpr double half = 0.25;  // of the slice [mm]
    double volume = 0.0;
    for (int t = 0; t < static_cast<int>(model.mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = model.mesh.triangles[at(t)];
        if (std::abs(triangle_middle(model.mesh, t).y()) < half) {
            volume += model.thickness[at(t)] *
                      triangle_area(model.mesh.nodes[at(n[0])], model.mesh.nodes[at(n[1])], model.mesh.nodes[at(n[2])]);
        }
    }
    return volume / (2.0 * half) / (M_PI * radius * radius);
}

/// The tube's wall comes in; a row wherever its radius has passed one of some.
nlohmann::json rolled_rows(const BenchOptions& options, const Roll& roll) {
    ShellModel model = std::move(make_implant({})).value().model;
    model.relaxation = ShellRelaxation{};
    model.drag = disc_drag(1.0, 3.0);  // some viscoelastic [Pa s]
    model.friction = roll.friction;
    ShellStepper stepper = std::move(ShellStepper::create(model)).value();
    ShellContactSettings contact;
    contact.stiffer = roll.stiffer;
    ShellContacts contacts(model, contact);
    const ShellLedger ledger(model);
    ShellState state = rest_state(model);
    TubeModel tube;
    tube.friction = roll.friction;
    tube.pose.orientation = Quat(Eigen::AngleAxisd(-M_PI / 2.0, Vec3::UnitX()));  // its axis along the haptics
    tube.pose.position = Vec3(0.0, 0.0, 0.6);
    ShellPartners partners;
    partners.tubes = {&tube, 1};
    nlohmann::json rows = nlohmann::json::array();
    std::vector<double> marks{3.2, 3.0, 2.5, 2.0, 1.75, 1.5, 1.3, 1.1};
    constexpr double dt = 0.01;
    double seconds = 0.0;
    double deepest = 0.0;
    int steps = 0;
    int rollbacks = 0;
    int rough = 0;
    double iterations = 0.0;
    for (double radius = 4.5; radius > 1.1 && !marks.empty() && seconds < (options.quick ? 5.0 : 400.0);) {
        radius -= roll.speed * dt;
        tube.stations = {{100.0, radius, radius}};
        ShellStepReport report;
        ShellState next;
        const double start = thread_cpu_seconds();
        const ShellMotion motion =
            move_shell(stepper, contacts, {state, partners, Vec3::Zero(), dt}, next, report, rollbacks);
        seconds += thread_cpu_seconds() - start;
        iterations += report.newton_iterations;
        rough += motion == ShellMotion::balanced ? 0 : 1;
        deepest = std::max(deepest, contacts.deepest());
        state = next;
        ++steps;
        if (motion == ShellMotion::failed) {
            break;
        }
        if (radius <= marks.front()) {
            marks.erase(marks.begin());
            const ShellEnergy energy = ledger.energy(state);
            rows.push_back({{"name", "shell_contact/rolled"},
                            {"elements", model.mesh.triangles.size()},
                            {"stiffer", roll.stiffer},
                            {"friction", roll.friction},
                            {"wall_mm_s", roll.speed},
                            {"radius_mm", radius},
                            {"filled", filled(model, radius)},
                            {"now", contacts.deepest()},
                            {"touching", contacts.touching()},
                            {"stored_nJ", energy.all()},
                            {"steps", steps},
                            {"rollbacks", rollbacks},
                            {"rough", rough},
                            {"newton_iterations", iterations / steps},
                            {"cpu_ms_per_step", 1e3 * seconds / steps},
                            {"error", deepest},
                            {"error_kind", "deepest penetration so far over thickness"}});
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> shell_contact_cases() {
    return {{"shell_contact", "a strip pressed by a plane: stiffness and sampling of contact against beam theory",
             [](const BenchOptions& /*options*/) {
                 nlohmann::json rows = nlohmann::json::array();
                 for (const double stiffer : {0.1, 1.0, 10.0}) {
                     for (const int level : {0, 1, 2, 3}) {
                         rows.push_back(pressed_row(stiffer, level, true));
                     }
                 }
                 rows.push_back(pressed_row(1.0, 1, false));
                 return rows;
             }},
            {"implant_roll", "the foldable lens in a tube that narrows to a bore of 2.2 mm, with its layers",
             [](const BenchOptions& options) { return rolled_rows(options, {}); }},
            {"implant_roll_chart", "the same by stiffness of contact, friction and speed of the wall",
             [](const BenchOptions& options) {
                 nlohmann::json rows = nlohmann::json::array();
                 for (const Roll& roll : {Roll{}, Roll{5.0, 0.1, 0.5}, Roll{80.0, 0.1, 0.5}, Roll{20.0, 0.1, 0.1},
                                          Roll{20.0, 0.0, 0.5}, Roll{20.0, 0.3, 0.5}}) {
                     for (nlohmann::json& row : rolled_rows(options, roll)) {
                         rows.push_back(std::move(row));
                     }
                 }
                 return rows;
             }}};
}

}  // namespace rhexis::bench
