// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/clock.hpp"
#include "render/renderer.hpp"
#include "scenes/pictures.hpp"

namespace rhexis::bench {
namespace {

using namespace rhexis::testing;

constexpr int shown_width = 640;  ///< of the window in which pictures are compared
constexpr int shown_height = 480;
constexpr int finer = 3;  ///< times as many pixels each way has what they are compared with

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

nlohmann::json run_picture_chart(const BenchOptions& options) {
    const int width = finer * shown_width;
    Result<Renderer> finest = Renderer::create(width, finer * shown_height);
    if (!finest.ok()) {
        return nlohmann::json::array({{{"name", "picture_chart"}, {"skipped", finest.error().text()}}});
    }
    const Frame frame = sculpted_frame(3.0, 0.2, true);
    const Camera camera = microscope_camera(frame);
    const int last = options.quick ? 4 : 4 + 2 * options.repeats;
    const Pixels truth = averaged(finest.value().draw(moved(frame, last), camera));
    nlohmann::json rows = nlohmann::json::array();
    for (const Light light : {Light::anew, Light::kept}) {
        for (const int columns : {160, 240, 320, 480, 640, 960}) {
            Renderer renderer = std::move(Renderer::create(columns, columns * 3 / 4, light)).value();
            std::vector<double> times;
            Image picture;
            for (int i = 0; i <= last; ++i) {
                const double start = process_cpu_seconds();
                picture = renderer.draw(moved(frame, i), camera);
                if (i >= 3) {  // textures have been painted, light is kept
                    times.push_back(1e3 * (process_cpu_seconds() - start));
                }
            }
            std::sort(times.begin(), times.end());
            rows.push_back({{"name", std::string("picture/") + (light == Light::anew ? "anew " : "kept ") +
                                         std::to_string(columns)},
                            {"pixels", columns * (columns * 3 / 4)},
                            {"cpu_ms", times[times.size() / 2]},
                            {"error", rms_apart(scaled(picture), truth)},
                            {"error_kind", "grey levels, RMS, against a picture three times as fine, averaged"}});
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> picture_cases() {
    return {{"picture_chart",
             "error against CPU ms of a picture that is shown at 640 x 480, by its own size, drawn anew and with kept "
             "light",
             run_picture_chart}};
}

}  // namespace rhexis::bench
