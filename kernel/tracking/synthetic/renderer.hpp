// SPDX-License-Identifier: GPL-3.0-or-later
// scenes of one exposure -> image of one camera.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracking/synthetic/board_light.hpp"
#include "tracking/synthetic/seen_scene.hpp"
#include "tracking/synthetic/sensor.hpp"

namespace rhexis::tracking::synthetic {

struct RenderScratch {
    LightField field{};
    std::vector<Scene> seen{};  ///< the instants, in the camera's frame
    Hiders hiders{};
    std::vector<float> light{};  ///< of one sphere's window
    std::vector<float> share{};  ///< of each pixel that the sphere fills
    std::vector<float> line{};
    BoardScratch board{};
};

/// One exposure: `instants` (at least one) at even distances in it, each with as many spheres, are added up. Rays meet
/// each sphere, 8 x 8 in a pixel and instant (2 x 2 inside one that is neither hidden nor worn), and what is before it;
/// diffuse light, that of the middle instant, has a ray in a pixel and no blur but its own soft edges; boards, likewise
/// of the middle instant, lie behind all else. `image_seed`
/// draws noise and specks: the same image for the same seed. `camera` may have another pose and lens than the one that
/// the pattern was drawn for, but not another sensor.
void render(const TrueCamera& camera, const SensorPattern& pattern, std::span<const Scene> instants,
            std::uint64_t image_seed, RenderScratch& scratch, Image& image);

/// Rays across a pixel.
struct Fineness {
    int rays = 8;
    int inside = 2;      ///< of a sphere that is neither hidden nor worn
    int inside_odd = 8;  ///< of one that is
};

/// The same, but without a sensor: light on each pixel, without the ambient one [DN].
void render_light(const TrueCamera& camera, std::span<const Scene> instants, std::uint64_t image_seed,
                  RenderScratch& scratch, const Fineness& fineness = {});

/// Where a sphere's light may fall, its blur and `more` pixels with it, perhaps outside the image; empty: behind.
Window window_of(const TrueCamera& camera, const Sphere& seen, double more);

}  // namespace rhexis::tracking::synthetic
