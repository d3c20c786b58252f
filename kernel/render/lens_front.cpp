// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lens_front.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/adjacency.hpp"
#include "render/depth_pass.hpp"
#include "render/still_lens.hpp"
#include "render/vertex_floats.hpp"

namespace rhexis {

namespace {

constexpr std::array<GLfloat, 4> nothing{no_stop, no_stop, 0.0F, 0.0F};  ///< depth, smoothed over a long way too

constexpr double smoothing_mm = 0.12;  ///< about half of an edge of the fine mesh

struct Level {
    const std::vector<std::array<int, 4>>& tets;
    const std::vector<std::array<int, 4>>& neighbours;
    const std::vector<Vec3>& nodes;
    const std::vector<Vec3>& rest;
};

template <typename IsThere>
void append_border(const Level& level, const IsThere& is_there, std::vector<float>& stream) {
    const int count = static_cast<int>(level.tets.size());
    for (int t = 0; t < count; ++t) {
        if (!is_there(t)) {
            continue;
        }
        for (int k = 0; k < 4; ++k) {
            const int other = level.neighbours[t][k];
            if (other >= 0 && is_there(other)) {
                continue;
            }
            for (int corner : tet_faces[k]) {
                const int node = level.tets[t][corner];
                append_floats(level.nodes[node], stream);
                append_floats(level.rest[node], stream);
            }
        }
    }
}

}  // namespace

Result<LensFront> LensFront::create(int width, int height, bool keeps) {
    Result<Program> front = Program::build({"body.vert"}, {"front.frag"});
    if (!front.ok()) {
        return front.error();
    }
    Result<Program> blur = Program::build({"fullscreen.vert"}, {"relief.frag"});
    if (!blur.ok()) {
        return blur.error();
    }
    Result<Program> slopes = Program::build({"fullscreen.vert"}, {"slopes.frag"});
    if (!slopes.ok()) {
        return slopes.error();
    }
    return LensFront(std::move(front).value(), std::move(blur).value(), std::move(slopes).value(), width, height,
                     keeps);
}

LensFront::LensFront(Program front, Program blur, Program slopes, int width, int height, bool keeps)
    : front_program_(std::move(front)),
      blur_program_(std::move(blur)),
      slopes_program_(std::move(slopes)),
      front_(make_single_target(width, height, GL_RGBA32F, GL_NEAREST, GL_CLAMP_TO_EDGE, true)),
      half_(make_single_target((width + 1) / 2, (height + 1) / 2, GL_RG32F, GL_NEAREST)),
      smooth_(make_single_target((width + 1) / 2, (height + 1) / 2, GL_RG32F, GL_LINEAR)),
      slopes_(make_single_target((width + 1) / 2, (height + 1) / 2, GL_RGBA16F, GL_LINEAR)),
      keeps_(keeps),
      vertices_({3, 3}) {}

void LensFront::collect(const Frame& frame) {
    stream_.clear();
    if (const std::optional<StillLens> lens = still_lens(frame)) {
        append_front(*lens, stream_);
    }
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        const SolidModel& model = frame.model->solids[i];
        const SolidState& state = frame.solids[i];
        if (model.fine.tets.empty()) {
            const std::vector<std::array<int, 4>> neighbours = face_neighbours(model.coarse.tets);
            append_border(
                {model.coarse.tets, neighbours, state.position, model.coarse.nodes},
                [&](int t) { return state.present[t] != 0; }, stream_);
            continue;
        }
        fine_positions(model.fine, state.position, fine_);
        fine_positions(model.fine, model.coarse.nodes, rest_);
        append_border(
            {model.fine.tets, model.fine.neighbours, fine_, rest_},
            [&](int t) { return state.fraction[t] > still_there; }, stream_);
    }
}

/// Smoothing reaches beyond what is drawn, and must not find there what an earlier picture left.
void LensFront::clear_beyond(const PixelRect& area) {
    if (drawn_ && drawn_->area == area) {
        return;
    }
    for (const Target* target : {&front_, &half_, &smooth_}) {
        target->bind();
        glClearBufferfv(GL_COLOR, 0, nothing.data());
    }
    slopes_.bind();
    const std::array<GLfloat, 4> no_surface{};
    glClearBufferfv(GL_COLOR, 0, no_surface.data());
}

/// Whether the surface is seen as when it was drawn.
bool LensFront::is_still(const DrawnFrom& from) const {
    const auto alike = [](float a, float b) { return std::abs(a - b) <= static_cast<float>(seen_mm); };
    return drawn_ == from &&
           std::equal(stream_.begin(), stream_.end(), drawn_stream_.begin(), drawn_stream_.end(), alike);
}

void LensFront::draw(const Frame& frame, const View& view, const Vec3& reference, const PixelRect& area) {
    collect(frame);
    const DrawnFrom from{view.clip_from_world, area, reference};
    if (keeps_ && is_still(from)) {
        return;
    }
    clear_beyond(area);
    drawn_ = from;
    drawn_stream_ = stream_;
    front_.bind();
    const Scissor scissor(area);
    const GLfloat farthest = 1.0F;
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    front_program_.use();
    set_view(front_program_, view);
    front_program_.set("world_from_body", Mat4(Mat4::Identity()));
    front_program_.set("reference", reference);
    vertices_.send(stream_);
    vertices_.draw();
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    const Scissor half_scissor(halved(area));
    smooth(pixel_mm(view, reference));
}

void LensFront::smooth(double pixel_mm) {
    const double deviation_pixels = smoothing_mm / pixel_mm;
    blur_program_.use();
    half_.bind();
    blur_program_.set("first", 1);
    blur_program_.set("source", front_.colours[0], 0);
    blur_program_.set("direction", Vec2(deviation_pixels / front_.width, 0.0));
    cover_target();
    smooth_.bind();
    blur_program_.set("first", 0);
    blur_program_.set("source", half_.colours[0], 0);
    blur_program_.set("direction", Vec2(0.0, deviation_pixels / front_.height));
    cover_target();
    slopes_program_.use();
    slopes_.bind();
    slopes_program_.set("relief", smooth_.colours[0], 0);
    slopes_program_.set("spacing_mm", 2.0 * pixel_mm);
    cover_target();
}

}  // namespace rhexis
