// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a frame, for files or in a window. One renderer per thread.
#pragma once

#include <memory>
#include <vector>

#include "base/result.hpp"
#include "flow/frame.hpp"
#include "render/pass_clock.hpp"

namespace rhexis {

class GlContext;

/// Optical depth along the ray of each pixel, row by row from the top, red, green, blue.
struct OpticalDepth {
    int width = 0;
    int height = 0;
    std::vector<float> tau;  ///< 3 * width * height
};

/// Of a window, pixels from its lower left corner.
struct ScreenArea {
    int left = 0;
    int bottom = 0;
    int width = 0;
    int height = 0;
};

/// What of a picture of an eye serves for the next one.
enum class Light {
    anew,  ///< nothing: a picture does not depend on what came before it
    kept   ///< what does not change of the eye's front: it costs less, and looks the same but for rounding
};

/// Pictures for two eyes; what lies at the camera's target lies in the screen, what is nearer before it.
enum class Stereo {
    off,
    side_by_side,  ///< the left eye's on the left, each half as wide
    anaglyph       ///< red for the left eye, cyan for the right one
};

/// Between the eyes of a microscope, at its objective [mm]. 22 to 24 mm are usual.
inline constexpr double stereo_base_mm = 24.0;

class Renderer {
public:
    /// EGL surfaceless context; the error says what is missing when there is none.
    static Result<Renderer> create(int width, int height, Light light = Light::anew);
    /// Draws in the context that is current on this thread, a window's, which outlives it. Light is kept.
    static Result<Renderer> create_in_window(int width, int height);
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    /// The microscope view: eye, instruments, semi-opaque lens over the red reflex; bare bodies when frame.eye is null.
    Image draw(const Frame& frame, const Camera& camera);
    /// What each pass of this picture costs; the picture itself is dropped.
    std::vector<PassCost> costs(const Frame& frame, const Camera& camera);
    /// The same onto the window, scaled to a rectangle of it.
    void show(const Frame& frame, const Camera& camera, const ScreenArea& area, Stereo stereo = Stereo::off);
    /// A matte card of this reflectance (0 to 1) in the place of the frame's eye: what lamp and film make of it. By
    /// this their constants are told.
    Image photograph_card(double reflectance, const Frame& frame, const Camera& camera);
    /// The lens part alone.
    OpticalDepth optical_depth(const Frame& frame, const Camera& camera);

private:
    struct Parts;
    static Result<Renderer> create_with(Result<GlContext> context, int width, int height, Light light);
    explicit Renderer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

/// Camera of the operating microscope over this eye (or framing the bodies of a bare scene).
Camera microscope_camera(const Frame& frame);
/// The same of an eye, from what it depends on.
Camera microscope_camera(const EyeAnatomy& eye, const WorldModel& world,
                         const std::optional<MicroscopeState>& microscope);

/// A camera of the room, where the frame of an eye that has rolled has it.
Camera camera_in_eye(const Camera& room, const GlobeModel& model, const GlobeState& globe);

}  // namespace rhexis
