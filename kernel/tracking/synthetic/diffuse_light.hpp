// SPDX-License-Identifier: GPL-3.0-or-later
// Light of what is no marker: fingers and handles, glints, specks.
#pragma once

#include "base/rng.hpp"
#include "tracking/synthetic/seen_scene.hpp"
#include "tracking/synthetic/sensor.hpp"

namespace rhexis::tracking::synthetic {

/// Capsules of a scene in the camera's frame; where several overlap, the brightest is seen.
void add_capsules(const TrueCamera& camera, const Scene& seen, LightField& field);

/// Glints of a scene in the camera's frame that nothing hides.
void add_glints(const TrueCamera& camera, const Scene& seen, LightField& field);

/// Share of a glint's light that nothing hides.
double glint_left(const Scene& seen, const Glint& glint);

/// A random bright point of an image.
struct Speck {
    Vec2 at = Vec2::Zero();  ///< [pixels]
    double light = 0.0;      ///< of its middle [DN], 30 to 200
    double sigma_px = 0.5;   ///< 0.4 to 1
};
Speck draw_speck(int width, int height, Rng& rng);

/// As many as a Poisson distribution of mean `specks` has it, anywhere, a pixel or two wide.
void add_specks(double specks, Rng& rng, LightField& field);

}  // namespace rhexis::tracking::synthetic
