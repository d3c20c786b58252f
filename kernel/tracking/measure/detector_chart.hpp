// SPDX-License-Identifier: GPL-3.0-or-later
// Accuracy against compute: ways to detect spots, numbers of cameras and of markers.
#pragma once

#include "tracking/measure/figures.hpp"

namespace rhexis::tracking {

/// The same images of a still clip for all rows: `exposures` of each camera.
Result<std::vector<ChartRow>> detector_chart(const synthetic::SyntheticRig& rig, const Rig& solver, std::uint64_t seed,
                                             int exposures);

}  // namespace rhexis::tracking
