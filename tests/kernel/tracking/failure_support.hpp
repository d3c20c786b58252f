// SPDX-License-Identifier: GPL-3.0-or-later
// The synthetic rig with a solver's rig that was calibrated as a real one is, for tests of what goes wrong.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>

#include "tracking/measure/calibrated_rig.hpp"
#include "tracking/measure/tip_errors.hpp"
#include "tracking/sources/synthetic_source.hpp"
#include "tracking/synthetic/bodies.hpp"

namespace rhexis::tracking::testing {

struct Workplace {
    synthetic::SyntheticRig rig{};
    Rig solver{};
    std::vector<MarkerBody> bodies = synthetic::standard_bodies();
};

/// Calibrated once for all tests.
inline const Workplace& workplace() {
    static const Workplace place = [] {
        Workplace made;
        made.rig = synthetic::SyntheticRig::create(3).value();
        CalibrationPlan plan;
        plan.seed = 3;
        plan.boards = 18;
        plan.wand_frames = 300;
        const Result<SyntheticCalibration> calibration = calibrate_synthetic(made.rig, plan);
        REQUIRE_MESSAGE(calibration.ok(), (calibration ? "" : calibration.error().text()));
        made.solver = calibration.value().rig;
        return made;
    }();
    return place;
}

inline synthetic::Clip clip_named(const char* name, std::uint64_t seed = 3) {
    return synthetic::make_clip(name, seed, workplace().bodies, workplace().rig.nominal).value();
}

inline ClipPlan marker_plan(double longest_s) {
    ClipPlan plan;
    plan.seed = 3;
    plan.images = false;
    plan.longest_s = longest_s;
    return plan;
}

inline ClipRun run_of(const synthetic::Clip& clip, const ClipPlan& plan) {
    Result<ClipRun> run = track_clip(workplace().rig, workplace().solver, clip, plan);
    REQUIRE_MESSAGE(run.ok(), (run ? "" : run.error().text()));
    return std::move(run).value();
}

/// The worst of the instruments' figures.
struct Worst {
    double of_95_mm = 0.0;
    double worst_mm = 0.0;
    std::int64_t missing = 0;  ///< exposures in which one was not seen
};
inline Worst worst_of(const ClipRun& run) {
    Worst worst;
    for (std::size_t i = 1; i < run.traces.size(); ++i) {
        const ErrorFigures figures = tip_errors(run.traces[i]);
        worst.of_95_mm = std::max(worst.of_95_mm, figures.of_95);
        worst.worst_mm = std::max(worst.worst_mm, figures.worst);
        worst.missing += figures.frames - figures.valid;
    }
    return worst;
}

}  // namespace rhexis::tracking::testing
