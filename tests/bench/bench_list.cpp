// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench.hpp"
#include "bench/bench_bulk.hpp"
#include "bench/bench_calculix.hpp"
#include "bench/bench_capsule_chart.hpp"
#include "bench/bench_capsule_pulls.hpp"
#include "bench/bench_chamber.hpp"
#include "bench/bench_explicit.hpp"
#include "bench/bench_factor_update.hpp"
#include "bench/bench_implicit.hpp"
#include "bench/bench_lens_chart.hpp"
#include "bench/bench_lens_press.hpp"
#include "bench/bench_membrane.hpp"
#include "bench/bench_memory.hpp"
#include "bench/bench_phaco.hpp"
#include "bench/bench_random_tears.hpp"
#include "bench/bench_render.hpp"
#include "bench/bench_rotation.hpp"
#include "bench/bench_run_out.hpp"
#include "bench/bench_shell.hpp"
#include "bench/bench_stability.hpp"
#include "bench/bench_tear.hpp"
#include "bench/chart.hpp"

namespace rhexis::bench {

std::vector<BenchCase> bench_cases() {
    std::vector<BenchCase> cases;
    const auto add = [&cases](const std::vector<BenchCase>& more) {
        cases.insert(cases.end(), more.begin(), more.end());
    };
    add(explicit_cases());
    add(implicit_cases());
    add(calculix_cases());
    add(bulk_cases());
    add(stability_cases());
    add(lens_chart_cases());
    add(lens_press_cases());
    add(membrane_cases());
    add(tear_cases());
    add(random_tears_cases());
    add(capsule_pulls_cases());
    add(capsule_chart_cases());
    add(run_out_cases());
    add(factor_update_cases());
    add(shell_speed_cases());
    add(shell_cases());
    add(shell_element_cases());
    add(implant_cases());
    add(implant_unfold_cases());
    add(shell_contact_cases());
    add(shell_contact_solver_cases());
    add(implant_inject_cases());
    add(implant_bag_cases());
    add(verify_cases());
    add(chamber_cases());
    add(phaco_cases());
    add(rotation_cases());
    add(render_cases());
    add(memory_cases());
    add(chart_cases());
    return cases;
}

}  // namespace rhexis::bench
