// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/camera_health.hpp"

#include "base/index.hpp"

namespace rhexis::tracking {

void CameraHealth::add(double time_s, std::span<const CameraOffset> offsets) {
    residuals_.assign(at(cameras_), CameraResidual{});
    for (const CameraOffset& offset : offsets) {
        CameraResidual& residual = residuals_[at(offset.camera)];
        residual.mean_px += offset.off;
        ++residual.count;
    }
    for (CameraResidual& residual : residuals_) {
        if (residual.count > 0) {
            residual.mean_px /= residual.count;
        }
    }
    watch_.add(state_, time_s, residuals_);
}

}  // namespace rhexis::tracking
