// SPDX-License-Identifier: GPL-3.0-or-later
// The anterior capsule in the picture: its flap, its stain, and the lens under it.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "make_renderer.hpp"
#include "render/gl_context.hpp"
#include "render/renderer.hpp"
#include "render/view.hpp"
#include "scenes/capsule_pictures.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

constexpr int width = 320;
constexpr int height = 240;

Image picture(Renderer& renderer, const Frame& frame) { return renderer.draw(frame, microscope_camera(frame)); }

struct Places {
    Frame frame;
    View view = view_through_cornea(microscope_camera(frame), width, height, *frame.eye);

    /// Of the capsule's front at a place across the view, in the picture.
    [[nodiscard]] Vec2 pixel(double x, double y) const {
        const HalfEllipsoids lens = lens_shape(Patient{});
        return pixel_of(view, Vec3(x, y, anterior_z(lens, std::hypot(x, y))));
    }
};

/// Mean of something over the pixels about a place.
double mean_at(const Vec2& centre, const std::function<double(std::size_t)>& of_pixel) {
    constexpr int reach = 2;
    double sum = 0.0;
    for (int row = -reach; row <= reach; ++row) {
        for (int column = -reach; column <= reach; ++column) {
            const int x = static_cast<int>(centre.x()) + column;
            const int y = static_cast<int>(centre.y()) + row;
            sum += of_pixel(3 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)));
        }
    }
    return sum / ((2 * reach + 1) * (2 * reach + 1));
}

double change_at(const Image& a, const Image& b, const Vec2& centre) {
    return mean_at(centre, [&](std::size_t i) {
        return std::abs(a.rgb[i] - b.rgb[i]) + std::abs(a.rgb[i + 1] - b.rgb[i + 1]) +
               std::abs(a.rgb[i + 2] - b.rgb[i + 2]);
    });
}

/// Blue as a share of red.
double blueness(const Image& image, const Vec2& centre) {
    return mean_at(centre, [&](std::size_t i) { return (1.0 + image.rgb[i + 2]) / (1.0 + image.rgb[i]); });
}

double greatest_change(const Image& a, const Image& b, const std::function<bool(int, int)>& where) {
    int greatest = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t i = 3 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
            for (std::size_t c = 0; c < 3 && where(x, y); ++c) {
                greatest = std::max(greatest, std::abs(a.rgb[i + c] - b.rgb[i + c]));
            }
        }
    }
    return greatest;
}

}  // namespace

TEST_SUITE("capsule picture") {
    TEST_CASE("a lens under its capsule looks like one that is a solid") {
        Renderer renderer = make_renderer(width, height);
        for (const double grade : {1.0, 3.0, 5.0}) {
            const Frame frame = capsule_frame(grade);
            Frame solid = patient_frame(grade, 7.5, 1500);
            const OpticalDepth still = renderer.optical_depth(frame, microscope_camera(frame));
            const OpticalDepth meshed = renderer.optical_depth(solid, microscope_camera(solid));
            const std::size_t middle = 3 * (static_cast<std::size_t>(height / 2) * width + width / 2);
            for (std::size_t c = 0; c < 3; ++c) {
                INFO("grade " << grade << ", channel " << c);
                CHECK(still.tau[middle + c] == doctest::Approx(meshed.tau[middle + c]).epsilon(0.08));
            }
            solid.bags.clear();  // whose opening would show
            const Places places{frame};
            const double apart =
                change_at(picture(renderer, without_capsule(frame)), picture(renderer, solid), places.pixel(0.0, -1.5));
            CHECK(apart < 20.0);
        }
    }

    TEST_CASE("a lens that is pushed back shows farther from the microscope") {
        Renderer renderer = make_renderer(width, height);
        Frame frame = capsule_frame();
        const Image before = picture(renderer, frame);
        frame.membranes[0].support.lift = -0.5;
        CHECK(picture(renderer, frame).rgb != before.rgb);
    }

    TEST_CASE("a flap shows where it lies and where it came from, and nowhere else") {
        Renderer renderer = make_renderer(width, height);
        const Places places{capsule_frame()};
        Frame flap = places.frame;
        fold_flap(flap.membranes[0]);
        const Image whole = picture(renderer, places.frame);
        const Image folded = picture(renderer, flap);
        CHECK(change_at(whole, folded, places.pixel(fold_line - 0.5, -1.0)) > 20.0);  // on the flap
        CHECK(change_at(whole, folded, places.pixel(fold_line - 0.9, -0.6)) > 20.0);
        const Vec2 left = places.pixel(2.0 * fold_line - torn_radius - 0.5, 0.0);
        const Vec2 right = places.pixel(torn_radius + 0.5, 0.0);
        const Vec2 top = places.pixel(0.0, torn_radius + 0.3);
        const Vec2 bottom = places.pixel(0.0, -torn_radius - 0.3);
        CHECK(greatest_change(whole, folded, [&](int x, int y) {
                  return x < left.x() || x > right.x() || y < top.y() || y > bottom.y();
              }) <= 2);
    }

    TEST_CASE("stain is blue where there is capsule, bluest where it is folded, and gone where it is torn away") {
        Renderer renderer = make_renderer(width, height);
        const Places clear{capsule_frame()};
        Frame stained = capsule_frame(3.0, 1.0);
        const Vec2 rim = clear.pixel(0.0, -3.0);
        const Vec2 on_flap = clear.pixel(fold_line - 0.6, -1.0);
        const Vec2 bared = clear.pixel(fold_line + 0.6, -1.0);
        const Image before = picture(renderer, clear.frame);
        const Image whole = picture(renderer, stained);
        CHECK(blueness(whole, rim) > 2.0 * blueness(before, rim));
        CHECK(blueness(whole, bared) > 2.0 * blueness(before, bared));

        fold_flap(stained.membranes[0]);
        const Image folded = picture(renderer, stained);
        CHECK(blueness(folded, on_flap) > 1.3 * blueness(whole, on_flap));
        CHECK(blueness(folded, bared) < 1.1 * blueness(before, bared));

        Frame disc = capsule_frame(3.0, 1.0);
        tear_disc_away(disc.membranes[0]);
        const Image torn = picture(renderer, disc);
        CHECK(blueness(torn, bared) < 1.1 * blueness(before, bared));
        CHECK(change_at(torn, whole, rim) < 3.0);
        const Image half = picture(renderer, capsule_frame(3.0, 0.5));
        CHECK(blueness(half, rim) > blueness(before, rim));
        CHECK(blueness(half, rim) < blueness(whole, rim));
    }

    TEST_CASE("an instrument hides the capsule that lies deeper") {
        Renderer renderer = make_renderer(width, height);
        Frame clear = capsule_frame();
        clear.tools[0].present = true;
        clear.tools[0].pose = hand_pose(Vec3(0.0, 0.0, 2.4), 0.5);
        Frame stained = capsule_frame(3.0, 1.0);
        stained.tools = clear.tools;
        const Places places{clear};
        const Vec2 on_tip = pixel_of(places.view, Vec3(0.0, -0.6, 2.4));
        CHECK(change_at(picture(renderer, clear), picture(renderer, stained), on_tip) < 30.0);
    }

    TEST_CASE("the same pixels come twice, also after another eye, and numbers that ran away do no harm") {
        Renderer renderer = make_renderer(width, height);
        Frame frame = capsule_frame(3.0, 0.6);
        fold_flap(frame.membranes[0]);
        const Image first = picture(renderer, frame);
        const Frame other = patient_frame(3.0, 7.5, 500);
        picture(renderer, other);
        CHECK(picture(renderer, frame).rgb == first.rgb);
        for (std::size_t i = 0; i < frame.membranes[0].position.size(); i += 40) {
            frame.membranes[0].position[i] = Vec3::Constant(std::nan(""));
        }
        CHECK(picture(renderer, frame).rgb.size() == first.rgb.size());
    }
}
