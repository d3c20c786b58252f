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
    Result<ProgramVariants> programs =
        ProgramVariants::create({"fullscreen.vert"}, {"film.glsl", "eyepiece.frag"}, {"SPREADS", "TOOLS", "EYE"});
    return programs ? Result<Eyepiece>(Eyepiece(std::move(programs).value(), width, height)) : programs.error();
}

void Eyepiece::look(const EyepieceLayers& layers, const Frame& frame, const Camera& camera, const View& outer,
                    const View& inner, EyeColours colours) {
    glBindTexture(GL_TEXTURE_2D, *layers.picture.name);
    const bool spreads = camera.aperture > 0.0;
    // without its smaller copies the texture is not whole, and shows black
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, spreads ? most_levels : 0);
    if (spreads) {
        glGenerateMipmap(GL_TEXTURE_2D);
    }
    const EyeAnatomy& eye = *frame.eye;
    const unsigned features = (spreads ? 1U : 0U) | 2U | (colours != EyeColours::all ? 4U : 0U);
    const Program& program = programs_.with(features);
    program.use();
    program.set("sharp", layers.picture, 0);
    program.set("inner_tools", layers.inner_tools, 1);
    program.set("outer_tools", layers.outer_tools, 2);
    program.set("front", layers.front, 3);
    program.set("reference", layers.reference);
    program.set("size", Vec2(layers.picture.width, layers.picture.height));
    program.set("middle", Vec2(camera.target.head<2>()));
    program.set("field_mm", camera.field_mm);
    program.set("stop_mm", camera.stop_mm);
    program.set("aperture", camera.aperture);
    program.set("focus_z", camera.target.z() + camera.focus_mm);
    program.set("iris_z", eye.iris_z);
    program.set("back_z", back_of(frame));
    const double pupil = eye.has_iris ? eye.pupil_radius : eye.limbus_radius;
    program.set("pupil_radius", pupil * corneal_magnification(eye, eye.iris_z));
    program.set("limbus_radius", eye.limbus_radius);
    program.set("globe", globe_ball(eye));
    program.set("light", camera.light);
    program.set("only", static_cast<int>(colours));
    set_tools(program, frame, outer, inner);
    cover_target();
}

}  // namespace rhexis
