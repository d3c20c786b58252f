// SPDX-License-Identifier: GPL-3.0-or-later
// Clips without images: trembling, fast hands, what hides, and finding again.
#include <cmath>

#include "tracking/measure/measured_parts.hpp"

namespace rhexis::tracking {

Result<Numbers> measure_tremor(const Setting& setting) {
    constexpr double trembling_hz = 6.0;
    const Result<synthetic::Clip> clip = setting.clip("tremor");
    if (!clip) {
        return clip.error();
    }
    const Result<ClipRun> run = track_clip(setting.rig, setting.solver(), clip.value(), setting.clip_plan(false, 1e9));
    if (!run) {
        return run.error();
    }
    Numbers numbers;
    add_tips(setting.bodies, run.value(), "tremor", numbers);
    for (std::size_t i = 0; i < setting.bodies.size(); ++i) {
        for (const synthetic::Wave& wave : clip.value().motions[i].moves) {
            if (wave.frequency_hz >= trembling_hz) {
                const WaveResponse told = response(run.value().traces[i], wave.frequency_hz);
                numbers["tremor.gain_off"].push_back(std::abs(told.gain - 1.0));
                numbers["tremor.lag_s"].push_back(told.lag_s);
            }
        }
    }
    return numbers;
}

/// At up to 100 mm/s, while cameras expose 5 ms after one another.
Result<Numbers> measure_moving(const Setting& setting) {
    constexpr double share_of_clip = 0.2;  // which goes at up to 500 mm/s
    Result<synthetic::Clip> clip = setting.clip("insertions");
    if (!clip) {
        return clip.error();
    }
    for (synthetic::Motion& motion : clip.value().motions) {
        for (synthetic::Wave& wave : motion.moves) {
            wave.amplitude *= share_of_clip;
        }
    }
    ClipPlan plan = setting.clip_plan(false, setting.plan.marker_s);
    plan.delivery.skew_s = 5e-3;
    const Result<ClipRun> run = track_clip(setting.rig, setting.solver(), clip.value(), plan);
    if (!run) {
        return run.error();
    }
    Numbers numbers;
    add_tips(setting.bodies, run.value(), "moving", numbers);
    return numbers;
}

Result<Numbers> measure_hidden(const Setting& setting) {
    const Result<synthetic::Clip> clip = setting.clip("occlusion");
    if (!clip) {
        return clip.error();
    }
    const Result<ClipRun> run = track_clip(setting.rig, setting.solver(), clip.value(), setting.clip_plan(false, 1e9));
    if (!run) {
        return run.error();
    }
    Numbers numbers;
    add_tips(setting.bodies, run.value(), "hidden", numbers);
    return numbers;
}

/// Exposures from when all cameras are free again until each body is seen; they were blocked long enough to lose it.
Result<Numbers> measure_found_again(const Setting& setting) {
    constexpr double blocked_s = 0.35;
    constexpr int times = 5;
    Result<synthetic::Clip> clip = setting.clip("tremor");
    if (!clip) {
        return clip.error();
    }
    std::vector<double> free_s;
    for (int gap = 0; gap < times; ++gap) {
        const double begin_s = 0.3 + 0.7 * gap;
        free_s.push_back(begin_s + blocked_s);
        for (int camera = 0; camera < static_cast<int>(setting.rig.cameras.size()); ++camera) {
            clip.value().covers.push_back({camera, -1, -1, begin_s, begin_s + blocked_s});
        }
    }
    const Result<ClipRun> run = track_clip(setting.rig, setting.solver(), clip.value(), setting.clip_plan(false, 4.0));
    if (!run) {
        return run.error();
    }
    Numbers numbers;
    for (const TipTrace& trace : run.value().traces) {
        for (const double since_s : free_s) {
            double waited = 0.0;
            for (const TipSample& sample : trace) {
                if (sample.time_s >= since_s) {
                    waited += 1.0;
                    if (sample.seen) {
                        break;
                    }
                }
            }
            numbers["found_again.exposures"].push_back(waited);
        }
    }
    return numbers;
}

}  // namespace rhexis::tracking
