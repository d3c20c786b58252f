// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/depth_raster.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

constexpr double nearest_w = 1e-6;  ///< what is nearer to the camera is not seen

/// Depth along one row: (start + slope k) / (1 + turn k) at its k-th pixel, and no corner's triangle leaves its own
/// range of depths.
struct Row {
    int y = 0;
    int first = 0;
    int count = 0;
    float start = 0.0F;
    float slope = 0.0F;
    float turn = 0.0F;
    float least = 0.0F;
    float most = 0.0F;
    bool front = false;  ///< corners turn counter-clockwise

    [[nodiscard]] float depth(int k) const {
        const float step = static_cast<float>(k);
        return std::min(std::max((start + slope * step) / (1.0F + turn * step), least), most);
    }
};

/// Value over the picture that is linear there: at the corner of a triangle, and its changes per pixel.
struct Slope {
    double at_corner = 0.0;
    double along_x = 0.0;
    double along_y = 0.0;

    [[nodiscard]] double at(double x, double y) const { return at_corner + along_x * x + along_y * y; }
};

/// Where an edge crosses the middle of a row: the same number for both triangles of the edge.
template <typename Corner>
double crossing(const Corner& a, const Corner& b, double y) {
    const Corner& low = a.y < b.y ? a : b;
    const Corner& high = a.y < b.y ? b : a;
    return low.x + (y - low.y) * ((high.x - low.x) / (high.y - low.y));
}

/// First pixel whose centre is not left of x.
int pixel_from(double x, int low, int high) {
    return static_cast<int>(std::ceil(std::clamp(x - 0.5, static_cast<double>(low), static_cast<double>(high))));
}

}  // namespace

DepthRaster::DepthRaster(int width, int height)
    : width_(width), stop_(static_cast<std::size_t>(width) * height, no_stop), sum_(stop_.size()) {}

void DepthRaster::look(const View& view, const Vec3& reference) {
    pixels_from_world_ = view.clip_from_world;
    const Mat4& clip = view.clip_from_world;
    pixels_from_world_.row(0) = 0.5 * view.width * (clip.row(3) + clip.row(0));
    pixels_from_world_.row(1) = 0.5 * view.height * (clip.row(3) + clip.row(1));
    pixels_from_world_.row(2) << view.axis.transpose(), -view.axis.dot(reference);
}

DepthRaster::Corner DepthRaster::seen(const Vec3& point) const {
    const Vec4 place = pixels_from_world_ * point.homogeneous();
    return {place.x(), place.y(), place.w(), place.z()};
}

template <typename Paint>
void DepthRaster::paint_visible(const std::array<Vec3, 3>& corners, const PixelRect& area, const Paint& paint) const {
    const Triangle all{seen(corners[0]), seen(corners[1]), seen(corners[2])};
    std::array<Corner, 4> kept;
    int count = 0;
    for (int i = 0; i < 3; ++i) {
        const Corner& here = all[i];
        const Corner& next = all[(i + 1) % 3];
        if (here.w >= nearest_w) {
            kept[count++] = here;
        }
        if ((here.w >= nearest_w) != (next.w >= nearest_w)) {
            const double share = (nearest_w - here.w) / (next.w - here.w);
            kept[count++] = {here.x + share * (next.x - here.x), here.y + share * (next.y - here.y), nearest_w,
                             here.depth + share * (next.depth - here.depth)};
        }
    }
    for (int i = 2; i < count; ++i) {
        paint_triangle({kept[0], kept[i - 1], kept[i]}, area, paint);
    }
}

template <typename Paint>
void DepthRaster::paint_triangle(Triangle corners, const PixelRect& area, const Paint& paint) {
    for (Corner& corner : corners) {
        corner.x /= corner.w;
        corner.y /= corner.w;
    }
    const auto& [a, b, c] = corners;
    const double bx = b.x - a.x;
    const double by = b.y - a.y;
    const double cx = c.x - a.x;
    const double cy = c.y - a.y;
    const double twice_area = bx * cy - by * cx;
    if (!(std::abs(twice_area) > 1e-12)) {
        return;
    }
    const auto slope_of = [&](double at_a, double at_b, double at_c) {
        const double to_b = at_b - at_a;
        const double to_c = at_c - at_a;
        return Slope{at_a, (to_b * cy - to_c * by) / twice_area, (to_c * bx - to_b * cx) / twice_area};
    };
    // Over the picture not the depth is linear, but depth / w and 1 / w.
    const Slope one = slope_of(1.0 / a.w, 1.0 / b.w, 1.0 / c.w);
    const Slope deep = slope_of(a.depth / a.w, b.depth / b.w, c.depth / c.w);
    Row row;
    row.front = twice_area > 0.0;
    row.least = static_cast<float>(std::min({a.depth, b.depth, c.depth}));
    row.most = static_cast<float>(std::max({a.depth, b.depth, c.depth}));
    const auto [low, high] = std::minmax({a.y, b.y, c.y});
    const int right = area.x + area.width;
    const int end = pixel_from(high, area.y, area.y + area.height);
    for (row.y = pixel_from(low, area.y, area.y + area.height); row.y < end; ++row.y) {
        const double y = row.y + 0.5;
        std::array<double, 3> across{};
        int crossed = 0;
        for (int i = 0; i < 3; ++i) {
            const Corner& from = corners[i];
            const Corner& to = corners[(i + 1) % 3];
            if ((from.y <= y) != (to.y <= y)) {
                across[crossed++] = crossing(from, to, y);
            }
        }
        if (crossed != 2) {
            continue;
        }
        row.first = pixel_from(std::min(across[0], across[1]), area.x, right);
        row.count = pixel_from(std::max(across[0], across[1]), area.x, right) - row.first;
        if (row.count <= 0) {
            continue;
        }
        const double x = row.first + 0.5 - a.x;
        const double scale = 1.0 / one.at(x, y - a.y);
        row.start = static_cast<float>(deep.at(x, y - a.y) * scale);
        row.slope = static_cast<float>(deep.along_x * scale);
        row.turn = static_cast<float>(one.along_x * scale);
        paint(row);
    }
}

void DepthRaster::clear_stop(const PixelRect& area) {
    for (int y = area.y; y < area.y + area.height; ++y) {
        std::fill_n(&stop_[static_cast<std::size_t>(y) * width_ + area.x], area.width, no_stop);
    }
}

void DepthRaster::stop_at(const std::vector<Vec3>& corners, const PixelRect& area) {
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        paint_visible({corners[i], corners[i + 1], corners[i + 2]}, area, [this](const Row& row) {
            float* stop = &stop_[static_cast<std::size_t>(row.y) * width_ + row.first];
            for (int k = 0; k < row.count; ++k) {
                stop[k] = std::min(stop[k], row.depth(k));
            }
        });
    }
}

void DepthRaster::clear_sum(const PixelRect& area, int channels) {
    channels_ = channels;
    sum_.resize(stop_.size() * channels);
    for (int y = area.y; y < area.y + area.height; ++y) {
        std::fill_n(&sum_[channels * (static_cast<std::size_t>(y) * width_ + area.x)], channels * area.width, 0.0F);
    }
}

void DepthRaster::add(const FaceStream& faces, const PixelRect& area) {
    for (const SignedFace& face : faces) {
        paint_visible(face.corners, area, [&](const Row& row) {
            const Eigen::Vector3f change = (row.front ? -1.0F : 1.0F) * face.change;
            const std::size_t first = static_cast<std::size_t>(row.y) * width_ + row.first;
            const float* stop = &stop_[first];
            float* sum = &sum_[channels_ * first];
            if (channels_ == 1) {
                for (int k = 0; k < row.count; ++k) {
                    sum[k] += change[0] * std::min(row.depth(k), stop[k]);
                }
                return;
            }
            for (int k = 0; k < row.count; ++k) {
                const float until = std::min(row.depth(k), stop[k]);
                for (int c = 0; c < 3; ++c) {
                    sum[3 * k + c] += change[c] * until;
                }
            }
        });
    }
}

}  // namespace rhexis
