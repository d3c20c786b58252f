// SPDX-License-Identifier: GPL-3.0-or-later
// Tips relative to an eye whose head does not rest.
#include "tracking/measure/measured_parts.hpp"

namespace rhexis::tracking {

Result<Numbers> measure_head(const Setting& setting) {
    Numbers numbers;
    for (const std::string name : {"breathing", "knocks"}) {
        const Result<synthetic::Clip> clip = setting.clip(name);
        if (!clip) {
            return clip.error();
        }
        for (const bool images : {true, false}) {
            const ClipPlan plan = setting.clip_plan(images, images ? setting.plan.image_s : 1e9);
            const Result<ClipRun> run = track_clip(setting.rig, setting.solver(), clip.value(), plan);
            if (!run) {
                return run.error();
            }
            const std::string row = name + (images ? ".images" : ".markers");
            add_tips(setting.bodies, run.value(), row, numbers);
            add_jitters(setting.bodies, run.value(), row, numbers);
        }
    }
    return numbers;
}

}  // namespace rhexis::tracking
