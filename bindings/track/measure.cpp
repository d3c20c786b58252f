// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis track measure: what tracking reaches, against a rig that is not what it takes it to be.
#include <cstdio>

#include "track/commands.hpp"
#include "track/hop.hpp"
#include "tracking/measure/detector_chart.hpp"
#include "tracking/measure/figures.hpp"
#include "trial/progress.hpp"

namespace rhexis::tracking {
namespace {

/// Ways to detect alone, of so many seeds.
Result<TrackingFigures> measure_chart(const MeasurePlan& plan, Progress& progress) {
    Numbers numbers;
    for (int seed = 0; seed < plan.seeds; ++seed) {
        progress.show(static_cast<double>(seed) / plan.seeds, "ways to find spots");
        const Result<Setting> setting = setting_of(plan, plan.first_seed + static_cast<std::uint64_t>(seed));
        const Result<Numbers> found = setting ? measure_detectors(setting.value()) : setting.error();
        if (!found) {
            return found.error();
        }
        append(found.value(), numbers);
    }
    TrackingFigures figures;
    figures.first_seed = plan.first_seed;
    figures.seeds = plan.seeds;
    figures.chart = chart_rows(numbers);
    return figures;
}

}  // namespace

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
    Result<TrackingFigures> figures = TrackingFigures{};
    if (options.chart_only) {
        figures = measure_chart(plan, progress);
    } else if (!options.network_only) {
        figures = measure_tracking(
            plan, [&progress](double share, std::string_view what) { progress.show(share, std::string(what)); });
    }
    for (const bool by_datagram : {false, true}) {
        if (figures && !options.chart_only) {
            progress.show(1.0, "the way over the network");
            const Result<Hop> hop = measure_hop(by_datagram, options.poses);
            if (!hop) {
                return hop.error();
            }
            figures.value().figures.push_back(figure_of(hop.value()));
        }
    }
    progress.clear();
    if (!figures) {
        return figures.error();
    }
    std::printf("%s\n", (options.json ? figures_json(figures.value()) : figures_markdown(figures.value())).c_str());
    return success();
}

}  // namespace rhexis::tracking
