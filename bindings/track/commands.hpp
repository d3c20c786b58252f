// SPDX-License-Identifier: GPL-3.0-or-later
// What the entries of the shared object do.
#pragma once

#include "track/track_options.hpp"

namespace rhexis::tracking {

Status track(const TrackOptions& options);
Status lenses(const LensesOptions& options);
Status calibrate(const CalibrateOptions& options);
Status pivot(const PivotOptions& options);
Status begin(const BeginOptions& options);
Status design(const DesignOptions& options);
Status measure(const MeasureOptions& options);
Status print_body(const PrintOptions& options);

}  // namespace rhexis::tracking
