// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis track measure: what tracking reaches, against a rig that is not what it takes it to be.
#include <cstdio>

#include "track/commands.hpp"
#include "tracking/measure/figures.hpp"
#include "trial/progress.hpp"

namespace rhexis::tracking {

Status measure(const MeasureOptions& options) {
    MeasurePlan plan;
    plan.first_seed = options.first_seed;
    plan.seeds = options.seeds;
    plan.marker_seeds = options.marker_seeds;
    plan.image_s = options.image_s;
    plan.marker_s = options.marker_s;
    plan.identity_frames = options.identity_frames;
    plan.chart = options.chart;
    plan.keep = options.keep;
    Progress progress("measuring");
    const Result<TrackingFigures> figures = measure_tracking(
        plan, [&progress](double share, std::string_view what) { progress.show(share, std::string(what)); });
    progress.clear();
    if (!figures) {
        return figures.error();
    }
    std::printf("%s\n", (options.json ? figures_json(figures.value()) : figures_markdown(figures.value())).c_str());
    return success();
}

}  // namespace rhexis::tracking
