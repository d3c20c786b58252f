// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a picture, so that costly drawing stays where it shows.
#pragma once

#include <span>
#include <vector>

#include "render/view.hpp"

namespace rhexis {

/// Pixels from the bottom left; empty if width or height is 0.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
    bool operator==(const PixelRect&) const = default;
};

PixelRect whole(const View& view);

/// What all points cover, and `margin` pixels more; clipped to the picture. All of it if a point lies behind the
/// camera.
PixelRect rect_around(const View& view, std::span<const Vec3> points, int margin);

/// A horizontal circle about the eye's axis.
PixelRect rect_around_circle(const View& view, double radius, double z, int margin);

constexpr int band_rows = 16;

/// Rows of the picture, a band of band_rows each: as much of each as a horizontal circle about the eye's axis can
/// cover, and `margin` pixels more. Bands of two circles in one picture lie on the same rows.
std::vector<PixelRect> bands_around_circle(const View& view, double radius, double z, int margin);

/// The same, of what the circle covers for certain.
std::vector<PixelRect> bands_within_circle(const View& view, double radius, double z);

/// The whole picture in such bands.
std::vector<PixelRect> bands_of(const View& view);

/// What a disc about the picture's middle covers of them, and a pixel more. radius: pixels; 0: there is no disc, and
/// all of them stay.
std::vector<PixelRect> within_stop(std::vector<PixelRect> bands, const View& view, double radius);

/// What both hold.
PixelRect intersected(const PixelRect& a, const PixelRect& b);

/// Smallest that holds both.
PixelRect united(const PixelRect& a, const PixelRect& b);

/// Bands without bands that lie on the same rows.
std::vector<PixelRect> without(const std::vector<PixelRect>& outer, const std::vector<PixelRect>& inner);

/// Two triangles for each rectangle, as shares of a picture of this size.
std::vector<float> triangles_of(const std::vector<PixelRect>& rects, int width, int height);

/// Half the size, rounded outward; for targets of half the size.
PixelRect halved(const PixelRect& rect);

/// Restricts drawing and clearing as long as it lives.
class Scissor {
public:
    explicit Scissor(const PixelRect& rect);
    ~Scissor();
    Scissor(const Scissor&) = delete;
    Scissor& operator=(const Scissor&) = delete;
};

}  // namespace rhexis
