// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/microscope_view.hpp"

namespace rhexis {

namespace {

/// Centre of the pupil and its reach sideways and upwards, in pixels from the bottom left.
struct PupilOnScreen {
    Vec2 centre;
    Vec2 reach;
};

PupilOnScreen pupil_on_screen(const EyeAnatomy& eye, const View& inner) {
    const Vec3 middle(0.0, 0.0, eye.iris_z);
    PupilOnScreen pupil{pixel_of(inner, middle), Vec2::Zero()};
    for (const Vec3& rim : {Vec3(eye.pupil_radius, 0.0, 0.0), Vec3(0.0, eye.pupil_radius, 0.0)}) {
        pupil.reach += (pixel_of(inner, middle + rim) - pupil.centre).cwiseAbs();
    }
    pupil.centre.y() = inner.height - pupil.centre.y();
    return pupil;
}

}  // namespace

Result<MicroscopeView> MicroscopeView::create(int width, int height) {
    Result<Program> light = Program::build({"fullscreen.vert"}, {"view.glsl", "pupil_light.frag"});
    Result<Program> compose = Program::build({"fullscreen.vert"}, {"view.glsl", "microscope.frag"});
    for (const Result<Program>* program : {&light, &compose}) {
        if (!program->ok()) {
            return program->error();
        }
    }
    Result<EyePainter> painter = EyePainter::create();
    if (!painter.ok()) {
        return painter.error();
    }
    Result<LensFront> front = LensFront::create(width, height);
    if (!front.ok()) {
        return front.error();
    }
    return MicroscopeView(std::move(light).value(), std::move(compose).value(), std::move(painter).value(),
                          std::move(front).value(), width, height);
}

MicroscopeView::MicroscopeView(Program light, Program compose, EyePainter painter, LensFront front, int width,
                               int height)
    : light_program_(std::move(light)),
      compose_program_(std::move(compose)),
      eye_painter_(std::move(painter)),
      front_(std::move(front)),
      inside_(width, height),
      outside_(width, height),
      light_(make_single_target(1, 1, GL_RGBA32F, GL_NEAREST)),
      picture_(make_single_target(width, height, GL_RGBA8, GL_NEAREST)) {}

void MicroscopeView::draw(ToolPainter& painter, const Frame& frame, const std::vector<ToolMesh>& tools,
                          const View& outer, const View& inner, const DepthPass& depth, const Texture& detail) {
    const EyeAnatomy& eye = *frame.eye;
    if (!textures_ || painted_limbus_ != eye.limbus_radius) {
        textures_.emplace(eye_painter_.paint(eye));
        painted_limbus_ = eye.limbus_radius;
    }
    front_.draw(frame, inner, depth.reference());
    inside_.draw(painter, frame, tools, inner, Medium::inside, eye, detail);
    outside_.draw(painter, frame, tools, outer, Medium::outside, eye, detail);
    gather_light(frame, inner, depth);
    compose(frame, inner, depth, detail);
}

void MicroscopeView::gather_light(const Frame& frame, const View& inner, const DepthPass& depth) {
    const PupilOnScreen pupil = pupil_on_screen(*frame.eye, inner);
    light_.bind();
    light_program_.use();
    set_view(light_program_, inner);
    light_program_.set("optical_depth", depth.optical_depth().colours[0], 0);
    light_program_.set("stop", depth.stop(), 1);
    light_program_.set("pupil_centre", pupil.centre);
    light_program_.set("pupil_reach", pupil.reach);
    cover_target();
}

void MicroscopeView::compose(const Frame& frame, const View& inner, const DepthPass& depth, const Texture& detail) {
    const EyeAnatomy& eye = *frame.eye;
    const Program& program = compose_program_;
    picture_.bind();
    program.use();
    set_view(program, inner);
    program.set("optical_depth", depth.optical_depth().colours[0], 0);
    program.set("stop", depth.stop(), 1);
    program.set("front", front_.surface(), 2);
    program.set("relief", front_.relief(), 3);
    program.set("inner_tools", inside_.picture(), 4);
    program.set("outer_tools", outside_.picture(), 5);
    program.set("pupil_light", light_.colours[0], 6);
    program.set("iris_map", textures_->iris, 7);
    program.set("sclera_map", textures_->sclera, 8);
    program.set("detail_map", detail, 9);
    program.set("reference", depth.reference());
    program.set("pixel_mm", pixel_mm(inner, Vec3(0.0, 0.0, eye.iris_z)));
    program.set("cornea", cornea_ball(eye));
    program.set("globe", globe_ball(eye));
    program.set("limbus_radius", eye.limbus_radius);
    program.set("iris_z", eye.iris_z);
    program.set("pupil_radius", eye.pupil_radius);
    program.set("sclera_extent", sclera_extent_mm);
    program.set("incision", eye.incision);
    program.set("incision_width", eye.incision_width);
    const bool has_bag = !frame.bags.empty();
    program.set("has_bag", has_bag ? 1 : 0);
    if (has_bag) {
        const BagModel& bag = frame.model->bags[0];
        program.set("bag_from_world", Mat4(matrix_of(frame.bags[0].pose).inverse()));
        program.set("bag_shape", Vec3(bag.shape.radius, bag.shape.anterior, bag.shape.posterior));
        program.set("opening_radius", bag.opening_radius);
    }
    cover_target();
}

}  // namespace rhexis
