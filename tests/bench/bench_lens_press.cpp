// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_lens_press.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/lens_press.hpp"
#include "session/build_world.hpp"

namespace rhexis::bench {
namespace {

constexpr double finest = 2e-5;  ///< [s]

/// The patient's lens as exercises use it.
SolidModel lens_of(double grade, Advance advance) {
    SceneDescription scene;
    scene.patient.nuclear_grade = grade;
    scene.tissues = {"lens"};
    scene.advance = advance;
    return build_world(scene).value().world->solids[0];
}

scenes::LensPress press(const SolidModel& lens, double dt) {
    SolidModel held = scenes::lens_poke(3000).lens;
    held.advance = lens.advance;
    held.formulation = lens.formulation;
    held.materials = lens.materials;
    held.sought_step = lens.sought_step;
    return scenes::press_lens(std::move(held), dt);
}

/// Without mass scaling, in steps of 0.02 ms (implicit: 0.5 ms).
scenes::LensPress press_finely(SolidModel lens) {
    lens.sought_step = 0.0;
    return press(lens, lens.advance == Advance::explicit_ ? finest : 25.0 * finest);
}

nlohmann::json press_row(const std::string& name, const SolidModel& lens, bool quick) {
    const scenes::LensPress coarse = press(lens, 0.01);
    nlohmann::json row = {{"name", name},
                          {"cpu_s_per_s", coarse.cpu_s_per_s},
                          {"force_uN", coarse.force.back()},
                          {"dip_mm", coarse.dip.back()},
                          {"rollbacks", coarse.rollbacks}};
    if (!quick) {
        const scenes::LensPress fine = press_finely(lens);
        row["force_error"] = scenes::relative_difference(coarse.force, fine.force);
        row["dip_error"] = scenes::relative_difference(coarse.dip, fine.dip);
        row["error_kind"] = "rms over 0.4 s against steps of 0.02 ms (implicit: 0.5 ms) without mass scaling";
    }
    return row;
}

nlohmann::json run_press(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const auto add = [&](const std::string& name, double grade, Advance advance, Formulation formulation) {
        SolidModel lens = lens_of(grade, advance);
        lens.formulation = formulation;
        rows.push_back(press_row(name, lens, options.quick));
    };
    for (const double sought : {0.0, 2e-4, 3e-4, 4e-4, 5e-4, 6e-4, 8e-4}) {
        SolidModel lens = lens_of(3.0, Advance::explicit_);
        lens.sought_step = sought;
        const int microseconds = static_cast<int>(std::lround(1e6 * sought));
        rows.push_back(
            press_row(std::string("press/step sought ").append(std::to_string(microseconds)), lens, options.quick));
    }
    add("press/explicit linear", 3.0, Advance::explicit_, Formulation::linear);
    add("press/explicit nodal pressure", 3.0, Advance::explicit_, Formulation::nodal_pressure);
    add("press/implicit linear", 3.0, Advance::implicit, Formulation::linear);
    add("press/implicit edge-smoothed", 3.0, Advance::implicit, Formulation::edge_smoothed);
    add("press/NO6 explicit nodal pressure", 6.0, Advance::explicit_, Formulation::nodal_pressure);
    return rows;
}

nlohmann::json run_stroke(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    for (const double grade : {1.0, 3.0, 6.0}) {
        for (const Advance advance : {Advance::explicit_, Advance::implicit}) {
            if (options.quick && grade != 3.0) {
                continue;
            }
            const SolidModel lens = lens_of(grade, advance);
            double least = scenes::stroke_cost(lens, grade);
            for (int i = 1; i < std::min(options.repeats, 3); ++i) {
                least = std::min(least, scenes::stroke_cost(lens, grade));
            }
            rows.push_back({{"name", std::string("stroke/NO").append(std::to_string(static_cast<int>(grade))) +
                                         (advance == Advance::explicit_ ? "/explicit" : "/implicit")},
                            {"elements", lens.coarse.tets.size()},
                            {"cpu_s_per_s", least}});
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> lens_press_cases() {
    return {
        {"lens_press", "a ball pressed into the held lens: cost, and force and dip against steps to zero", run_press},
        {"lens_stroke", "the lens in its bag under a stroking phaco tip: cost of the physics alone", run_stroke}};
}

}  // namespace rhexis::bench
