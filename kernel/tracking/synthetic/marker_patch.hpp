// SPDX-License-Identifier: GPL-3.0-or-later
// A small image about what no formula tells: spheres that are worn, partly hidden, or so near to each other or to a
// glint that their light meets. It is rendered roughly, and looked at by the finder that real images go to.
#pragma once

#include <span>
#include <vector>

#include "base/rng.hpp"
#include "tracking/spots/spot_finder.hpp"
#include "tracking/synthetic/renderer.hpp"

namespace rhexis::tracking::synthetic {

struct PatchScratch {
    RenderScratch render{};
    std::vector<Scene> instants{};
    Image image{};
};

/// Spots in a window of a camera's image, in the image's own pixels. `instants`: in the camera's frame; of these only
/// the spheres of `spheres` and the glints of `glints` are there, and whatever hides them. A ray in a pixel; shot, read
/// and rounding noise as of expose(), but no pattern of the sensor.
std::vector<Spot> spots_of_patch(const TrueCamera& camera, std::span<const Scene> instants,
                                 const std::vector<int>& spheres, const std::vector<int>& glints, const Window& window,
                                 const SpotSettings& finder, Rng& rng, PatchScratch& scratch);

}  // namespace rhexis::tracking::synthetic
