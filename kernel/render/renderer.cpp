// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/bare_view.hpp"
#include "render/depth_pass.hpp"
#include "render/eyepiece.hpp"
#include "render/gl_context.hpp"
#include "render/microscope_view.hpp"

namespace rhexis {

namespace {

constexpr int largest = 4096;

Status check_size(int width, int height) {
    if (width >= 1 && width <= largest && height >= 1 && height <= largest) {
        return success();
    }
    return Error{"a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels", "renderer",
                 "1 to " + std::to_string(largest) + " each way"};
}

/// Light that the cornea bends, or no cornea.
View view_into(const Frame& frame, const Camera& camera, int width, int height) {
    return frame.eye && frame.eye->has_cornea ? view_through_cornea(camera, width, height, *frame.eye)
                                              : view_in_air(camera, width, height);
}

/// Rows from the top, without the fourth channel.
Image picture_of(const Target& target) {
    target.bind();
    std::vector<unsigned char> pixels(4 * static_cast<std::size_t>(target.width) * target.height);
    glReadPixels(0, 0, target.width, target.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    Image image{target.width, target.height, {}};
    image.rgb.reserve(pixels.size() / 4 * 3);
    for (int y = target.height - 1; y >= 0; --y) {
        for (int x = 0; x < target.width; ++x) {
            const unsigned char* pixel = &pixels[4 * (static_cast<std::size_t>(y) * target.width + x)];
            image.rgb.insert(image.rgb.end(), pixel, pixel + 3);
        }
    }
    return image;
}

/// How much more than its field the picture shows, so that all of the field's edge is in it.
constexpr double surround = 1.04;

/// Of the fixed view's camera, which has a diaphragm of its own: half as wide as the microscope's. Proposal
constexpr double camera_aperture = 0.5 * microscope_aperture;
constexpr double usual_focus_mm = 1.0;    ///< below the pupil's edge, which is in focus with it
constexpr double deepest_focus_mm = 4.5;  ///< where the bag ends
constexpr double focus_step_mm = 0.25;

/// The camera follows the microscope, and sees its field.
void look_with(const MicroscopeModel& model, const MicroscopeState& microscope, Camera& camera) {
    camera.target.head<2>() = microscope.position.head<2>();
    camera.eye.head<2>() = microscope.position.head<2>();
    camera.stop_mm = 2.0 * model.field_radius;
    camera.field_mm = surround * camera.stop_mm;
    camera.aperture = microscope_aperture;
    camera.focus_mm = microscope.position.z() - camera.target.z();
}

/// What one of two eyes sees, and keeps from picture to picture.
struct EyeView {
    DepthPass depth;
    MicroscopeView microscope;
    Eyepiece eyepiece;
};

Result<EyeView> make_eye_view(int width, int height, Light light) {
    Result<MicroscopeView> microscope = MicroscopeView::create(width, height, light == Light::kept);
    if (!microscope.ok()) {
        return microscope.error();
    }
    Result<Eyepiece> eyepiece = Eyepiece::create(width, height);
    if (!eyepiece.ok()) {
        return eyepiece.error();
    }
    return EyeView{DepthPass(width, height, light == Light::kept), std::move(microscope).value(),
                   std::move(eyepiece).value()};
}

/// Everything that lives in the context.
struct Passes {
    ToolPainter painter;
    EyeView left;                  ///< or the only one
    std::optional<EyeView> right;  ///< made when it is first needed
    BareView bare;
    Texture detail;
};

Result<Passes> make_passes(int width, int height, Light light) {
    Result<ToolPainter> painter = ToolPainter::create();
    if (!painter.ok()) {
        return painter.error();
    }
    Result<EyeView> left = make_eye_view(width, height, light);
    if (!left.ok()) {
        return left.error();
    }
    Result<BareView> bare = BareView::create(width, height);
    if (!bare.ok()) {
        return bare.error();
    }
    Result<Texture> detail = paint_detail();
    if (!detail.ok()) {
        return detail.error();
    }
    return Passes{std::move(painter).value(), std::move(left).value(), std::nullopt, std::move(bare).value(),
                  std::move(detail).value()};
}

}  // namespace

struct Renderer::Parts {
    GlContext context;
    int width = 0;
    int height = 0;
    std::optional<Passes> passes;
    std::shared_ptr<const WorldModel> model;  ///< that `tools` was made of
    std::vector<ToolMesh> tools;
    PassClock clock;

    explicit Parts(GlContext made) : context(std::move(made)) {}
    ~Parts() {
        const GlContext::Use use(context);
        passes.reset();
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void look_at(const Frame& frame);
    /// camera: in the eye's frame.
    const Target& paint(const Frame& frame, const Camera& camera, EyeView& eye);
    /// Through the eyepiece.
    void look(const Frame& frame, const Camera& camera, EyeView& eye, const Target& into, EyeColours colours);
    EyeView& right_eye();
    /// Scaled to a rectangle of the window.
    void copy(const Target& picture, const ScreenArea& area) const;
    /// The finished picture; of one eye for red and cyan glasses only its colours change.
    const Target& finish(const Frame& frame, const Camera& camera) {
        return finish(frame, camera, passes->left, passes->left.eyepiece.target(), EyeColours::all);
    }
    const Target& finish(const Frame& frame, const Camera& camera, EyeView& eye, const Target& into,
                         EyeColours colours);
};

void Renderer::Parts::look_at(const Frame& frame) {
    RHEXIS_ASSERT(frame.model != nullptr);
    RHEXIS_ASSERT(frame.solids.size() == frame.model->solids.size());
    RHEXIS_ASSERT(frame.tools.size() == frame.model->tools.size());
    if (frame.model == model) {
        return;
    }
    model = frame.model;
    tools.clear();
    for (const ToolModel& tool : model->tools) {
        tools.push_back(tool_mesh(tool));
    }
}

Result<Renderer> Renderer::create(int width, int height, Light light) {
    return create_with(GlContext::create(), width, height, light);
}

Result<Renderer> Renderer::create_in_window(int width, int height) {
    return create_with(GlContext::current(), width, height, Light::kept);
}

Result<Renderer> Renderer::create_with(Result<GlContext> context, int width, int height, Light light) {
    if (const Status status = check_size(width, height); !status.ok()) {
        return status.error();
    }
    if (!context.ok()) {
        return context.error();
    }
    std::unique_ptr<Parts> parts = std::make_unique<Parts>(std::move(context).value());
    parts->width = width;
    parts->height = height;
    const GlContext::Use use(parts->context);
    Result<Passes> passes = make_passes(width, height, light);
    if (!passes.ok()) {
        return passes.error();
    }
    parts->passes.emplace(std::move(passes).value());
    return Renderer(std::move(parts));
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

Camera camera_in_eye(const Camera& room, const GlobeModel& model, const GlobeState& globe) {
    Camera camera = room;
    camera.eye = to_eye(model, globe, room.eye);
    camera.target = to_eye(model, globe, room.target);
    camera.up = rotation_of(globe).conjugate() * room.up;
    return camera;
}

namespace {

/// The camera stands in the room, what is drawn in the eye's frame.
Camera in_eye(const Frame& frame, const Camera& camera) {
    return frame.eye && frame.globe && frame.model->globe ? camera_in_eye(camera, *frame.model->globe, *frame.globe)
                                                          : camera;
}

}  // namespace

const Target& Renderer::Parts::paint(const Frame& frame, const Camera& camera, EyeView& eye) {
    look_at(frame);
    const View outer = view_in_air(camera, width, height);
    if (!frame.eye) {
        passes->bare.draw(passes->painter, frame, tools, outer, passes->detail);
        return passes->bare.picture();
    }
    const View inner = view_into(frame, camera, width, height);
    const EyeAreas areas = eye_areas(*frame.eye, outer, inner);
    eye.depth.draw(frame, tools, inner, areas.cornea, areas.pupil);
    clock.end("optical depth");
    eye.microscope.draw(passes->painter, frame, tools, outer, inner, eye.depth, passes->detail,
                        0.5 * camera.stop_mm / camera.field_mm * height, clock);
    return eye.microscope.picture();
}

void Renderer::Parts::look(const Frame& frame, const Camera& camera, EyeView& eye, const Target& into,
                           EyeColours colours) {
    const View outer = view_in_air(camera, width, height);
    const View inner = view_into(frame, camera, width, height);
    eye.eyepiece.look(eye.microscope.layers(eye.depth), frame, camera, outer, inner, into, colours);
}

/// Where it cannot be made, the left one serves for both, and keeps nothing.
EyeView& Renderer::Parts::right_eye() {
    if (!passes->right) {
        Result<EyeView> made = make_eye_view(width, height, Light::kept);
        if (!made.ok()) {
            return passes->left;
        }
        passes->right.emplace(std::move(made).value());
    }
    return *passes->right;
}

void Renderer::Parts::copy(const Target& picture, const ScreenArea& area) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, *picture.name);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, area.left, area.bottom, area.left + area.width, area.bottom + area.height,
                      GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

const Target& Renderer::Parts::finish(const Frame& frame, const Camera& camera, EyeView& eye, const Target& into,
                                      EyeColours colours) {
    const Target& painted = paint(frame, camera, eye);
    if (!frame.eye) {
        return painted;
    }
    look(frame, camera, eye, into, colours);
    clock.end("film");
    return into;
}

Image Renderer::draw(const Frame& frame, const Camera& room) {
    const GlContext::Use use(parts_->context);
    return picture_of(parts_->finish(frame, in_eye(frame, room)));
}

std::vector<PassCost> Renderer::costs(const Frame& frame, const Camera& camera) {
    const GlContext::Use use(parts_->context);
    parts_->clock.start();
    static_cast<void>(picture_of(parts_->finish(frame, in_eye(frame, camera))));
    parts_->clock.end("read back");
    return parts_->clock.stop();
}

Image Renderer::photograph_card(double reflectance, const Frame& frame, const Camera& room) {
    RHEXIS_ASSERT(frame.eye != nullptr);
    const Camera camera = in_eye(frame, room);
    const GlContext::Use use(parts_->context);
    parts_->look_at(frame);
    EyeView& eye = parts_->passes->left;
    eye.microscope.draw_card(reflectance, *frame.eye, view_in_air(camera, parts_->width, parts_->height));
    parts_->look(frame, camera, eye, eye.eyepiece.target(), EyeColours::all);
    return picture_of(eye.eyepiece.target());
}

void Renderer::show(const Frame& frame, const Camera& room, const ScreenArea& area, Stereo stereo) {
    const Camera camera = in_eye(frame, room);
    if (stereo == Stereo::off) {
        parts_->copy(parts_->finish(frame, camera), area);
        return;
    }
    EyeView& left = parts_->passes->left;
    for (const bool is_left : {true, false}) {
        Camera aside = camera;
        aside.aside_mm = (is_left ? -0.5 : 0.5) * stereo_base_mm;
        EyeView& eye = is_left ? left : parts_->right_eye();
        if (stereo == Stereo::side_by_side) {
            ScreenArea part = area;
            part.width = area.width / 2;
            part.left = is_left ? area.left : area.left + area.width - part.width;
            parts_->copy(parts_->finish(frame, aside, eye, eye.eyepiece.target(), EyeColours::all), part);
        } else {
            const EyeColours colours = is_left ? EyeColours::red : EyeColours::cyan;
            const Target& seen = parts_->finish(frame, aside, eye, left.eyepiece.target(), colours);
            if (!is_left) {
                parts_->copy(seen, area);
            }
        }
    }
}

Camera microscope_camera(const EyeAnatomy& eye, const WorldModel& world,
                         const std::optional<MicroscopeState>& microscope) {
    Camera camera;
    camera.target = Vec3(0.0, 0.0, eye.iris_z);
    camera.eye = camera.target + Vec3(0.0, 0.0, 200.0);
    camera.field_mm = 14.6;
    camera.aperture = camera_aperture;
    camera.focus_mm = -usual_focus_mm;
    if (microscope) {
        look_with(*world.microscope, *microscope, camera);
    }
    return camera;
}

namespace {

/// Where the lowest instrument works, in steps that are not seen: what somebody would focus on who looks on.
double worked_height(const Frame& frame) {
    double lowest = frame.eye->iris_z - usual_focus_mm;
    for (const ToolState& tool : frame.tools) {
        if (tool.present) {
            lowest = std::min(lowest, tool.pose.position.z());
        }
    }
    const double below = std::min(frame.eye->iris_z - lowest, deepest_focus_mm);
    return frame.eye->iris_z - focus_step_mm * std::round(below / focus_step_mm);
}

}  // namespace

Camera microscope_camera(const Frame& frame) {
    if (!frame.eye) {
        return camera_around(frame);
    }
    Camera camera = microscope_camera(*frame.eye, *frame.model, frame.microscope);
    if (!frame.microscope) {
        camera.focus_mm = worked_height(frame) - camera.target.z();
    }
    return camera;
}

OpticalDepth Renderer::optical_depth(const Frame& frame, const Camera& camera) {
    const GlContext::Use use(parts_->context);
    parts_->look_at(frame);
    const int width = parts_->width;
    const int height = parts_->height;
    const View view = view_into(frame, camera, width, height);
    DepthPass& depth = parts_->passes->left.depth;
    depth.draw(frame, parts_->tools, view, whole(view), whole(view));
    const std::vector<float>& sums = depth.raster().sum();
    const int channels = depth.raster().channels();
    const Eigen::Vector3f tint = depth.tint().cast<float>();
    OpticalDepth result{width, height, std::vector<float>(3 * static_cast<std::size_t>(width) * height)};
    const float* from = sums.data();
    for (int y = height - 1; y >= 0; --y) {
        float* to = &result.tau[3 * static_cast<std::size_t>(y) * width];
        for (int x = 0; x < width; ++x, from += channels, to += 3) {
            const float stretch = from[0] == 0.0F ? 0.0F : static_cast<float>(pixel_ray(view, x, y).stretch);
            for (int c = 0; c < 3; ++c) {
                to[c] = stretch * tint[c] * from[channels == 1 ? 0 : c];
            }
        }
    }
    return result;
}

}  // namespace rhexis
