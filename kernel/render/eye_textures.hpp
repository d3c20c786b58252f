// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of an eye as textures, painted once: iris, sclera with its vessels, and noise for everything else.
#pragma once

#include "flow/eye_model.hpp"
#include "render/gl_objects.hpp"

namespace rhexis {

struct EyeTextures {
    Texture iris;    ///< unrolled: around, and from the edge of the pupil to the root
    Texture sclera;  ///< from above, over sclera_extent_mm each way
    Texture relief;  ///< of the same square: slopes and wetness
};

inline constexpr double sclera_extent_mm = 11.0;  ///< half the side of the square that the sclera's texture covers

class EyePainter {
public:
    static Result<EyePainter> create();

    /// About 0.7 s on one core without a GPU. Empty for what the eye has not.
    [[nodiscard]] EyeTextures paint(const EyeAnatomy& eye) const;

private:
    EyePainter(Program iris, Program vessels, Program sclera, Program relief)
        : iris_(std::move(iris)),
          vessels_(std::move(vessels)),
          sclera_(std::move(sclera)),
          relief_(std::move(relief)) {}
    [[nodiscard]] Texture draw_vessels(const EyeAnatomy& eye) const;

    Program iris_;
    Program vessels_;
    Program sclera_;
    Program relief_;
};

/// Repeating noise, for every surface.
Result<Texture> paint_detail();

}  // namespace rhexis
