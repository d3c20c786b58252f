// SPDX-License-Identifier: GPL-3.0-or-later
// scenes of one exposure -> spots, without whole images in between: for studies of a million frames.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/rng.hpp"
#include "tracking/spot.hpp"
#include "tracking/synthetic/marker_patch.hpp"
#include "tracking/synthetic/seen_scene.hpp"

namespace rhexis::tracking::synthetic {

/// How far centroids of images are from where they should be: a normal deviate on each axis, of the standard deviation
/// hypot(floor_px, s), where s is that of a light-weighted centroid whose pixels have the sensor's shot, read and
/// rounding noise, those of the spot and `rim_px` around it. Fitted to threshold-weighted centroids of this folder's
/// images, of spots of 7 to 24 pixels' width. Of centres of light only.
struct CentroidNoise {
    double rim_px = 1.5;
    double shot = 1.0;        ///< times s
    double floor_px = 0.003;  ///< what the place within a pixel and pixels of unlike response leave
};

/// The same of outlines that are fitted (spots/outline.hpp) to whole, clean spheres that stand alone. Fitted to images
/// of spots of 20 to 28 pixels' width, seeds 1 to 6.
struct OutlineNoise {
    double shot = 1.33;  ///< times what the sensor's noise at the rim, by the slope of light there, moves 64 rays
    double within_px = 0.0124;      ///< most by which the place within a pixel moves the centre, both ways
    double within_from_px = 0.128;  ///< of the radius, at which that is the most
    double inward = 1.65e-5;        ///< share of the way from the image's middle that outlines lie too near to it
    double pattern_px = 0.004;      ///< what pixels of unlike response leave, anew every `pattern_of_px`
    double pattern_of_px = 0.3;
    double stretch = 0.5;     ///< share of an ellipse's stretch that the fit tells
    double inside_px = 0.19;  ///< by which they are narrower each way than the sphere's image
};

/// What the detector makes of a spot: the centre of light, or of the outline.
enum class SpotCentre : std::uint8_t { light, outline };

struct SpotOptions {
    CentroidNoise noise{};
    SpotCentre centre = SpotCentre::outline;
    OutlineNoise outline{};
    SpotSettings finder{};      ///< of outlines: what is dimmer or smaller is no spot, and what looks at patches
    double least_light = 20.0;  ///< of light, above the black level [DN]: what is dimmer is no spot
    double least_share = 0.05;  ///< of a sphere that is seen: what is less is no spot
    double gap_px = 1.0;        ///< discs that are nearer to each other than this are one spot
};

struct SpotScratch {
    std::vector<Scene> seen{};
    Hiders hiders{};
    std::vector<int> sphere_of{};  ///< the sphere that most of a spot's light is of, -1: none; in the order of spots
    struct Part {
        Spot spot{};
        double light = 0.0;   ///< sum over its pixels [DN]
        double radius = 0.0;  ///< [pixels]
        int sphere = -1;
        std::size_t group = 0;  ///< of spots that touch
        bool settled = false;   ///< it does not touch another that is settled
    };
    std::vector<Part> parts{};
    std::vector<Vec2> disc{};  ///< even samples of a disc of radius 1

    /// A sphere or a glint as it shines in the image.
    struct Bright {
        int sphere = -1;
        int glint = -1;
        Vec2 at = Vec2::Zero();
        double radius = 0.0;
        bool odd = false;       ///< worn, partly hidden, or smeared
        std::size_t group = 0;  ///< of those whose light meets
    };
    std::vector<Bright> bright{};
    PatchScratch patch{};
};

/// What a camera makes of a scene, in `spots`. Of light: the centre of light of each sphere's true image (an ellipse,
/// its lobe and the vignetting in it), shifted where it is partly hidden or worn, with noise; those that touch are one.
/// Of outlines: the true ellipse's centre with the error that the finder makes of it, where a sphere is whole, clean
/// and alone; else what the finder makes of a small image (marker_patch.hpp). Glints and specks. `instants`: as of
/// render(); places are their mean, what hides is taken from the one in the middle.
void spots_without_images(const TrueCamera& camera, std::span<const Scene> instants, const SpotOptions& options,
                          Rng& rng, SpotScratch& scratch, std::vector<Spot>& spots);

/// The outline of a sphere's image in the plane of (X/Z, Y/Z): an ellipse, its longer axis along the radius.
struct Outline {
    Vec2 centre = Vec2::Zero();
    double along = 0.0;   ///< semi-axis towards the image's centre
    double across = 0.0;  ///< the other
};
Outline outline(const Sphere& seen);

/// Centre of a whole sphere's light [pixels], without noise.
Vec2 centre_of_light(const TrueCamera& camera, const Sphere& seen);

}  // namespace rhexis::tracking::synthetic
