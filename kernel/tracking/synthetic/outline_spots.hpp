// SPDX-License-Identifier: GPL-3.0-or-later
// Spots as fitted outlines, without whole images.
#pragma once

#include "tracking/synthetic/marker_spots.hpp"

namespace rhexis::tracking::synthetic {

/// Parts of all spheres and glints of `scratch.seen`: as marker_spots.hpp says of outlines.
void add_outlines(const TrueCamera& camera, const SpotOptions& options, Rng& rng, SpotScratch& scratch);

}  // namespace rhexis::tracking::synthetic
