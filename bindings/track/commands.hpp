// SPDX-License-Identifier: GPL-3.0-or-later
// What the entries of the shared object do.
#pragma once

#include "track/track_options.hpp"

namespace rhexis::tracking {

Status track(const TrackOptions& options);
Status lenses(const LensesOptions& options);
Status calibrate(const CalibrateOptions& options);
Status pivot(const PivotOptions& options);
Status begin(const std::string& folder);
Status measure(const MeasureOptions& options);
Status print_body(const std::string& body, const std::string& stl);

}  // namespace rhexis::tracking
