// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a frame, without a window. One renderer per thread.
#pragma once

#include <memory>
#include <vector>

#include "base/result.hpp"
#include "flow/frame.hpp"

namespace rhexis {

/// Optical depth along the ray of each pixel, row by row from the top, red, green, blue.
struct OpticalDepth {
    int width = 0;
    int height = 0;
    std::vector<float> tau;  ///< 3 * width * height
};

class Renderer {
public:
    /// EGL surfaceless context; the error says what is missing when there is none.
    static Result<Renderer> create(int width, int height);
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    /// The microscope view: eye, instruments, semi-opaque lens over the red reflex; bare bodies when frame.eye is null.
    Image draw(const Frame& frame, const Camera& camera);
    /// The lens part alone.
    OpticalDepth optical_depth(const Frame& frame, const Camera& camera);

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

/// Camera of the operating microscope over this eye (or framing the bodies of a bare scene).
Camera microscope_camera(const Frame& frame);

}  // namespace rhexis
