// SPDX-License-Identifier: GPL-3.0-or-later
// What the optics of a microscope do to a sharp picture: depth of field, the round stop, the lamp.
#pragma once

#include "flow/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/smaller_copies.hpp"
#include "render/tile_mask.hpp"
#include "render/view.hpp"

namespace rhexis {

/// What of a picture the eyepiece needs to know. All of one size.
struct EyepieceLayers {
    const Texture& picture;      ///< filtered with its smaller copies (mipmaps)
    const Texture& inner_tools;  ///< alpha: covered
    const Texture& outer_tools;
    const Texture& front;  ///< see LensFront::surface
    Vec3 reference = Vec3::Zero();
    const TileMask& tools;      ///< where instruments are
    const TileMask& painted;    ///< what has changed since the picture before
    const TileMask& disturbed;  ///< of that, by instruments and their shadows
};

/// Of a picture for red and cyan glasses, the colours of one eye.
enum class EyeColours { all, red, cyan };

class Eyepiece {
public:
    static Result<Eyepiece> create(int width, int height);

    /// What has changed since the last look, which went into the same target; for two eyes that share one, each in its
    /// colours. camera, views: in the eye's frame.
    void look(const EyepieceLayers& layers, const Frame& frame, const Camera& camera, const View& outer,
              const View& inner, const Target& into, EyeColours colours);

    [[nodiscard]] const Target& target() const { return target_; }

private:
    Eyepiece(ProgramVariants programs, SmallerCopies smaller, int width, int height);
    void set_all(const Program& program, const EyepieceLayers& layers, const Frame& frame, const Camera& camera,
                 EyeColours colours) const;
    bool is_same(Program& program, const EyepieceLayers& layers, const Frame& frame, const Camera& camera,
                 EyeColours colours);

    ProgramVariants programs_;
    SmallerCopies smaller_;
    Target target_;
    TileMask changed_;
    VertexStream rectangles_;
    std::vector<unsigned char> parameters_;  ///< of the last look
    std::vector<unsigned char> now_;
};

}  // namespace rhexis
