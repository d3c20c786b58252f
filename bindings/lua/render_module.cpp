// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis.render: pictures and videos of scenes.
#include <string>

#include "lua/guard.hpp"
#include "lua/modules.hpp"
#include "lua/objects.hpp"
#include "lua/selection.hpp"
#include "lua/stack.hpp"
#include "lua/video_library.hpp"
#include "render/image_file.hpp"

namespace rhexis::lua {
namespace {

// One renderer is kept, of the size that was drawn last.
Renderer& renderer_of(lua_State* L, int width, int height) {
    Objects& all = objects(L);
    if (!all.renderer || all.renderer_width != width || all.renderer_height != height) {
        all.renderer.reset();
        Result<Renderer> made = Renderer::create(width, height);
        if (!made) {
            raise(L, "rhexis.render.draw: " + made.error().text());
        }
        all.renderer.emplace(std::move(made).value());
        all.renderer_width = width;
        all.renderer_height = height;
    }
    return *all.renderer;
}

Camera read_camera(lua_State* L, Options& options, const Frame& frame) {
    Camera camera = microscope_camera(frame);
    options.push_field("camera");
    Options view(L, -1, "rhexis.render.draw: camera");
    camera.eye = view.vec3("eye", camera.eye);
    camera.target = view.vec3("target", camera.target);
    camera.up = view.vec3("up", camera.up);
    camera.field_mm = view.number("field", camera.field_mm, {0.01, 1000.0, "mm"});
    view.finish();
    lua_pop(L, 1);
    if ((camera.target - camera.eye).cross(camera.up).norm() < 1e-9) {
        raise(L, "rhexis.render.draw: camera: up points along the view, or eye and target coincide");
    }
    return camera;
}

int draw(lua_State* L) {
    SceneBody& scene = check_scene(L, 1);
    Options options(L, 2, "rhexis.render.draw");
    const auto width = static_cast<int>(options.integer("width", 640, 16, 4096));
    const auto height = static_cast<int>(options.integer("height", 480, 16, 4096));
    const Frame frame = scene.frame();
    const Camera camera = read_camera(L, options, frame);
    options.finish();
    push_image(L, renderer_of(L, width, height).draw(frame, camera));
    return 1;
}

int video(lua_State* L) {
    const std::string path = check_string(L, 1);
    Options options(L, 2, "rhexis.render.video");
    const auto width = static_cast<int>(options.integer("width", 640, 16, 4096));
    const auto height = static_cast<int>(options.integer("height", 480, 16, 4096));
    const double rate = options.number("frames_per_second", 25.0, {1.0, 1000.0, "1/s"});
    options.finish();
    Result<std::unique_ptr<Video>> file = open_video(path, width, height, rate);
    if (!file) {
        raise(L, "rhexis.render.video: " + file.error().text());
    }
    push_video(L, std::make_unique<SizedVideo>(SizedVideo{std::move(file).value(), width, height}));
    return 1;
}

// ---- Image

int width(lua_State* L) {
    push(L, check_image(L, 1).width);
    return 1;
}

int height(lua_State* L) {
    push(L, check_image(L, 1).height);
    return 1;
}

int pixel(lua_State* L) {
    const Image& image = check_image(L, 1);
    const auto column = static_cast<std::size_t>(check_number_of(L, 2, static_cast<std::size_t>(image.width)));
    const auto row = static_cast<std::size_t>(check_number_of(L, 3, static_cast<std::size_t>(image.height)));
    const std::size_t at = 3 * (row * static_cast<std::size_t>(image.width) + column);
    for (std::size_t k = 0; k < 3; ++k) {
        push(L, static_cast<int>(image.rgb[at + k]));
    }
    return 3;
}

int write_png_file(lua_State* L) {
    raise_if_failed(L, "write_png", write_png(check_image(L, 1), check_string(L, 2)));
    return 0;
}

// ---- Video

int add(lua_State* L) {
    SizedVideo& video_file = check_video(L, 1);
    const Image& image = check_image(L, 2);
    if (image.width != video_file.width || image.height != video_file.height) {
        raise(L, "add: the image is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                     ", the video " + std::to_string(video_file.width) + " x " + std::to_string(video_file.height));
    }
    raise_if_failed(L, "add", video_file.file->add(image));
    return 0;
}

int finish(lua_State* L) {
    const Status status = check_video(L, 1).file->finish();
    close_video(L);
    raise_if_failed(L, "finish", status);
    return 0;
}

}  // namespace

void push_render_module(lua_State* L) {
    define_class(L, image_class,
                 {{"width", guarded<width>},
                  {"height", guarded<height>},
                  {"pixel", guarded<pixel>},
                  {"write_png", guarded<write_png_file>},
                  {"close", guarded<close_image>}},
                 {{"__gc", guarded<close_image>}});
    define_class(L, video_class, {{"add", guarded<add>}, {"finish", guarded<finish>}},
                 {{"__gc", guarded<close_video>}});
    push_library(L, {{"draw", guarded<draw>}, {"video", guarded<video>}});
}

}  // namespace rhexis::lua
