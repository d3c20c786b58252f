// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis track measure: what tracking reaches, against a rig that is not what it takes it to be.
#include <unistd.h>

#include <cstdio>

#include "track/commands.hpp"
#include "track/hop.hpp"
#include "tracking/measure/figures.hpp"

namespace rhexis::tracking {

Status measure(const MeasureOptions& options) {
    MeasurePlan plan;
    plan.first_seed = options.first_seed;
    plan.seeds = options.seeds;
    plan.image_s = options.image_s;
    plan.marker_s = options.marker_s;
    plan.identity_frames = options.identity_frames;
    plan.chart = options.chart;
    const bool terminal = isatty(STDERR_FILENO) == 1;
    const auto say = [terminal](std::string_view what) {
        if (terminal) {
            std::fprintf(stderr, "\r\x1b[K%.*s", static_cast<int>(what.size()), what.data());
        }
    };
    Result<TrackingFigures> figures = TrackingFigures{};
    if (!options.network_only) {
        figures = measure_tracking(plan, say);
    }
    for (const bool by_datagram : {false, true}) {
        if (figures) {
            say("the way over the network");
            const Result<Hop> hop = measure_hop(by_datagram, options.poses);
            if (!hop) {
                return hop.error();
            }
            figures.value().figures.push_back(figure_of(hop.value()));
        }
    }
    say("");
    if (!figures) {
        return figures.error();
    }
    std::printf("%s\n", (options.json ? figures_json(figures.value()) : figures_markdown(figures.value())).c_str());
    return success();
}

}  // namespace rhexis::tracking
