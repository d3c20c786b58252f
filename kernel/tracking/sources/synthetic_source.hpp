// SPDX-License-Identifier: GPL-3.0-or-later
// Exposures of the synthetic rig: of a clip, of a waved wand, or of whatever a caller puts before its cameras.
#pragma once

#include <array>
#include <functional>

#include "tracking/sources/spot_source.hpp"
#include "tracking/synthetic/delivery.hpp"
#include "tracking/synthetic/marker_spots.hpp"
#include "tracking/synthetic/renderer.hpp"

namespace rhexis::tracking::synthetic {

/// What stands before the cameras at a time [s], and how a camera stands then.
struct Stage {
    std::function<void(double time_s, Scene& scene)> scene{};
    std::function<TrueCamera(int camera, double time_s)> camera{};  ///< empty: as the rig has it
    int instants = 3;                                               ///< scenes in an exposure: what moves, smears
};

struct Film {
    std::uint64_t seed = 1;  ///< of noise and of what is lost
    Delivery delivery{};
    std::int64_t frames = 1200;  ///< for each camera; as many as one likes
    /// Of spots without images: those of light are cruder, and six times as fast.
    SpotCentre centre = SpotCentre::outline;
};

/// Images, of which a tracker finds the spots itself. The error is that of shots().
Result<std::unique_ptr<FrameSource>> film_images(const SyntheticRig& rig, Stage stage, const Film& film);

/// Spots without images in between: fifty times as fast, or more.
Result<std::unique_ptr<SpotSource>> film_markers(const SyntheticRig& rig, Stage stage, const Film& film);

/// A wand of three spheres, at 0, 80 and 200 mm, waved through the volume about the eye for as long as one likes.
inline constexpr std::array<double, 3> wand_mm{0.0, 80.0, 200.0};
Stage waved_wand(std::uint64_t seed);

}  // namespace rhexis::tracking::synthetic
