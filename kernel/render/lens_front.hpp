// SPDX-License-Identifier: GPL-3.0-or-later
// The first surface of what is left of the bodies, for relief and texture.
#pragma once

#include <optional>

#include "flow/frame.hpp"
#include "render/drawn_from.hpp"
#include "render/gl_objects.hpp"

namespace rhexis {

class LensFront {
public:
    /// keeps: from picture to picture, while tissue moves by less than is seen.
    static Result<LensFront> create(int width, int height, bool keeps);

    /// Depths are measured as in DepthPass, from the plane through `reference`.
    /// Within `area`; outside of it there is nothing.
    void draw(const Frame& frame, const View& view, const Vec3& reference, const PixelRect& area);

    /// RGBA32F: depth (beyond 1000: nothing there), and where that tissue lay at rest.
    [[nodiscard]] const Texture& surface() const { return front_.colours[0]; }
    /// RGBA16F, half size: of what is smoothed, the unit normal's part sideways and upwards, how hollow it is, and 1
    /// where there is a surface here and around.
    [[nodiscard]] const Texture& relief() const { return slopes_.colours[0]; }

private:
    LensFront(Program front, Program blur, Program slopes, int width, int height, bool keeps);
    [[nodiscard]] bool is_still(const DrawnFrom& from) const;
    void collect(const Frame& frame);
    void clear_beyond(const PixelRect& area);
    void smooth(double pixel_mm);

    Program front_program_;
    Program blur_program_;
    Program slopes_program_;
    Target front_;
    Target half_;
    Target smooth_;  ///< depth over a short and a long way
    Target slopes_;
    bool keeps_;
    std::optional<DrawnFrom> drawn_;  ///< none: it may hold anything
    std::vector<float> drawn_stream_;
    VertexStream vertices_;
    std::vector<float> stream_;
    std::vector<Vec3> fine_;
    std::vector<Vec3> rest_;
};

}  // namespace rhexis
