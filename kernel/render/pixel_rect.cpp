// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pixel_rect.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace rhexis {

namespace {

PixelRect between(double left, double bottom, double right, double top, const View& view) {
    const auto clipped = [](double value, int most) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    PixelRect rect;
    rect.x = clipped(std::floor(left), view.width);
    rect.y = clipped(std::floor(bottom), view.height);
    rect.width = clipped(std::ceil(right), view.width) - rect.x;
    rect.height = clipped(std::ceil(top), view.height) - rect.y;
    return rect;
}

/// Where a horizontal circle about the eye's axis shows.
struct Rim {
    std::array<Vec2, 193> places;  ///< pixels from the bottom left; the last is the first again
    double apart = 0.0;            ///< of neighbours, in rows

    /// Whether a place lies in these rows or next to one that does.
    [[nodiscard]] bool near(const Vec2& place, const PixelRect& band, double margin) const {
        return place.y() > band.y - apart - margin && place.y() < band.y + band.height + apart + margin;
    }
};

/// None if some of the circle lies behind the camera.
std::optional<Rim> rim_of(const View& view, double radius, double z) {
    Rim rim;
    for (std::size_t i = 0; i < rim.places.size(); ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / (rim.places.size() - 1.0);
        const Vec3 point(radius * std::cos(angle), radius * std::sin(angle), z);
        if (!((view.clip_from_world * point.homogeneous()).w() > 1e-6)) {
            return std::nullopt;
        }
        rim.places[i] = pixel_of(view, point);
        rim.places[i].y() = view.height - rim.places[i].y();
        rim.apart = std::max(rim.apart, i > 0 ? std::abs(rim.places[i].y() - rim.places[i - 1].y()) : 0.0);
    }
    return rim;
}

}  // namespace

PixelRect whole(const View& view) { return {0, 0, view.width, view.height}; }

PixelRect rect_around(const View& view, std::span<const Vec3> points, int margin) {
    Vec2 low = Vec2::Constant(1e9);
    Vec2 high = Vec2::Constant(-1e9);
    for (const Vec3& point : points) {
        const Vec4 clip = view.clip_from_world * point.homogeneous();
        if (!(clip.w() > 1e-6)) {
            return whole(view);
        }
        const Vec2 pixel = pixel_of(view, point);
        low = low.cwiseMin(pixel);
        high = high.cwiseMax(pixel);
    }
    return between(low.x() - margin, view.height - high.y() - margin, high.x() + margin, view.height - low.y() + margin,
                   view);
}

PixelRect rect_around_circle(const View& view, double radius, double z, int margin) {
    constexpr int corners = 24;
    // Corners of a polygon around the circle, not in it.
    const double reach = radius / std::cos(std::numbers::pi / corners);
    std::array<Vec3, corners> rim;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        rim[i] = Vec3(reach * std::cos(angle), reach * std::sin(angle), z);
    }
    return rect_around(view, rim, margin);
}

PixelRect united(const PixelRect& a, const PixelRect& b) {
    if (a.empty() || b.empty()) {
        return a.empty() ? b : a;
    }
    PixelRect rect{std::min(a.x, b.x), std::min(a.y, b.y), 0, 0};
    rect.width = std::max(a.x + a.width, b.x + b.width) - rect.x;
    rect.height = std::max(a.y + a.height, b.y + b.height) - rect.y;
    return rect;
}

PixelRect intersected(const PixelRect& a, const PixelRect& b) {
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

std::vector<PixelRect> within_stop(std::vector<PixelRect> bands, const View& view, double radius) {
    if (radius <= 0.0) {
        return bands;
    }
    const double reach = radius + 1.0;
    const double middle = 0.5 * view.height;
    for (PixelRect& band : bands) {
        const double nearest = std::clamp(middle, double(band.y), double(band.y + band.height)) - middle;
        const double half = std::sqrt(std::max(0.0, reach * reach - nearest * nearest));
        band = intersected(
            band, between(0.5 * view.width - half, band.y, 0.5 * view.width + half, band.y + band.height, view));
    }
    std::erase_if(bands, [](const PixelRect& band) { return band.empty(); });
    return bands;
}

std::vector<PixelRect> bands_of(const View& view) {
    std::vector<PixelRect> bands;
    for (int y = 0; y < view.height; y += band_rows) {
        bands.push_back({0, y, view.width, std::min(band_rows, view.height - y)});
    }
    return bands;
}

std::vector<PixelRect> bands_around_circle(const View& view, double radius, double z, int margin) {
    const std::optional<Rim> rim = rim_of(view, radius, z);
    if (!rim) {
        return bands_of(view);
    }
    std::vector<PixelRect> bands;
    for (const PixelRect& band : bands_of(view)) {
        double left = view.width;
        double right = 0.0;
        for (const Vec2& place : rim->places) {
            if (rim->near(place, band, margin)) {
                left = std::min(left, place.x() - margin);
                right = std::max(right, place.x() + margin);
            }
        }
        const PixelRect reach = between(left, band.y, right, band.y + band.height, view);
        if (!reach.empty()) {
            bands.push_back(reach);
        }
    }
    return bands;
}

std::vector<PixelRect> bands_within_circle(const View& view, double radius, double z) {
    const std::optional<Rim> rim = radius > 0.0 ? rim_of(view, radius, z) : std::nullopt;
    std::vector<PixelRect> bands;
    if (!rim) {
        return bands;
    }
    const auto [lowest, highest] = std::minmax_element(rim->places.begin(), rim->places.end(),
                                                       [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
    const double middle = 0.5 * (lowest->x() + highest->x());
    for (const PixelRect& band : bands_of(view)) {
        if (band.y < lowest->y() || band.y + band.height > highest->y()) {
            continue;
        }
        double left = 0.0;
        double right = view.width;
        for (const Vec2& place : rim->places) {
            if (rim->near(place, band, 0.0)) {
                (place.x() < middle ? left : right) =
                    place.x() < middle ? std::max(left, place.x()) : std::min(right, place.x());
            }
        }
        const PixelRect reach = between(left + 1.0, band.y, right - 1.0, band.y + band.height, view);
        if (!reach.empty()) {
            bands.push_back(reach);
        }
    }
    return bands;
}

std::vector<PixelRect> without(const std::vector<PixelRect>& outer, const std::vector<PixelRect>& inner) {
    std::vector<PixelRect> pieces;
    auto hole = inner.begin();
    for (const PixelRect& band : outer) {
        hole = std::find_if(hole, inner.end(), [&](const PixelRect& one) { return one.y >= band.y; });
        const bool cut = hole != inner.end() && hole->y == band.y;
        const int from = cut ? std::max(hole->x, band.x) : band.x + band.width;
        const int to = cut ? hole->x + hole->width : band.x + band.width;
        for (const PixelRect& piece : {PixelRect{band.x, band.y, from - band.x, band.height},
                                       PixelRect{to, band.y, band.x + band.width - to, band.height}}) {
            if (!piece.empty()) {
                pieces.push_back(piece);
            }
        }
    }
    return pieces;
}

std::vector<float> triangles_of(const std::vector<PixelRect>& rects, int width, int height) {
    std::vector<float> corners;
    for (const PixelRect& rect : rects) {
        const float left = static_cast<float>(rect.x) / static_cast<float>(width);
        const float right = static_cast<float>(rect.x + rect.width) / static_cast<float>(width);
        const float low = static_cast<float>(rect.y) / static_cast<float>(height);
        const float high = static_cast<float>(rect.y + rect.height) / static_cast<float>(height);
        corners.insert(corners.end(), {left, low, right, low, right, high, left, low, right, high, left, high});
    }
    return corners;
}

PixelRect halved(const PixelRect& rect) {
    const int x = rect.x / 2;
    const int y = rect.y / 2;
    return {x, y, (rect.x + rect.width + 1) / 2 - x, (rect.y + rect.height + 1) / 2 - y};
}

Scissor::Scissor(const PixelRect& rect) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(rect.x, rect.y, std::max(rect.width, 0), std::max(rect.height, 0));
}

Scissor::~Scissor() { glDisable(GL_SCISSOR_TEST); }

}  // namespace rhexis
