// SPDX-License-Identifier: GPL-3.0-or-later
// Depths of triangles at the centres of pixels, in double precision. Graphics drivers round the corners of triangles to
// 1/256 of a pixel: on a face seen nearly edge-on that moves the depth by far more than the optical depth may err.
#pragma once

#include <array>
#include <vector>

#include "render/pixel_rect.hpp"
#include "render/signed_faces.hpp"
#include "render/view.hpp"

namespace rhexis {

/// A depth beyond any scene: no instrument on this line.
inline constexpr float no_stop = 1e4F;

/// Rows from the bottom. A pixel belongs to a triangle if its centre does; of two triangles that share an edge, exactly
/// one gets a centre on it.
class DepthRaster {
public:
    DepthRaster(int width, int height);

    /// From now on depths are those behind the plane through `reference`, seen through `view` of the raster's size.
    void look(const View& view, const Vec3& reference);

    /// Nothing opaque within `area`.
    void clear_stop(const PixelRect& area);
    /// Lets the nearest of these triangles stop the lines of sight. corners: three per triangle [mm].
    void stop_at(const std::vector<Vec3>& corners, const PixelRect& area);

    /// No optical depth within `area`. channels: 1 or 3.
    void clear_sum(const PixelRect& area, int channels);
    /// Adds the share of each face, up to where the line stops: the first `channels` of its colours.
    void add(const FaceStream& faces, const PixelRect& area);

    /// Depth of the first opaque triangle, or no_stop.
    [[nodiscard]] const std::vector<float>& stop() const { return stop_; }
    /// Interleaved channels.
    [[nodiscard]] const std::vector<float>& sum() const { return sum_; }
    [[nodiscard]] int channels() const { return channels_; }

private:
    /// Homogeneous place in the picture [pixels, times w], and depth [mm].
    struct Corner {
        double x = 0.0;
        double y = 0.0;
        double w = 1.0;
        double depth = 0.0;
    };
    using Triangle = std::array<Corner, 3>;

    [[nodiscard]] Corner seen(const Vec3& point) const;
    /// Paints each row of a triangle, cut off where it comes too near to the camera.
    template <typename Paint>
    void paint_visible(const std::array<Vec3, 3>& corners, const PixelRect& area, const Paint& paint) const;
    template <typename Paint>
    static void paint_triangle(Triangle corners, const PixelRect& area, const Paint& paint);

    int width_;
    int channels_ = 1;
    Mat4 pixels_from_world_ = Mat4::Identity();  ///< rows: x, y, depth, w
    std::vector<float> stop_;
    std::vector<float> sum_;
};

}  // namespace rhexis
