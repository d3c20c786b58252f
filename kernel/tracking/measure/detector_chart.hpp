// SPDX-License-Identifier: GPL-3.0-or-later
// Accuracy against compute: ways to detect spots, numbers of cameras and of markers.
#pragma once

#include "tracking/measure/measured_parts.hpp"

namespace rhexis::tracking {

/// The same images of a still clip for all ways to detect, all numbers of cameras and of markers. Rows of tip errors
/// [mm] and of seconds, as chart_rows() reads them.
Result<Numbers> measure_detectors(const Setting& setting);

/// Those of several seeds together; none: they were not measured.
std::vector<ChartRow> chart_rows(const Numbers& numbers);

}  // namespace rhexis::tracking
