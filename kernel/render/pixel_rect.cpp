// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pixel_rect.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

std::vector<PixelRect> without(const PixelRect& outer, const PixelRect& inner) {
    if (inner.empty()) {
        return {outer};
    }
    const int right = inner.x + inner.width;
    const int top = inner.y + inner.height;
    const std::array<PixelRect, 4> pieces{{{outer.x, outer.y, outer.width, inner.y - outer.y},
                                           {outer.x, top, outer.width, outer.y + outer.height - top},
                                           {outer.x, inner.y, inner.x - outer.x, inner.height},
                                           {right, inner.y, outer.x + outer.width - right, inner.height}}};
    std::vector<PixelRect> result;
    std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(result),
                 [](const PixelRect& piece) { return !piece.empty(); });
    return result;
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
