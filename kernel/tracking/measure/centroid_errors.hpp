// SPDX-License-Identifier: GPL-3.0-or-later
// How far found centres of single spheres' images are from where they should be.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "tracking/spots/spot_finder.hpp"

namespace rhexis::tracking {

struct CentroidErrors {
    std::int64_t samples = 0;
    std::int64_t missed = 0;          ///< spheres of which no spot was found within 3 pixels
    double rms_px = 0.0;              ///< each way
    std::vector<double> errors_px{};  ///< two of each sample, one each way
    std::vector<double>
        bounds_px{};  ///< of each sphere of the first image, each way: no finder without bias has less noise [Rao1945]
    double told_sigma_px = 0.0;  ///< root mean square of what spots say of themselves
};

/// Whole, unworn spheres all over the images of a true camera, apart from each other; the wanted centre is that of the
/// ellipse that the true lens shows. `width_px`: of the images, 5 to 24, by the spheres' size. The errors are those of
/// SyntheticRig::create().
Result<CentroidErrors> measure_centroids(double width_px, int images, std::uint64_t seed, const SpotSettings& settings);

}  // namespace rhexis::tracking
