// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/eyepiece.hpp"

#include <algorithm>
#include <cmath>

#include "flow/corneal_image.hpp"
#include "render/tool_layer.hpp"
#include "render/tool_mesh.hpp"

namespace rhexis {
namespace {

constexpr std::size_t most_tool_ends = 16;
constexpr int most_levels = 12;  ///< of smaller copies: as many as the largest picture has

/// From the lower left.
Vec2 pixel_from_below(const View& view, const Vec3& place) {
    const Vec2 pixel = pixel_of(view, place);
    return {pixel.x(), view.height - pixel.y()};
}

/// Where the parts of each instrument begin and end in the picture, and how high.
void set_tools(const Program& program, const Frame& frame, const View& outer, const View& inner) {
    std::size_t count = 0;
    const auto add = [&](const Vec3& place) {
        const bool inside = (place - cornea_ball(*frame.eye).head<3>()).norm() < cornea_ball(*frame.eye).w();
        const std::string name = "tool_ends[" + std::to_string(count++) + "]";
        Eigen::Vector4d end;
        end << pixel_from_below(inside ? inner : outer, place), place.z(), 1.0;
        program.set(name.c_str(), end);
    };
    for (std::size_t i = 0; i < frame.tools.size(); ++i) {
        if (!frame.tools[i].present) {
            continue;
        }
        for (const RoundedCone& part : drawn_parts(frame.model->tools[i])) {
            if (count + 2 <= most_tool_ends) {
                add(frame.tools[i].pose.to_world(part.a));
                add(frame.tools[i].pose.to_world(part.b));
            }
        }
    }
    for (; count < most_tool_ends; ++count) {
        const std::string name = "tool_ends[" + std::to_string(count) + "]";
        program.set(name.c_str(), Eigen::Vector4d(Eigen::Vector4d::Zero()));
    }
}

/// What shows in a pupil without a lens: the back of the bag.
double back_of(const Frame& frame) {
    return frame.bags.empty() ? frame.eye->iris_z
                              : frame.bags[0].pose.position.z() - frame.model->bags[0].shape.posterior;
}

}  // namespace

Result<Eyepiece> Eyepiece::create(int width, int height) {
    Result<Program> program = Program::build({"fullscreen.vert"}, {"film.glsl", "eyepiece.frag"});
    return program ? Result<Eyepiece>(Eyepiece(std::move(program).value(), width, height)) : program.error();
}

void Eyepiece::look(const EyepieceLayers& layers, const Frame& frame, const Camera& camera, const View& outer,
                    const View& inner, EyeColours colours) const {
    glBindTexture(GL_TEXTURE_2D, *layers.picture.name);
    const bool spreads = camera.aperture > 0.0;
    // without its smaller copies the texture is not whole, and shows black
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, spreads ? most_levels : 0);
    if (spreads) {
        glGenerateMipmap(GL_TEXTURE_2D);
    }
    const EyeAnatomy& eye = *frame.eye;
    program_.use();
    program_.set("sharp", layers.picture, 0);
    program_.set("inner_tools", layers.inner_tools, 1);
    program_.set("outer_tools", layers.outer_tools, 2);
    program_.set("front", layers.front, 3);
    program_.set("reference", layers.reference);
    program_.set("size", Vec2(layers.picture.width, layers.picture.height));
    program_.set("middle", Vec2(camera.target.head<2>()));
    program_.set("field_mm", camera.field_mm);
    program_.set("stop_mm", camera.stop_mm);
    program_.set("aperture", camera.aperture);
    program_.set("focus_z", camera.target.z() + camera.focus_mm);
    program_.set("iris_z", eye.iris_z);
    program_.set("back_z", back_of(frame));
    const double pupil = eye.has_iris ? eye.pupil_radius : eye.limbus_radius;
    program_.set("pupil_radius", pupil * corneal_magnification(eye, eye.iris_z));
    program_.set("limbus_radius", eye.limbus_radius);
    program_.set("globe", globe_ball(eye));
    program_.set("light", camera.light);
    program_.set("only", static_cast<int>(colours));
    set_tools(program_, frame, outer, inner);
    cover_target();
}

}  // namespace rhexis
