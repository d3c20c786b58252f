// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>

#include "render/depth_raster.hpp"

using namespace rhexis;

namespace {

constexpr int size = 32;

/// One pixel is one mm at the target; pixel centres lie at half-integers.
View view_of_squares() {
    Camera camera;
    camera.field_mm = size;
    return view_in_air(camera, size, size);
}

SignedFace face(const Vec3& a, const Vec3& b, const Vec3& c) { return {{a, b, c}, Eigen::Vector3f(1.0F, 2.0F, 4.0F)}; }

}  // namespace

TEST_CASE("Triangles that share edges through pixel centres cover each pixel once") {
    DepthRaster raster(size, size);
    const View view = view_of_squares();
    raster.look(view, Vec3(0.0, 0.0, 1.0));
    raster.clear_stop(whole(view));
    raster.clear_sum(whole(view), 1);
    // A fan around a pixel's centre; its outer corners lie on centres, too. All at depth 1.
    const Vec3 middle(0.5, 0.5, 0.0);
    const std::array<Vec3, 4> rim{Vec3(-7.5, -7.5, 0), Vec3(8.5, -7.5, 0), Vec3(8.5, 8.5, 0), Vec3(-7.5, 8.5, 0)};
    FaceStream faces;
    for (int i = 0; i < 4; ++i) {
        faces.push_back(face(middle, rim[i], rim[(i + 1) % 4]));
    }
    raster.add(faces, whole(view));
    int covered = 0;
    for (float sum : raster.sum()) {
        CHECK((sum == 0.0F || std::abs(sum + 1.0F) < 1e-5F));
        covered += sum != 0.0F;
    }
    CHECK(covered == 256);
}

TEST_CASE("A line stops at the nearest opaque triangle, in one channel and in three") {
    DepthRaster raster(size, size);
    const View view = view_of_squares();
    raster.look(view, Vec3::Zero());
    const FaceStream back{face(Vec3(-40, -40, -3), Vec3(-40, 40, -3), Vec3(40, -40, -3))};
    const PixelRect all = whole(view);
    const std::size_t pixel = 4 * size + 4;
    for (int channels : {1, 3}) {
        raster.clear_stop(all);
        raster.clear_sum(all, channels);
        raster.stop_at({Vec3(-40, -40, -2), Vec3(40, -40, -2), Vec3(-40, 40, -2)}, all);
        raster.stop_at({Vec3(-40, -40, -1), Vec3(40, -40, -1), Vec3(-40, 40, -1)}, all);
        raster.stop_at({Vec3(-40, -40, -2), Vec3(40, -40, -2), Vec3(-40, 40, -2)}, all);
        raster.add(back, all);
        CHECK(raster.stop()[pixel] == doctest::Approx(1.0));
        for (int c = 0; c < channels; ++c) {
            CHECK(raster.sum()[channels * pixel + c] == doctest::Approx(1 << c));
        }
    }
    CHECK(raster.stop().back() == no_stop);
}

TEST_CASE("Only what lies in the area is touched, and what reaches behind the camera is cut off") {
    DepthRaster raster(size, size);
    const View view = view_of_squares();
    raster.look(view, Vec3::Zero());
    const PixelRect area{3, 5, 7, 2};
    raster.clear_stop(whole(view));
    // A strip that passes under the picture's middle and on past the camera at z = 200.
    raster.stop_at({Vec3(-900, 0, -1), Vec3(900, 0, -1), Vec3(0, -900, 900)}, area);
    int reached = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const bool inside = x >= 3 && x < 10 && y >= 5 && y < 7;
            CHECK((raster.stop()[y * size + x] != no_stop) == inside);
            reached += inside;
        }
    }
    CHECK(reached == 14);
}
