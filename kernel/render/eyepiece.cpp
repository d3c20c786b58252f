// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/eyepiece.hpp"

#include <algorithm>
#include <cmath>

#include "flow/corneal_image.hpp"
#include "render/eye_balls.hpp"
#include "render/tool_mesh.hpp"

namespace rhexis {
namespace {

constexpr std::size_t most_tool_ends = 16;
constexpr int most_levels = 6;  ///< of smaller copies: for what spreads over 85 pixels, and looks no softer beyond

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
        end << pixel_from_below(inside ? inner : outer, place), place.z(), 0.0;
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
    program.set("tool_end_count", static_cast<int>(count));
}

/// What shows in a pupil without a lens: the back of the bag.
double back_of(const Frame& frame) {
    return frame.bags.empty() ? frame.eye->iris_z
                              : frame.bags[0].pose.position.z() - frame.model->bags[0].shape.posterior;
}

double focus_of(const Camera& camera) { return camera.target.z() + camera.focus_mm; }

/// How wide a point at this height spreads. [pixels]
double spread_at(double z, const Camera& camera, int rows) {
    return 2.0 * camera.aperture * std::abs(z - focus_of(camera)) * rows / camera.field_mm;
}

/// Of copies that a point which spreads this far is looked up in.
int levels_for(double spread) { return spread > 1.3 ? static_cast<int>(std::ceil(std::log2(0.75 * spread))) : 0; }

/// How far the light of a place gets where what lies beside it is so far off. [pixels]
double reach_of(double spread) {
    return spread > 1.3 ? 0.2 * spread + 1.5 * std::exp2(levels_for(spread)) : 0.0;  // what is painted has a margin
}

/// Of the sclera, so far from the axis.
double sclera_height(const EyeAnatomy& eye, double from_axis) {
    const Vec4 globe = globe_ball(eye);
    return globe.z() + std::sqrt(std::max(0.0, globe.w() * globe.w() - from_axis * from_axis));
}

/// Smaller copies that show, of an eye and of instruments.
int levels_of(const Frame& frame, const Camera& camera, const Texture& picture) {
    const double corner = 0.5 * camera.field_mm * std::hypot(1.0, double(picture.width) / picture.height) +
                          camera.target.head<2>().norm();
    std::vector<double> heights{back_of(frame), frame.eye->cornea_apex_z, sclera_height(*frame.eye, corner)};
    for (std::size_t i = 0; i < frame.tools.size(); ++i) {
        if (!frame.tools[i].present) {
            continue;
        }
        for (const RoundedCone& part : drawn_parts(frame.model->tools[i])) {
            for (const Vec3& end : {part.a, part.b}) {
                heights.push_back(frame.tools[i].pose.to_world(end).z());
            }
        }
    }
    int levels = 0;
    for (const double z : heights) {
        levels = std::max(levels, levels_for(spread_at(z, camera, picture.height)));
    }
    return std::min(levels, most_levels);
}

}  // namespace

Result<Eyepiece> Eyepiece::create(int width, int height) {
    Result<ProgramVariants> programs =
        ProgramVariants::create({"part.vert"}, {"film.glsl", "eyepiece.frag"}, {"SPREADS", "TOOLS", "EYE"});
    if (!programs.ok()) {
        return programs.error();
    }
    Result<SmallerCopies> smaller = SmallerCopies::create();
    if (!smaller.ok()) {
        return smaller.error();
    }
    return Eyepiece(std::move(programs).value(), std::move(smaller).value(), width, height);
}

Eyepiece::Eyepiece(ProgramVariants programs, SmallerCopies smaller, int width, int height)
    : programs_(std::move(programs)),
      smaller_(std::move(smaller)),
      target_(make_single_target(width, height, GL_RGBA8, GL_NEAREST)),
      changed_(width, height),
      rectangles_({2}) {}

/// Sets all but where the instruments are, and where the pupil is in focus: both are new in each picture anyway.
void Eyepiece::set_all(const Program& program, const EyepieceLayers& layers, const Frame& frame, const Camera& camera,
                       EyeColours colours) const {
    const EyeAnatomy& eye = *frame.eye;
    program.use();
    program.set("sharp", layers.picture, 0);
    program.set("inner_tools", layers.inner_tools, 1);
    program.set("outer_tools", layers.outer_tools, 2);
    program.set("front", layers.front, 3);
    program.set("size", Vec2(layers.picture.width, layers.picture.height));
    program.set("middle", Vec2(camera.target.head<2>()));
    program.set("field_mm", camera.field_mm);
    program.set("stop_mm", camera.stop_mm);
    program.set("aperture", camera.aperture);
    program.set("focus_z", focus_of(camera));
    program.set("iris_z", eye.iris_z);
    const double pupil = eye.has_iris ? eye.pupil_radius : eye.limbus_radius;
    program.set("pupil_radius", pupil * corneal_magnification(eye, eye.iris_z));
    program.set("limbus_radius", eye.limbus_radius);
    program.set("globe", globe_ball(eye));
    program.set("light", camera.light);
    program.set("only", static_cast<int>(colours));
}

/// Whether all is looked at as the last time.
bool Eyepiece::is_same(Program& program, const EyepieceLayers& layers, const Frame& frame, const Camera& camera,
                       EyeColours colours) {
    now_.assign(1, camera.aperture > 0.0 ? 1 : 0);
    program.log_to(&now_);
    set_all(program, layers, frame, camera, colours);
    program.log_to(nullptr);
    const bool same = now_ == parameters_;
    parameters_.swap(now_);
    return same;
}

void Eyepiece::look(const EyepieceLayers& layers, const Frame& frame, const Camera& camera, const View& outer,
                    const View& inner, const Target& into, EyeColours colours) {
    enum Feature : unsigned { spreading = 1, instruments = 2, one_eye = 4 };
    const unsigned features = (camera.aperture > 0.0 ? spreading : 0U) | (colours != EyeColours::all ? one_eye : 0U);
    const auto reach = [&](double z) { return reach_of(spread_at(z, camera, layers.picture.height)); };
    changed_ = layers.painted;
    if (!is_same(programs_.with(features), layers, frame, camera, colours)) {
        changed_.mark_all();
    }
    smaller_.make(layers.picture, changed_, levels_of(frame, camera, layers.picture));
    changed_.grow(reach(frame.eye->iris_z));
    TileMask disturbed = layers.disturbed;
    constexpr double beside_limbus = 3.0;  // where instruments pass [mm]
    const double sclera_z = sclera_height(*frame.eye, frame.eye->limbus_radius + beside_limbus);
    disturbed.grow(std::max(reach(sclera_z), reach(frame.eye->iris_z)));
    changed_.mark(disturbed.rects());
    into.bind();
    const bool red = colours != EyeColours::cyan;
    const bool cyan = colours != EyeColours::red;
    glColorMask(red, cyan, cyan, GL_TRUE);
    for (const bool with_tools : {false, true}) {
        const Program& program = programs_.with(features | (with_tools ? instruments : 0U));
        set_all(program, layers, frame, camera, colours);
        program.set("reference", layers.reference);
        program.set("back_z", back_of(frame));
        if (with_tools) {
            set_tools(program, frame, outer, inner);
        }
        const std::vector<PixelRect> where =
            with_tools ? layers.tools.within(changed_.rects()) : changed_.without(layers.tools).rects();
        rectangles_.send(triangles_of(where, into.width, into.height));
        rectangles_.draw();
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace rhexis
