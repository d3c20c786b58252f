// SPDX-License-Identifier: GPL-3.0-or-later
// A folded implant pushed out of its cartridge, by friction, nozzle, modulus and speed of the plunger.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "bench/bench_shell.hpp"
#include "eye/implant.hpp"
#include "scenes/injection.hpp"
#include "session/build_world.hpp"
#include "session/implant_fold.hpp"

namespace rhexis::bench {
namespace {

constexpr double dt = 0.02;
constexpr double viscosity = 10.0;  // of viscoelastic that is sheared some ten times a second [Pa s]
constexpr double unfolding = 2.0;   // looked at after the hand has come to the end of the stroke [s]
constexpr double jam = 0.9;         // of what a hand can, at which it counts as jammed
constexpr int wedge = 10;           // steps out of balance, from which it counts as wedged and is given up

struct Push {
    double nozzle = 2.6;    ///< [mm]
    double friction = 0.1;  ///< of wall and layers
    double modulus = 1.0;   ///< [MPa]
    double speed = 5.0;     ///< of the plunger [mm/s]
    bool thin = false;      ///< a lens of 0.35 mm instead of 0.7
    double triangles = 400.0;
};

std::map<std::string, double> settings_of(const Push& push) {
    std::map<std::string, double> settings{{"implant.triangles", push.triangles}};
    settings["cartridge.bore_mm"] = push.thin ? 2.2 : 2.8;
    settings["cartridge.nozzle_mm"] = std::min(push.nozzle, settings["cartridge.bore_mm"]);
    settings["cartridge.friction"] = push.friction;
    if (push.thin) {
        settings["implant.centre_mm"] = 0.35;
        settings["implant.edge_mm"] = 0.15;
        settings["implant.haptic_mm"] = 0.2;
    }
    return settings;
}

/// Folded once for all pushes, without regard to nozzle, friction and modulus.
const ShellState& folded(const Push& push) {
    static std::map<std::pair<bool, double>, ShellState> known;
    const std::pair key(push.thin, push.triangles);
    const auto found = known.find(key);
    if (found != known.end()) {
        return found->second;
    }
    Push plain;
    plain.thin = push.thin;
    plain.triangles = push.triangles;
    plain.nozzle = 4.0;
    ImplantFold fold = std::move(ImplantFold::create(folding_scene(settings_of(plain)))).value();
    while (!fold.done() && fold.step()) {
    }
    return known[key] = std::move(fold.result()).value().snapshot.world.shells[0];
}

double beyond_tip(const std::vector<Vec3>& places) {
    const auto out = std::count_if(places.begin(), places.end(), [](const Vec3& p) { return p.z() < 0.0; });
    return static_cast<double>(out) / static_cast<double>(places.size());
}

struct Pushed {
    double share = 0.0;     ///< of the plunger's stroke where it is at the end
    double force = 0.0;     ///< most on the plunger [uN]
    double deepest = 0.0;   ///< over thickness
    double residual = 0.0;  ///< largest, over the forces of contact
    int rough = 0;          ///< steps that did not balance; at the last of `wedge` it is given up
    int steps = 0;
    int tries = 0;  ///< of steps, with those that the plunger made again
    double cpu_s = 0.0;
    std::vector<double> iterations;
    bool jammed = false;
    double delivered = 0.0;  ///< share of the nodes beyond the tip
    double wide = 0.0;       ///< of the lens at the end, across the bore [mm]
};

Pushed inject(const Push& push) {
    const std::map<std::string, double> settings = settings_of(push);
    ShellModel model = free_implant(implant_shape(all_settings(folding_scene(settings))));
    model.material.young_modulus = 1e6 * push.modulus;
    model.friction = push.friction;
    model.drag = disc_drag(viscosity, 3.0);
    const ToolModel tool = injector(injector_shape(all_settings(folding_scene(settings))));
    scenes::Injection injection(model, tool, folded(push));
    Pushed result;
    const int pushing = static_cast<int>(tool.cartridge->stroke / push.speed / dt) + 1;
    const int planned = pushing + static_cast<int>(unfolding / dt);
    while (result.steps < planned && result.rough < wedge) {
        ++result.steps;
        const double start = thread_cpu_seconds();
        const ShellMotion motion = injection.step(std::min(1.0, static_cast<double>(result.steps) / pushing), dt);
        result.cpu_s += thread_cpu_seconds() - start;
        result.residual = std::max(result.residual, injection.report.residual);
        result.rough += motion == ShellMotion::balanced ? 0 : 1;
        result.iterations.push_back(injection.report.newton_iterations);
        result.deepest = std::max(result.deepest, injection.contacts.deepest());
        result.force = std::max(result.force, injection.plunger.force);
        result.jammed = result.jammed || injection.plunger.force > jam * tool.cartridge->most_force;
    }
    result.tries = injection.tries;
    result.share = injection.plunger.pushed / tool.cartridge->stroke;
    result.delivered = beyond_tip(injection.state.position);
    for (const Vec3& place : injection.state.position) {
        result.wide = std::max(result.wide, 2.0 * std::sqrt(place.x() * place.x() + place.y() * place.y()));
    }
    return result;
}

nlohmann::json row(const Push& push) {
    Pushed pushed = inject(push);
    std::sort(pushed.iterations.begin(), pushed.iterations.end());
    const auto rank = [&](double share) {
        return pushed.iterations[static_cast<std::size_t>(share * static_cast<double>(pushed.iterations.size() - 1))];
    };
    return {{"name", "implant_inject"},
            {"nozzle_mm", push.nozzle},
            {"friction", push.friction},
            {"modulus_mpa", push.modulus},
            {"speed_mm_s", push.speed},
            {"thin", push.thin},
            {"outcome", pushed.jammed             ? "jammed"
                        : pushed.rough >= wedge   ? "wedged"
                        : pushed.delivered > 0.99 ? "delivered"
                                                  : "held back"},
            {"stroke", pushed.share},
            {"delivered", pushed.delivered},
            {"force_mN", 1e-3 * pushed.force},
            {"wide_mm", pushed.wide},
            {"residual", pushed.residual},
            {"elements", push.triangles},
            {"rough", pushed.rough},
            {"steps", pushed.steps},
            {"tries", pushed.tries},
            {"iterations", std::accumulate(pushed.iterations.begin(), pushed.iterations.end(), 0.0)},
            {"iterations_p50", rank(0.5)},
            {"iterations_p99", rank(0.99)},
            {"cpu_s_per_s", pushed.cpu_s / (pushed.steps * dt)},
            {"error", pushed.deepest},
            {"error_kind", "deepest penetration over thickness"}};
}

}  // namespace

std::vector<BenchCase> implant_inject_cases() {
    const auto named = [](const char* name, const char* by, std::vector<Push> pushes) {
        return BenchCase{name, std::string("a folded implant pushed out of its cartridge, by ").append(by),
                         [pushes = std::move(pushes)](const BenchOptions& options) {
                             nlohmann::json rows = nlohmann::json::array();
                             for (std::size_t i = 0; i < (options.quick ? 1 : pushes.size()); ++i) {
                                 options.progress(static_cast<double>(i) / static_cast<double>(pushes.size()));
                                 rows.push_back(row(pushes[i]));
                             }
                             return rows;
                         }};
    };
    return {named("implant_inject", "nozzle",
                  {{.nozzle = 2.8, .triangles = 743.0},
                   {.triangles = 743.0},
                   {.nozzle = 2.4, .triangles = 743.0},
                   {.nozzle = 2.2, .triangles = 743.0}}),
            named("implant_inject_friction", "friction", {{.friction = 0.0}, {}, {.friction = 0.3}, {.friction = 0.6}}),
            named("implant_inject_modulus", "modulus", {{.modulus = 0.5}, {}, {.modulus = 3.0}}),
            named("implant_inject_speed", "speed of the plunger", {{.speed = 20.0}, {}, {.speed = 1.0}}),
            named("implant_inject_thin", "nozzle, with a thin lens",
                  {{.nozzle = 2.2, .thin = true},
                   {.nozzle = 2.0, .thin = true},
                   {.nozzle = 1.8, .thin = true},
                   {.nozzle = 1.6, .thin = true},
                   {.nozzle = 1.4, .thin = true}})};
}

}  // namespace rhexis::bench
