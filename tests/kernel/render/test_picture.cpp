// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

#include "make_renderer.hpp"
#include "render/renderer.hpp"
#include "scenes/pictures.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

constexpr int width = 160;
constexpr int height = 120;

/// A coarse mesh is enough for what a picture shows.
Frame eye_frame(double grade) { return patient_frame(grade, 7.5, 1500); }

/// Mean of a channel over the pixels within `reach` of a place (shares of the picture, from the top left).
double mean_around(const Image& image, double x, double y, double reach_x, double reach_y, int channel) {
    double sum = 0.0;
    int count = 0;
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            if (std::abs((column + 0.5) / image.width - x) < reach_x &&
                std::abs((row + 0.5) / image.height - y) < reach_y) {
                sum += image.rgb[3 * (static_cast<std::size_t>(row) * image.width + column) + channel];
                ++count;
            }
        }
    }
    return sum / std::max(1, count);
}

std::vector<double> ranks(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        result[order[i]] = static_cast<double>(i);
    }
    return result;
}

/// Spearman's rank correlation; values without ties.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const std::vector<double> ra = ranks(a);
    const std::vector<double> rb = ranks(b);
    double squares = 0.0;
    for (std::size_t i = 0; i < ra.size(); ++i) {
        squares += (ra[i] - rb[i]) * (ra[i] - rb[i]);
    }
    const double n = static_cast<double>(ra.size());
    return 1.0 - 6.0 * squares / (n * (n * n - 1.0));
}

}  // namespace

TEST_CASE("The reflex in the pupil is more red than green and more green than blue, for every grade") {
    Renderer renderer = make_renderer(width, height);
    for (double grade : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
        const Frame frame = eye_frame(grade);
        const Image image = renderer.draw(frame, microscope_camera(frame));
        const double red = mean_around(image, 0.5, 0.62, 0.10, 0.06, 0);
        const double green = mean_around(image, 0.5, 0.62, 0.10, 0.06, 1);
        const double blue = mean_around(image, 0.5, 0.62, 0.10, 0.06, 2);
        INFO("grade " << grade << ": " << red << " " << green << " " << blue);
        CHECK(red > 1.1 * green);
        CHECK(green > 1.05 * blue);
    }
}

TEST_CASE("A groove brightens as it deepens") {
    Renderer renderer = make_renderer(width, height);
    for (double grade : {3.0, 5.0}) {
        const Frame whole = eye_frame(grade);
        std::vector<double> depths;
        std::vector<double> luminances;
        for (int i = 0; i < 10; ++i) {
            Frame frame = whole;
            const double floor_z = 1.4 - 0.32 * i;
            carve_groove(frame.model->solids[0], frame.solids[0], 0.75, -2.2, 2.2, floor_z);
            const Image image = renderer.draw(frame, microscope_camera(frame));
            depths.push_back(-floor_z);
            luminances.push_back(0.2126 * mean_around(image, 0.5, 0.40, 0.015, 0.03, 0) +
                                 0.7152 * mean_around(image, 0.5, 0.40, 0.015, 0.03, 1) +
                                 0.0722 * mean_around(image, 0.5, 0.40, 0.015, 0.03, 2));
        }
        INFO("grade " << grade << ", luminance " << luminances.front() << " to " << luminances.back());
        CHECK(rank_correlation(depths, luminances) >= 0.95);
        CHECK(luminances.back() > 1.15 * luminances.front());
    }
}

TEST_CASE("Tissues that take no part are not drawn") {
    Renderer renderer = make_renderer(width, height);
    const Frame all = eye_frame(3.0);
    const Camera camera = microscope_camera(all);
    const auto drawn = [&](bool iris, bool cornea) {
        Frame frame = all;
        std::shared_ptr<EyeAnatomy> eye = std::make_shared<EyeAnatomy>(*all.eye);
        eye->has_iris = iris;
        eye->has_cornea = cornea;
        frame.eye = std::move(eye);
        return renderer.draw(frame, camera);
    };
    // Right of the pupil, grey-blue iris; the red reflex where there is none.
    const auto redness = [](const Image& image) {
        return mean_around(image, 0.745, 0.5, 0.01, 0.02, 0) / (1.0 + mean_around(image, 0.745, 0.5, 0.01, 0.02, 2));
    };
    const auto white = [](const Image& image) { return mean_around(image, 0.08, 0.5, 0.04, 0.04, 1); };
    const auto brightest_in_pupil = [](const Image& image) {
        int brightest = 0;
        for (int y = 45; y < 55; ++y) {
            for (int x = 65; x < 95; ++x) {
                brightest = std::max(brightest, int{image.rgb[3 * (y * width + x) + 2]});
            }
        }
        return brightest;
    };
    const Image whole_eye = drawn(true, true);
    const Image without_iris = drawn(false, true);
    const Image without_cornea = drawn(true, false);
    const Image lens_alone = drawn(false, false);
    CHECK(redness(whole_eye) < 1.25);
    CHECK(redness(without_iris) > 1.5);
    CHECK(redness(without_cornea) < 1.25);
    CHECK(redness(lens_alone) > 1.5);
    for (const Image& image : {whole_eye, without_iris}) {
        CHECK(white(image) > 90.0);
        CHECK(brightest_in_pupil(image) > 200);  // the lamps' reflexes in the cornea
    }
    for (const Image& image : {without_cornea, lens_alone}) {
        CHECK(white(image) < 30.0);
        CHECK(brightest_in_pupil(image) < 120);
    }
    CHECK(drawn(true, true).rgb == whole_eye.rgb);
}

TEST_CASE("An eye of which only the front takes part has its lens until it was cut; what shuts a wound shows") {
    Renderer renderer = make_renderer(width, height);
    Frame frame = eye_frame(3.0);
    const Camera camera = microscope_camera(frame);
    const std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>(*frame.model);
    model->solids.clear();
    model->bags.clear();
    frame.model = model;
    frame.solids.clear();
    frame.bags.clear();
    // an old lens keeps blue back
    const auto blue_share = [](const Image& image) {
        return mean_around(image, 0.42, 0.5, 0.03, 0.03, 2) / mean_around(image, 0.42, 0.5, 0.03, 0.03, 1);
    };
    const double with_lens = blue_share(renderer.draw(frame, camera));
    model->wounds.emplace();
    model->wounds->start[main_wound].cut = true;
    frame.wounds.emplace();
    frame.wounds->wounds = model->wounds->start;
    const Image cut = renderer.draw(frame, camera);
    CHECK(blue_share(cut) > 1.2 * with_lens);
    const auto changed = [&](const auto& change) {
        Frame other = frame;
        change(other.wounds->wounds[main_wound]);
        const Image image = renderer.draw(other, camera);
        int pixels = 0;
        for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
            pixels += std::abs(int{image.rgb[i + 1]} - int{cut.rgb[i + 1]}) > 12 ? 1 : 0;
        }
        return pixels;
    };
    CHECK(changed([](Wound& wound) { wound.sutures = 2; }) > 10);
    CHECK(changed([](Wound& wound) { wound.peel = 1.0; }) > 10);
    CHECK(changed([](Wound& wound) { wound.fluid = 1.0; }) > 10);
}

TEST_CASE("A cornea that a shaft bends beside its wound lies in folds there, the more the more it is bent") {
    Renderer renderer = make_renderer(width, height);
    const auto drawn = [&](double deflection_mm) {
        const Frame frame = levered_frame(deflection_mm);
        return renderer.draw(frame, microscope_camera(frame));
    };
    const Image at_rest = drawn(0.0);
    CHECK(drawn(0.09).rgb == at_rest.rgb);
    const auto folded = [&](const Image& image, bool near) {
        int pixels = 0;
        for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
            const bool beside = (i / 3 / width > height / 2) == near;  // the wound is below the middle
            pixels += beside && std::abs(int{image.rgb[i + 1]} - int{at_rest.rgb[i + 1]}) > 4 ? 1 : 0;
        }
        return pixels;
    };
    const Image bent = drawn(0.25);
    const Image more = drawn(0.5);
    CHECK(folded(bent, true) > 20);
    CHECK(folded(bent, false) == 0);
    CHECK(folded(more, true) > 2 * folded(bent, true));
}

TEST_CASE("The same frame gives the same pixels twice, also from a second renderer in between") {
    Frame frame = eye_frame(3.0);
    frame.tools[0].present = true;
    frame.tools[0].pose = hand_pose(Vec3(0.2, 0.5, 1.4), 0.5);
    const Camera camera = microscope_camera(frame);
    Renderer one = make_renderer(width, height);
    const Image first = one.draw(frame, camera);
    const Frame other = frame_of(ball(2.0, 500), Vec3(0.1, 0.2, 0.3), true);
    Renderer two = make_renderer(width, height);
    const Image bare = two.draw(other, microscope_camera(other));
    const Image again = one.draw(frame, camera);
    const Image elsewhere = two.draw(frame, camera);
    CHECK(first.rgb == again.rgb);
    CHECK(first.rgb == elsewhere.rgb);
    CHECK(bare.rgb == two.draw(other, microscope_camera(other)).rgb);
    CHECK(bare.rgb != first.rgb);
}

TEST_CASE("A picture shows the instrument where it is") {
    Frame frame = eye_frame(3.0);
    const Camera camera = microscope_camera(frame);
    Renderer renderer = make_renderer(width, height);
    const Image without = renderer.draw(frame, camera);
    frame.tools[0].present = true;
    frame.tools[0].pose = hand_pose(Vec3(0.0, 0.0, 1.9), 0.5);
    const Image with = renderer.draw(frame, camera);
    int changed_below = 0;
    int changed_above = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel = 3 * (static_cast<std::size_t>(y) * width + x);
            int difference = 0;
            for (int c = 0; c < 3; ++c) {
                difference += std::abs(int{with.rgb[pixel + c]} - int{without.rgb[pixel + c]});
            }
            (y > height / 2 ? changed_below : changed_above) += difference > 60;
        }
    }
    CHECK(changed_below > 400);
    CHECK(changed_above < changed_below / 10);
}

TEST_CASE("Bare bodies are drawn against their background") {
    const Frame frame = frame_of(bar(8, 3, 3, 0.5), Vec3::Zero(), false);
    Renderer renderer = make_renderer(width, height);
    const Image image = renderer.draw(frame, microscope_camera(frame));
    const double middle = mean_around(image, 0.5, 0.5, 0.05, 0.05, 2);
    const double corner = mean_around(image, 0.03, 0.03, 0.03, 0.03, 2);
    CHECK(std::abs(middle - corner) > 30.0);
}

TEST_CASE("Pictures can be as small as one pixel, and absurd sizes are refused") {
    const Frame frame = eye_frame(3.0);
    Result<Renderer> tiny = Renderer::create(1, 1);
    REQUIRE(tiny.ok());
    CHECK(tiny.value().draw(frame, microscope_camera(frame)).rgb.size() == 3);
    CHECK(tiny.value().optical_depth(frame, microscope_camera(frame)).tau.size() == 3);
    for (const auto& [w, h] : {std::pair{0, 10}, {10, 0}, {-5, 5}, {100000, 10}, {10, 2147483647}}) {
        const Result<Renderer> refused = Renderer::create(w, h);
        REQUIRE_FALSE(refused.ok());
        CHECK(refused.error().text().find(std::to_string(w)) != std::string::npos);
    }
}

TEST_CASE("A lens that was removed, or that is not finite, does no harm") {
    Frame frame = eye_frame(3.0);
    Renderer renderer = make_renderer(width, height);
    const Camera camera = microscope_camera(frame);
    for (double& share : frame.solids[0].fraction) {
        share = 0.0;
    }
    CHECK(renderer.draw(frame, camera).rgb.size() == 3 * width * height);
    const OpticalDepth gone = renderer.optical_depth(frame, camera);
    CHECK(*std::max_element(gone.tau.begin(), gone.tau.end()) == 0.0F);
    frame = eye_frame(3.0);
    for (std::size_t i = 0; i < frame.solids[0].position.size(); i += 50) {
        frame.solids[0].position[i] = Vec3::Constant(std::nan(""));
    }
    CHECK(renderer.draw(frame, camera).rgb.size() == 3 * width * height);
}

TEST_CASE("in a process without EGL devices, a renderer is refused" * doctest::skip()) {
    const Result<Renderer> refused = Renderer::create(64, 48);
    REQUIRE_FALSE(refused.ok());
    const std::string text = refused.error().text();
    CHECK(text.find("EGL") != std::string::npos);
    CHECK(text.find('\n') == std::string::npos);
}

TEST_CASE("A machine without EGL devices is told so in one line") {
    std::array<char, 4096> path{};
    REQUIRE(readlink("/proc/self/exe", path.data(), path.size() - 1) > 0);
    const std::string command = "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json '" + std::string(path.data()) +
                                "' --no-skip --test-case='in a process without EGL*' > /dev/null 2>&1";
    CHECK(std::system(command.c_str()) == 0);
}
