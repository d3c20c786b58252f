// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that must stay as they are, tile by tile: tests/data/pictures/golden.json, which golden_pictures writes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "render/renderer.hpp"
#include "scenes/implant_pictures.hpp"
#include "scenes/sign_frames.hpp"

namespace rhexis::testing {

struct GoldenFrame {
    std::string name;
    Frame frame;
};

inline constexpr int golden_width = 320;
inline constexpr int golden_height = 240;
inline constexpr int golden_tile = 20;  ///< [pixels]

inline std::vector<GoldenFrame> golden_frames() {
    std::vector<GoldenFrame> list = {{"whole", patient_frame(3.0, 7.5, 1500)},
                                     {"brunescent", patient_frame(5.5, 6.0, 1500)},
                                     {"sculpted", sculpted_frame(3.0, 0.2, true)},
                                     {"implant", implant_frame()},
                                     {"dyed", capsule_frame(3.0, 1.0)},
                                     {"levered", levered_frame(0.45)}};
    for (const Sign& sign : signs()) {
        list.push_back({std::string("sign_") + sign.name, sign.with});
    }
    return list;
}

/// Mean colour of each tile, row by row, 0 to 255.
inline std::vector<std::array<double, 3>> tiles_of(const Image& image) {
    std::vector<std::array<double, 3>> tiles;
    for (int top = 0; top + golden_tile <= image.height; top += golden_tile) {
        for (int left = 0; left + golden_tile <= image.width; left += golden_tile) {
            std::array<double, 3> sum{};
            for (int y = top; y < top + golden_tile; ++y) {
                for (int x = left; x < left + golden_tile; ++x) {
                    for (std::size_t c = 0; c < 3; ++c) {
                        sum[c] += image.rgb[3 * (static_cast<std::size_t>(y) * image.width + x) + c];
                    }
                }
            }
            for (double& value : sum) {
                value /= golden_tile * golden_tile;
            }
            tiles.push_back(sum);
        }
    }
    return tiles;
}

inline Image golden_picture(Renderer& renderer, const GoldenFrame& golden) {
    return renderer.draw(golden.frame, microscope_camera(golden.frame));
}

}  // namespace rhexis::testing
