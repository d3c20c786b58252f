// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "base/clock.hpp"
#include "bench/charts/models.hpp"
#include "render/renderer.hpp"
#include "scenes/pictures.hpp"

namespace rhexis::bench {
namespace {

using namespace rhexis::testing;

constexpr int shown_width = 640;  ///< of the window in which pictures are compared
constexpr int shown_height = 480;
constexpr int finer = 3;  ///< times as many pixels each way has what they are compared with
constexpr int last_picture = 14;
constexpr int first_timed = 3;  ///< textures have been painted, light is kept

/// Linear light that a value from 0 to 255 stands for. Sizes are changed in light.
double light_of(double value) { return std::pow(value / 255.0, 2.2); }
double value_of(double light) { return 255.0 * std::pow(std::max(light, 0.0), 1.0 / 2.2); }

using Pixels = std::vector<double>;  ///< values of the window's pixels, red, green, blue

/// Means of squares of pixels.
Pixels averaged(const Image& image) {
    Pixels small;
    for (int y = 0; y < shown_height; ++y) {
        for (int x = 0; x < shown_width; ++x) {
            for (int c = 0; c < 3; ++c) {
                double sum = 0.0;
                for (int i = 0; i < finer * finer; ++i) {
                    const std::size_t at = static_cast<std::size_t>(finer * y + i / finer) * image.width +
                                           static_cast<std::size_t>(finer * x + i % finer);
                    sum += light_of(image.rgb[3 * at + c]);
                }
                small.push_back(value_of(sum / (finer * finer)));
            }
        }
    }
    return small;
}

/// As a window scales it: between the nearest four pixels.
Pixels scaled(const Image& image) {
    Pixels large;
    for (int y = 0; y < shown_height; ++y) {
        for (int x = 0; x < shown_width; ++x) {
            const double u = std::clamp((x + 0.5) * image.width / shown_width - 0.5, 0.0, image.width - 1.0);
            const double v = std::clamp((y + 0.5) * image.height / shown_height - 0.5, 0.0, image.height - 1.0);
            const int left = std::min(static_cast<int>(u), image.width - 2);
            const int top = std::min(static_cast<int>(v), image.height - 2);
            const auto pixel = [&](int dx, int dy, int c) {
                return image.rgb[3 * (static_cast<std::size_t>(top + dy) * image.width + left + dx) + c];
            };
            for (int c = 0; c < 3; ++c) {
                const double low = std::lerp(pixel(0, 0, c), pixel(1, 0, c), u - left);
                const double high = std::lerp(pixel(0, 1, c), pixel(1, 1, c), u - left);
                large.push_back(std::lerp(low, high, v - top));
            }
        }
    }
    return large;
}

double rms_apart(const Pixels& a, const Pixels& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Instruments move a little from picture to picture, as a hand does.
Frame moved(Frame frame, int picture) {
    frame.time_s = picture / 30.0;
    for (ToolState& tool : frame.tools) {
        tool.pose.position.x() += 0.002 * picture;
    }
    return frame;
}

ChartPoint point_of_size(Light light, int columns, const Frame& frame, const Camera& camera, const Pixels& truth) {
    Renderer renderer = std::move(Renderer::create(columns, columns * 3 / 4, light)).value();
    std::vector<double> times;
    Image picture;
    for (int i = 0; i <= last_picture; ++i) {
        const double start = process_cpu_seconds();
        picture = renderer.draw(moved(frame, i), camera);
        if (i >= first_timed) {
            times.push_back(process_cpu_seconds() - start);
        }
    }
    std::sort(times.begin(), times.end());
    const bool kept = light == Light::kept;
    char setting[32];
    std::snprintf(setting, sizeof setting, "%d x %d", columns, columns * 3 / 4);
    return point_of(kept ? "kernel: light kept" : "kernel: all drawn anew", setting, kept && columns == shown_width,
                    rms_apart(scaled(picture), truth) / 255.0, times[times.size() / 2]);
}

std::vector<ChartPoint> measure_picture(const ChartOptions& options) {
    Result<Renderer> finest = Renderer::create(finer * shown_width, finer * shown_height);
    if (!finest.ok()) {
        ChartPoint point = point_of("kernel: light kept", "640 x 480", true, 0.0, 0.0);
        point.failure = finest.error().text();
        return {point};
    }
    const Frame frame = sculpted_frame(3.0, 0.2, true);
    const Camera camera = microscope_camera(frame);
    const Pixels truth = averaged(finest.value().draw(moved(frame, last_picture), camera));
    std::vector<ChartPoint> points;
    for (const Light light : {Light::kept, Light::anew}) {
        for (const int columns : {160, 240, 320, 480, 640, 960}) {
            if (!options.only_default || (light == Light::kept && columns == shown_width)) {
                points.push_back(point_of_size(light, columns, frame, camera, truth));
            }
        }
    }
    return points;
}

}  // namespace

Chart chart_picture() {
    return {"picture",
            "A picture of a groove with moving instruments, shown at 640 x 480, by the size it is drawn in",
            "CPU seconds for one picture",
            "grey levels, rms, as a share of white",
            "our picture of 1920 x 1440, averaged: what lies there is what it draws (docs/picture.md)",
            false,
            measure_picture};
}

}  // namespace rhexis::bench
