// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/renderer.hpp"

#include <optional>

#include "render/depth_pass.hpp"
#include "render/gl_context.hpp"

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

/// Light that the cornea bends, or none.
View view_into(const Frame& frame, const Camera& camera, int width, int height) {
    return frame.eye ? view_through_cornea(camera, width, height, *frame.eye) : view_in_air(camera, width, height);
}

}  // namespace

struct Renderer::Parts {
    GlContext context;
    int width = 0;
    int height = 0;
    std::optional<DepthPass> depth;
    std::shared_ptr<const WorldModel> model;  ///< that `tools` was made of
    std::vector<ToolMesh> tools;

    explicit Parts(GlContext made) : context(std::move(made)) {}
    ~Parts() {
        const GlContext::Use use(context);
        depth.reset();
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    Status build();
    void look_at(const Frame& frame);
};

Status Renderer::Parts::build() {
    Result<DepthPass> made = DepthPass::create(width, height);
    if (!made.ok()) {
        return made.error();
    }
    depth.emplace(std::move(made).value());
    return success();
}

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

Result<Renderer> Renderer::create(int width, int height) {
    if (const Status status = check_size(width, height); !status.ok()) {
        return status.error();
    }
    Result<GlContext> context = GlContext::create();
    if (!context.ok()) {
        return context.error();
    }
    std::unique_ptr<Parts> parts = std::make_unique<Parts>(std::move(context).value());
    parts->width = width;
    parts->height = height;
    const GlContext::Use use(parts->context);
    if (const Status status = parts->build(); !status.ok()) {
        return status.error();
    }
    return Renderer(std::move(parts));
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

OpticalDepth Renderer::optical_depth(const Frame& frame, const Camera& camera) {
    const GlContext::Use use(parts_->context);
    parts_->look_at(frame);
    const int width = parts_->width;
    const int height = parts_->height;
    parts_->depth->draw(frame, parts_->tools, view_into(frame, camera, width, height));
    parts_->depth->optical_depth().bind();
    std::vector<float> pixels(4 * static_cast<std::size_t>(width) * height);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
    OpticalDepth result{width, height, std::vector<float>(3 * static_cast<std::size_t>(width) * height)};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const std::size_t from = 4 * (static_cast<std::size_t>(height - 1 - y) * width + x) + c;
                result.tau[3 * (static_cast<std::size_t>(y) * width + x) + c] = pixels[from];
            }
        }
    }
    return result;
}

}  // namespace rhexis
namespace rhexis {
Image Renderer::draw(const Frame&, const Camera&) { return {}; }
}
