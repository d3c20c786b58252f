// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/eye_textures.hpp"

#include <array>

#include "render/vessels.hpp"

namespace rhexis {

namespace {

constexpr std::uint64_t vessel_seed = 20;
constexpr int sclera_size = 1536;
constexpr int relief_size = 1024;

/// A texture painted by the program in use; `source`: what it reads on unit 0.
Texture paint_texture(int width, int height, GLenum wrap, const Texture* source = nullptr) {
    Target target = make_single_target(width, height, GL_RGBA8, GL_LINEAR_MIPMAP_LINEAR, wrap);
    target.bind();
    if (source != nullptr) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, *source->name);
    }
    cover_target();
    Texture texture = std::move(target.colours[0]);
    glBindTexture(GL_TEXTURE_2D, *texture.name);
    glGenerateMipmap(GL_TEXTURE_2D);
    return texture;
}

}  // namespace

Result<Texture> paint_detail() {
    const Result<Program> program = Program::build({"fullscreen.vert"}, {"noise.glsl", "detail_texture.frag"});
    if (!program.ok()) {
        return program.error();
    }
    program.value().use();
    return paint_texture(512, 512, GL_REPEAT);
}

Result<EyePainter> EyePainter::create() {
    Result<Program> iris = Program::build({"fullscreen.vert"}, {"noise.glsl", "iris_texture.frag"});
    Result<Program> vessels = Program::build({"vessel.vert"}, {"vessel.frag"});
    Result<Program> sclera = Program::build({"fullscreen.vert"}, {"noise.glsl", "sclera_texture.frag"});
    Result<Program> relief = Program::build({"fullscreen.vert"}, {"noise.glsl", "sclera_relief.frag"});
    for (const Result<Program>* program : {&iris, &vessels, &sclera, &relief}) {
        if (!program->ok()) {
            return program->error();
        }
    }
    return EyePainter(std::move(iris).value(), std::move(vessels).value(), std::move(sclera).value(),
                      std::move(relief).value());
}

Texture EyePainter::draw_vessels(const EyeAnatomy& eye) const {
    Target target = make_single_target(2 * sclera_size, 2 * sclera_size, GL_RGBA8, GL_LINEAR);
    target.bind();
    const std::array<GLfloat, 4> none{};
    glClearBufferfv(GL_COLOR, 0, none.data());
    vessels_.use();
    vessels_.set("half_extent", sclera_extent_mm);
    VertexStream ribbons({2, 4});
    ribbons.send(vessel_ribbons(eye.limbus_radius, sclera_extent_mm - 0.5, vessel_seed));
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    ribbons.draw();
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    return std::move(target.colours[0]);
}

EyeTextures EyePainter::paint(const EyeAnatomy& eye) const {
    EyeTextures textures;
    if (eye.has_iris) {
        iris_.use();
        textures.iris = paint_texture(2048, 256, GL_REPEAT);
    }
    if (!eye.has_cornea) {
        return textures;
    }
    const Texture vessels = draw_vessels(eye);
    sclera_.use();
    sclera_.set("half_extent", sclera_extent_mm);
    sclera_.set("limbus_radius", eye.limbus_radius);
    textures.sclera = paint_texture(sclera_size, sclera_size, GL_CLAMP_TO_EDGE, &vessels);
    relief_.use();
    relief_.set("half_extent", sclera_extent_mm);
    relief_.set("limbus_radius", eye.limbus_radius);
    textures.relief = paint_texture(relief_size, relief_size, GL_CLAMP_TO_EDGE);
    return textures;
}

}  // namespace rhexis
