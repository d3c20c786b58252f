// SPDX-License-Identifier: GPL-3.0-or-later
// What stands before the cameras at one instant: reflecting spheres, what hides them, and other light. All in the
// rig's frame [mm]. Light is in digital numbers of a sensor at 450 mm on a camera's axis.
#pragma once

#include <vector>

#include "math/types.hpp"
#include "tracking/calibration/board.hpp"

namespace rhexis::tracking::synthetic {

/// Distance at which light is stated [mm]; it falls as the square of the distance.
inline constexpr double light_at_mm = 450.0;

struct Sphere {
    Vec3 centre = Vec3::Zero();
    double radius = 3.0;
    double light = 130.0;               ///< of its middle, which faces the camera
    double lobe = 0.5;                  ///< 0 to 1: what is lost at the limb, as the square of the angle's sine
    Vec3 worn_towards = Vec3::UnitZ();  ///< middle of a worn patch, unit length
    double worn_cosine = 2.0;           ///< of the patch's half angle; above 1: there is none
    double worn_left = 1.0;             ///< share of light that a worn patch still gives
};

/// A finger, a handle, a shaft, or the column of a microscope: a round rod with round ends.
struct Capsule {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    double radius = 1.0;
    double soft = 0.5;   ///< width of its edge, half of it beyond `radius`; above 0
    double light = 0.0;  ///< diffuse
};

/// A hand or a sheet before a camera: dark.
struct Disc {
    Vec3 centre = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();  ///< unit length
    double radius = 1.0;
    double soft = 0.5;  ///< as of a capsule
};

/// A reflection, smaller than a pixel but for the blur that it is given.
struct Glint {
    Vec3 at = Vec3::Zero();
    double light = 0.0;     ///< of its brightest pixel, at any distance
    double sigma_px = 1.0;  ///< 0.3 to 6
};

/// A flat board with a pattern, lit by each camera's own ring light: dots that reflect like spheres do, or printed
/// fields. Its middle is the origin of its frame, x runs along its rows and y along its columns, both as in an image;
/// z looks away from who sees it.
struct Board {
    Pose pose{};
    GridPlan plan{};
    double light = 130.0;  ///< of dots, or of the brighter fields and their margin
    double ground = 6.0;   ///< between dots, or of the darker fields
    double dot = 0.25;     ///< radius of a dot, as a share of the spacing
};

struct Scene {
    std::vector<Sphere> spheres{};
    std::vector<Capsule> capsules{};
    std::vector<Disc> discs{};
    std::vector<Glint> glints{};
    std::vector<Board> boards{};
    double ambient = 3.0;  ///< light on every pixel [DN]
    double specks = 0.0;   ///< random bright points, mean number in an image
};

/// Share of light that comes from a point to `eye`, past what is between: 0 to 1.
double light_past(const Capsule& capsule, const Vec3& eye, const Vec3& point);
double light_past(const Disc& disc, const Vec3& eye, const Vec3& point);

/// Whether it may take light of a ball of this radius: never false where it does.
bool may_hide(const Capsule& capsule, const Vec3& eye, const Vec3& centre, double radius);
bool may_hide(const Disc& disc, const Vec3& eye, const Vec3& centre, double radius);

/// Where the straight lines between two pairs of points are nearest to each other.
struct Nearest {
    double distance = 0.0;
    double along_first = 0.0;  ///< 0 at its first end, 1 at its second
    double along_second = 0.0;
};
Nearest nearest(const Vec3& from, const Vec3& to, const Vec3& other_from, const Vec3& other_to);

/// 0 below 0, 1 above 1, and 3 x^2 - 2 x^3 between.
double smooth_step(double x);

}  // namespace rhexis::tracking::synthetic
