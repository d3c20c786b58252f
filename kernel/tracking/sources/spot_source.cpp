// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/sources/spot_source.hpp"

namespace rhexis::tracking {

Result<bool> ImageSpots::next(std::vector<CameraSpots>& exposures) {
    Result<bool> more = frames_->next(set_);
    exposures.clear();
    if (more && more.value()) {
        for (const CameraFrame& frame : set_.frames) {
            exposures.push_back({frame.camera, frame.time_s, finder_.find(frame.view()).spots});
        }
    }
    return more;
}

}  // namespace rhexis::tracking
