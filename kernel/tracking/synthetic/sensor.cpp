// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/sensor.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/rng.hpp"

namespace rhexis::tracking::synthetic {
namespace {

constexpr double parts_of_dn = 64.0;
constexpr double parts_of_deviate = 4096.0;
constexpr int deviates_kept = 1 << 20;

std::int16_t to_int16(double value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -32767.0, 32767.0)));
}

void expose_dark(const Sensor& sensor, const SensorPattern& pattern, double ambient, const std::vector<int>& begins,
                 Image& image) {
    const double spread = std::sqrt(sensor.read_noise * sensor.read_noise + ambient / sensor.electrons);
    const std::int32_t scale = to_int16(spread * parts_of_dn * 65536.0 / parts_of_deviate);
    const std::int32_t level = to_int16(ambient * parts_of_dn);
    const std::size_t width = static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height; ++y) {
        const std::int16_t* dark = pattern.dark().data() + static_cast<std::size_t>(y) * width;
        const std::int16_t* deviates = pattern.deviates().data() + begins[static_cast<std::size_t>(y)];
        std::uint8_t* out = image.pixels.data() + static_cast<std::size_t>(y) * width;
        for (std::size_t x = 0; x < width; ++x) {
            const std::int32_t value = (dark[x] + level + ((deviates[x] * scale) >> 16)) >> 6;
            out[x] = static_cast<std::uint8_t>(std::min(255, std::max(0, value)));
        }
    }
}

void expose_window(const Sensor& sensor, const SensorPattern& pattern, const LightField& field, const Window& window,
                   double ambient, const std::vector<int>& begins, Image& image) {
    for (int y = window.top; y < window.bottom; ++y) {
        const std::int16_t* deviates = pattern.deviates().data() + begins[static_cast<std::size_t>(y)];
        for (int x = window.left; x < window.right; ++x) {
            const std::size_t at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
            // the response's own deviate: of a place of the sensor, whatever the image
            const double response =
                1.0 + sensor.response_spread / parts_of_deviate * pattern.deviates()[(at * 7U) % deviates_kept];
            const double light = response * (static_cast<double>(field.light[at]) + ambient);
            const double spread = std::sqrt(sensor.read_noise * sensor.read_noise + light / sensor.electrons);
            const double value = pattern.dark()[at] / parts_of_dn + light + spread / parts_of_deviate * deviates[x];
            image.pixels[at] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
        }
    }
}

}  // namespace

Window within(const Window& window, int width, int height) {
    return {std::max(window.left, 0), std::max(window.top, 0), std::min(window.right, width),
            std::min(window.bottom, height)};
}

SensorPattern::SensorPattern(const TrueCamera& camera, std::uint64_t seed) {
    const std::size_t width = static_cast<std::size_t>(camera.width);
    Rng fixed(seed, "fixed pattern of " + camera.name);
    Rng noise(seed, "noise of " + camera.name);
    beginnings_ = deviates_kept;
    deviates_.resize(deviates_kept + width);
    std::generate(deviates_.begin(), deviates_.end(), [&] { return to_int16(noise.normal() * parts_of_deviate); });
    dark_.resize(width * static_cast<std::size_t>(camera.height));
    const auto begin = static_cast<std::size_t>(fixed.integer(0, deviates_kept - 1));
    for (std::size_t i = 0; i < dark_.size(); ++i) {
        const double off = deviates_[(begin + 3U * i) % deviates_kept] / parts_of_deviate;
        dark_[i] = to_int16((camera.sensor.black + 0.5 + camera.sensor.fixed_pattern * off) * parts_of_dn);
    }
    for (const HotPixel& hot : camera.sensor.hot) {
        RHEXIS_ASSERT(hot.x >= 0 && hot.x < camera.width && hot.y >= 0 && hot.y < camera.height);
        dark_[static_cast<std::size_t>(hot.y) * width + static_cast<std::size_t>(hot.x)] +=
            to_int16(hot.light * parts_of_dn);
    }
}

void LightField::clear(int new_width, int new_height) {
    width = new_width;
    height = new_height;
    light.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F);
    windows.clear();
}

void expose(const Sensor& sensor, const SensorPattern& pattern, const LightField& field, double ambient,
            std::uint64_t image_seed, Image& image) {
    image.width = field.width;
    image.height = field.height;
    image.pixels.resize(field.light.size());
    Rng rng(image_seed, "noise of an image");
    std::vector<int> begins(static_cast<std::size_t>(field.height));
    std::generate(begins.begin(), begins.end(),
                  [&] { return static_cast<int>(rng.integer(0, pattern.beginnings() - 1)); });
    expose_dark(sensor, pattern, ambient, begins, image);
    for (const Window& window : field.windows) {
        expose_window(sensor, pattern, field, window, ambient, begins, image);
    }
}

}  // namespace rhexis::tracking::synthetic
