// SPDX-License-Identifier: GPL-3.0-or-later
// Twelve statistics of a picture, and what 25 frames of real operations show of each. docs/picture.md, "The look".
#pragma once

#include <array>
#include <string>
#include <vector>

#include "flow/frame.hpp"

namespace rhexis::testing {

/// Luma is 0.2126 R + 0.7152 G + 0.0722 B as screens show it, 0 to 255.
struct Statistic {
    const char* name;
    double least;  ///< mean less two standard deviations of the real frames, within what was seen
    double most;
};

inline constexpr std::array<Statistic, 12> wanted_statistics = {{
    {"luma_median", 31.0, 68.0},
    {"luma_mean", 67.0, 90.0},
    {"luma_sd", 55.0, 71.0},
    {"luma_p5", 14.0, 27.0},
    {"luma_p95", 187.0, 238.0},
    {"darker_than_25", 0.02, 0.41},
    {"brighter_than_245", 0.0, 0.039},
    {"linear_sd_over_mean", 1.2, 1.8},
    {"gradient", 5.2, 10.0},
    {"red_over_green", 0.97, 1.23},
    {"blue_over_green", 0.65, 0.91},
    {"saturation", 0.21, 0.59},
}};

using Statistics = std::array<double, wanted_statistics.size()>;

/// Of a picture that is averaged down to 176 pixels across first (smaller ones stay as they are).
Statistics statistics_of(const Image& image);

/// How many lie within what is wanted.
int count_within(const Statistics& values);

/// "luma_sd 45 (wanted 55 to 71), ...": those that do not.
std::string outside_of(const Statistics& values);

/// The square inscribed in a round field as high as the picture: what a trainee's microscope shows for certain.
Image square_of_field(const Image& image);

/// A part of a picture, from its top left.
Image part_of(const Image& image, int left, int top, int width, int height);

}  // namespace rhexis::testing
