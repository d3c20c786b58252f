// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/sources/spot_source.hpp"

namespace rhexis::tracking {

Result<bool> ImageSpots::next(std::vector<CameraSpots>& exposures) {
    const std::shared_ptr<FrameSet> set = std::make_shared<FrameSet>();  // the last one may still be looked at
    Result<bool> more = frames_->next(*set);
    exposures.clear();
    if (more && more.value()) {
        for (const CameraFrame& frame : set->frames) {
            exposures.push_back({frame.camera, frame.time_s, finder_.find(frame.view()).spots});
        }
        set_ = set;
    }
    return more;
}

}  // namespace rhexis::tracking
