// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>

#include "render/pixel_rect.hpp"

using namespace rhexis;

namespace {

/// How many of the rectangles hold each pixel, rows from the bottom.
std::vector<int> covers(const std::vector<PixelRect>& rects, const View& view) {
    std::vector<int> count(static_cast<std::size_t>(view.width) * view.height, 0);
    for (const PixelRect& rect : rects) {
        for (int y = rect.y; y < rect.y + rect.height; ++y) {
            for (int x = rect.x; x < rect.x + rect.width; ++x) {
                ++count[static_cast<std::size_t>(y) * view.width + x];
            }
        }
    }
    return count;
}

}  // namespace

TEST_CASE("Bands around a circle hold all of it, bands within it nothing else, and differences fill the picture once") {
    Camera above;
    Camera aside;  // the circle is a slanting ellipse that leaves the picture
    aside.eye = Vec3(60.0, -90.0, 120.0);
    aside.target = Vec3(4.0, 2.0, 0.0);
    for (const Camera& camera : {above, aside}) {
        const View view = view_in_air(camera, 150, 101);
        const double radius = 5.0;
        const double z = 1.0;
        const std::vector<PixelRect> around = bands_around_circle(view, radius, z, 1);
        const std::vector<PixelRect> within = bands_within_circle(view, radius, z);
        CHECK(!within.empty());
        const std::vector<int> outer = covers(around, view);
        const std::vector<int> inner = covers(within, view);
        const std::vector<int> outside = covers(without(bands_of(view), around), view);
        const std::vector<int> ring = covers(without(around, within), view);
        bool holds_all = true;
        bool holds_no_more = true;
        bool once = true;
        for (int y = 0; y < view.height; ++y) {
            for (int x = 0; x < view.width; ++x) {
                const Ray ray = pixel_ray(view, x, view.height - 1 - y);
                const Vec3 place = ray.at_plane + (z - ray.at_plane.z()) / ray.direction.z() * ray.direction;
                const bool in_circle = place.head<2>().norm() < radius;
                const std::size_t pixel = static_cast<std::size_t>(y) * view.width + x;
                holds_all = holds_all && (!in_circle || outer[pixel] == 1);
                holds_no_more = holds_no_more && (in_circle || inner[pixel] == 0);
                once = once && outside[pixel] + ring[pixel] + inner[pixel] == 1;
            }
        }
        CHECK(holds_all);
        CHECK(holds_no_more);
        CHECK(once);
    }
}

TEST_CASE("A circle behind the camera may show anywhere, and covers nothing for certain") {
    Camera camera;
    const View view = view_in_air(camera, 40, 30);
    CHECK(bands_around_circle(view, 5.0, 250.0, 1).size() == bands_of(view).size());
    CHECK(bands_within_circle(view, 5.0, 250.0).empty());
    CHECK(bands_within_circle(view, -1.0, 0.0).empty());
}
