// SPDX-License-Identifier: GPL-3.0-or-later
// What the optics of a microscope do to a sharp picture: depth of field, the round stop, the lamp.
#pragma once

#include "flow/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/view.hpp"

namespace rhexis {

/// What of a picture the eyepiece needs to know. All of one size.
struct EyepieceLayers {
    const Texture& picture;      ///< with room for smaller copies (mipmaps)
    const Texture& inner_tools;  ///< alpha: covered
    const Texture& outer_tools;
    const Texture& front;  ///< see LensFront::surface
    Vec3 reference = Vec3::Zero();
};

/// Of a picture for red and cyan glasses, the colours of one eye.
enum class EyeColours { all, red, cyan };

class Eyepiece {
public:
    static Result<Eyepiece> create(int width, int height);

    /// Into the framebuffer and viewport that are set. camera, views: in the eye's frame.
    void look(const EyepieceLayers& layers, const Frame& frame, const Camera& camera, const View& outer,
              const View& inner, EyeColours colours = EyeColours::all);

    /// To look into, for a picture that is read back.
    [[nodiscard]] const Target& target() const { return target_; }

private:
    Eyepiece(ProgramVariants programs, int width, int height)
        : programs_(std::move(programs)), target_(make_single_target(width, height, GL_RGBA8, GL_NEAREST)) {}

    ProgramVariants programs_;
    Target target_;
};

}  // namespace rhexis
