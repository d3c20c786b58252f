// SPDX-License-Identifier: GPL-3.0-or-later
// light -> image: noise, fixed pattern and rounding of a camera's sensor.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracking/spot.hpp"
#include "tracking/synthetic/true_camera.hpp"

namespace rhexis::tracking::synthetic {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels{};

    [[nodiscard]] GreyImage view() const { return {pixels.data(), width, height, width}; }
};

/// A part of an image [pixels]: columns from left up to right, without it; lines likewise.
struct Window {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    [[nodiscard]] int width() const { return right - left; }
    [[nodiscard]] int height() const { return bottom - top; }
    [[nodiscard]] bool empty() const { return right <= left || bottom <= top; }
};

/// What both share: all of the first within an image of this size.
Window within(const Window& window, int width, int height);

/// What is the same in all images of one sensor: fixed pattern, hot pixels, and a field of 2^20 normal deviates. Each
/// line of each image takes its noise from there, beginning at a place that is drawn for it: deviates are used again,
/// but two images have the same noise at a pixel only by chance.
class SensorPattern {
public:
    SensorPattern(const TrueCamera& camera, std::uint64_t seed);

    /// Black level with fixed pattern and hot pixels [1/64 DN], and half a DN for rounding; line by line.
    [[nodiscard]] std::span<const std::int16_t> dark() const { return dark_; }
    /// Normal deviates, times 4096. A line's begin at any place from 0 to beginnings() - 1.
    [[nodiscard]] std::span<const std::int16_t> deviates() const { return deviates_; }
    [[nodiscard]] int beginnings() const { return beginnings_; }

private:
    std::vector<std::int16_t> dark_{};
    std::vector<std::int16_t> deviates_{};
    int beginnings_ = 0;
};

/// Light as it falls on a sensor [DN], and where it is not zero.
struct LightField {
    int width = 0;
    int height = 0;
    std::vector<float> light{};
    std::vector<Window> windows{};

    /// Dark; of this size.
    void clear(int new_width, int new_height);
};

/// Shot noise, which is as wide as the root of the light, read noise, response, rounding to 8 bits. The same image
/// for the same seed.
void expose(const Sensor& sensor, const SensorPattern& pattern, const LightField& field, double ambient,
            std::uint64_t image_seed, Image& image);

}  // namespace rhexis::tracking::synthetic
