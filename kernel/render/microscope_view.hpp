// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of an eye: its surfaces, the lens by its optical depth, the instruments, light and lamps put together.
#pragma once

#include <optional>

#include "render/depth_pass.hpp"
#include "render/eye_textures.hpp"
#include "render/lens_front.hpp"
#include "render/tool_layer.hpp"

namespace rhexis {

class MicroscopeView {
public:
    static Result<MicroscopeView> create(int width, int height);

    /// frame.eye is not null; depth has drawn this frame through the same `inner` view. The result lies in picture().
    /// detail: repeating noise.
    void draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools, const View& outer,
              const View& inner, const DepthPass& depth, const Texture& detail);

    [[nodiscard]] const Target& picture() const { return picture_; }  ///< RGBA8

private:
    MicroscopeView(Program light, Program compose, EyePainter painter, LensFront front, int width, int height);
    void gather_light(const Frame& frame, const View& inner, const DepthPass& depth);
    void compose(const Frame& frame, const View& inner, const DepthPass& depth, const Texture& detail);

    Program light_program_;
    Program compose_program_;
    EyePainter eye_painter_;
    LensFront front_;
    ToolLayer inside_;
    ToolLayer outside_;
    Target light_;  ///< one pixel
    Target picture_;
    std::optional<EyeTextures> textures_;
    double painted_limbus_ = 0.0;  ///< that the textures were made for
};

}  // namespace rhexis
