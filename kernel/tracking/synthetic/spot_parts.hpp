// SPDX-License-Identifier: GPL-3.0-or-later
// What spots without images are made of: how much of a sphere is left to be seen, and points of light.
#pragma once

#include <optional>

#include "tracking/synthetic/marker_spots.hpp"

namespace rhexis::tracking::synthetic {

/// What part of a sphere's light is left, and how far the centre of light and its spread are moved by what is missing.
struct Left {
    double share = 1.0;
    double light = 1.0;
    Vec2 shift = Vec2::Zero();
    double least = 1.0;  ///< standard deviation of the light across and along, by those of the whole sphere
    double greatest = 1.0;
};

/// Mean square of the distance from the middle, by that of an evenly lit disc: the lobe takes light from the limb.
inline double lobe_spread(double lobe) { return (0.5 - lobe / 3.0) / (0.5 - lobe / 4.0); }

/// Whether any of its worn patch is on the side that the camera sees.
bool shows_wear(const Sphere& seen);

/// Whether all instants' centres lie before the camera, and the middle one's in its image.
bool may_be_seen(const TrueCamera& camera, const std::vector<Scene>& seen, int sphere);

/// By its light; false: it is dim, or hidden but for a small part. What hides it is in `scratch.hiders` then.
bool is_left(const TrueCamera& camera, int sphere, const SpotOptions& options, SpotScratch& scratch, Left& left);

/// How far a sphere's image moves within the exposure, from its first instant's middle to its last one's, and half an
/// instant at both ends.
Vec2 smear(const TrueCamera& camera, const std::vector<Scene>& seen, int sphere);

/// Mean centre of a whole sphere's light, and of its outline, over the instants [pixels].
Vec2 mean_centre(const TrueCamera& camera, const std::vector<Scene>& seen, int sphere);
Vec2 mean_outline(const TrueCamera& camera, const std::vector<Scene>& seen, int sphere);

/// Light of a sphere's middle, by distance and lens [DN].
double light_of_middle(const TrueCamera& camera, const Sphere& seen);

/// Above black level and ambient light [DN]: what is dimmer is no spot.
double least_light_of(const TrueCamera& camera, const SpotOptions& options, double ambient);

/// A spot as it would be found of a sphere's image of which this is left, without its place.
SpotScratch::Part part_of(const TrueCamera& camera, int sphere, const Left& left, const SpotScratch& scratch);

/// Radius of a disc of its area [pixels].
double radius_of(const Spot& spot);

/// Standard deviation of a light-weighted centroid [pixels]; `radius` is that of a disc that spreads as the spot does.
double centroid_sigma(const Sensor& sensor, const CentroidNoise& noise, double light, double radius);

/// Where a glint is in the image; none: behind the camera, or far outside.
std::optional<Vec2> glint_image(const TrueCamera& camera, const Glint& glint);

/// Parts of a glint and of specks, if they are bright and wide enough to be spots.
void add_glint(const TrueCamera& camera, const Glint& glint, const SpotOptions& options, Rng& rng,
               SpotScratch& scratch);
void add_specks(const TrueCamera& camera, const SpotOptions& options, Rng& rng, SpotScratch& scratch);

}  // namespace rhexis::tracking::synthetic
