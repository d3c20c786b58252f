// SPDX-License-Identifier: GPL-3.0-or-later
// The foldable lens in the picture: its surface, and what it does to the light.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/index.hpp"
#include "eye/implant.hpp"
#include "make_renderer.hpp"
#include "render/renderer.hpp"
#include "render/shell_surface.hpp"
#include "render/view.hpp"
#include "scenes/implant_pictures.hpp"
#include "scenes/shell_problems.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

constexpr int width = 320;
constexpr int height = 240;

/// Six times the signed volume within a closed surface.
double six_volumes(const ShellSurface& surface, const std::vector<Vec3>& x) {
    double sum = 0.0;
    for (const std::array<int, 3>& t : surface.triangles()) {
        sum += x[at(t[0])].dot(x[at(t[1])].cross(x[at(t[2])]));
    }
    return sum;
}

Frame without_implant(const Frame& frame) {
    Frame other = frame;
    other.shells.clear();
    return other;
}

int change_at(const Image& a, const Image& b, int x, int y) {
    const std::size_t i = 3 * (at(y) * width + at(x));
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        most = std::max(most, std::abs(a.rgb[i + c] - b.rgb[i + c]));
    }
    return most;
}

/// Greatest change within two pixels of a place in the eye.
int change_near(const Image& a, const Image& b, const View& view, const Vec3& place) {
    const Vec2 centre = pixel_of(view, place);
    int most = 0;
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            most = std::max(most, change_at(a, b, static_cast<int>(centre.x()) + x, static_cast<int>(centre.y()) + y));
        }
    }
    return most;
}

}  // namespace

TEST_SUITE("shell surface") {
    TEST_CASE("it is closed, its outside in front, and holds the shell's volume") {
        const ShellModel model = acrylic_implant();
        const ShellSurface surface(model);
        for (const SheetEdge& edge : surface.edges()) {
            CHECK(edge.right >= 0);
        }
        double volume = 0.0;
        for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
            const std::array<int, 3>& n = model.mesh.triangles[t];
            volume += model.thickness[t] *
                      triangle_area(model.mesh.nodes[at(n[0])], model.mesh.nodes[at(n[1])], model.mesh.nodes[at(n[2])]);
        }
        CHECK(six_volumes(surface, surface.rest()) / 6.0 == doctest::Approx(volume).epsilon(0.02));
    }

    TEST_CASE("turned as a whole it is the same, and a strip bent to a half circle of 12 chords is round") {
        const auto map = [](double s, double t) { return Vec3(12.0 * s, t, 0.0); };
        const ShellModel model = uniform_shell("strip", scenes::grid_mesh(12, 1, scenes::GridCut::alternate, map), 0.2);
        const ShellSurface surface(model);
        ShellState bent = rest_state(model);
        const double radius = 12.0 / M_PI;
        for (std::size_t n = 0; n < bent.position.size(); ++n) {
            const double angle = model.mesh.nodes[n].x() / radius;
            bent.position[n] = {radius * std::sin(angle), model.mesh.nodes[n].y(), radius * (1.0 - std::cos(angle))};
            bent.rotation[n] = Quat(Eigen::AngleAxisd(-angle, Vec3::UnitY()));
        }
        const std::vector<Vec3> x = surface.places(bent);
        const std::size_t half = x.size() / 2;
        for (std::size_t n = 0; n < half; ++n) {
            const auto from_axis = [&](const Vec3& p) { return std::hypot(p.x(), p.z() - radius); };
            // the chord's middle would lie 0.033 inside
            CHECK(from_axis(x[n]) == doctest::Approx(radius - 0.1).epsilon(0.0005));
            CHECK(from_axis(x[half + n]) == doctest::Approx(radius + 0.1).epsilon(0.0005));
        }
        const Quat turn(Eigen::AngleAxisd(1.2, Vec3(1.0, 2.0, -0.5).normalized()));
        ShellState turned = bent;
        for (std::size_t n = 0; n < turned.position.size(); ++n) {
            turned.position[n] = turn * bent.position[n];
            turned.rotation[n] = turn * bent.rotation[n];
        }
        const std::vector<Vec3> elsewhere = surface.places(turned);
        for (std::size_t n = 0; n < x.size(); ++n) {
            CHECK((elsewhere[n] - turn * x[n]).norm() < 1e-12);
        }
    }
}

TEST_SUITE("implant picture") {
    TEST_CASE("it shows by its edge, and hardly between, and not outside the pupil") {
        Renderer renderer = make_renderer(width, height);
        const Frame frame = implant_frame();
        const View view = view_through_cornea(microscope_camera(frame), width, height, *frame.eye);
        const Image with = renderer.draw(frame, microscope_camera(frame));
        const Image without = renderer.draw(without_implant(frame), microscope_camera(frame));
        for (const Vec3& edge : {Vec3(-3.0, 0.0, 0.0), Vec3(0.0, -3.0, 0.0), Vec3(2.1, -2.1, 0.0)}) {
            CHECK(change_near(with, without, view, edge) > 25);
        }
        CHECK(change_near(with, without, view, Vec3(-1.8, -0.9, 0.0)) < 15);
        CHECK(change_near(with, without, view, Vec3(-1.2, 0.3, 0.0)) < 15);
        int outside = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const bool corner = (x < width / 8 || x > 7 * width / 8) && (y < height / 8 || y > 7 * height / 8);
                outside = std::max(outside, corner ? change_at(with, without, x, y) : 0);
            }
        }
        CHECK(outside == 0);
    }

    TEST_CASE("in an injector that has not come into the eye it does not show") {
        Frame frame = implant_frame();
        frame.shells[0].loaded = true;
        Renderer renderer = make_renderer(width, height);
        const Camera camera = microscope_camera(frame);
        CHECK(renderer.draw(frame, camera).rgb == renderer.draw(without_implant(frame), camera).rgb);
    }

    TEST_CASE("folded it is another picture, the same pixels come twice, and numbers that ran away do no harm") {
        Renderer renderer = make_renderer(width, height);
        Frame frame = implant_frame();
        const Image flat = renderer.draw(frame, microscope_camera(frame));
        CHECK(renderer.draw(frame, microscope_camera(frame)).rgb == flat.rgb);
        Frame folded = frame;
        fold(folded, 2e4);
        CHECK(renderer.draw(folded, microscope_camera(folded)).rgb != flat.rgb);
        CHECK(renderer.draw(frame, microscope_camera(frame)).rgb == flat.rgb);
        for (std::size_t i = 0; i < frame.shells[0].position.size(); i += 40) {
            frame.shells[0].position[i] = Vec3::Constant(std::nan(""));
        }
        CHECK(renderer.draw(frame, microscope_camera(frame)).rgb.size() == flat.rgb.size());
        Frame bare = folded;
        bare.eye = nullptr;
        Frame empty = without_implant(bare);
        CHECK(renderer.draw(bare, microscope_camera(bare)).rgb != renderer.draw(empty, microscope_camera(bare)).rgb);
    }
}
