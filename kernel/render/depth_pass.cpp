// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/depth_pass.hpp"

#include <array>

namespace rhexis {

namespace {

/// Middle of all bodies: distances are measured from there, so that their sums lose few digits.
Vec3 middle_of(const Frame& frame) {
    Vec3 sum = Vec3::Zero();
    double count = 0.0;
    for (const SolidState& solid : frame.solids) {
        for (const Vec3& node : solid.position) {
            sum += node;
            count += 1.0;
        }
    }
    return count > 0.0 && sum.allFinite() ? Vec3(sum / count) : Vec3(Vec3::Zero());
}

std::vector<float> triangles_of(const ToolMesh& mesh) {
    std::vector<float> stream;
    for (const ToolMesh::Part& part : mesh.parts) {
        append_triangles(part, stream);
    }
    return stream;
}

}  // namespace

Eigen::Matrix4d matrix_of(const Pose& pose) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.block<3, 3>(0, 0) = pose.orientation.toRotationMatrix();
    matrix.block<3, 1>(0, 3) = pose.position;
    return matrix;
}

void set_view(const Program& program, const View& view) {
    program.set("clip_from_world", view.clip_from_world);
    program.set("view_size", Vec2(view.width, view.height));
    program.set("view_eye", view.eye);
    program.set("view_forward", view.forward);
    program.set("view_right", view.right);
    program.set("view_up", view.up);
    program.set("view_axis", view.axis);
    program.set("view_plane", view.plane_point);
    program.set("view_centre", view.centre);
}

Result<DepthPass> DepthPass::create(int width, int height) {
    Result<Program> faces = Program::build({"body.vert"}, {"signed_faces.frag"});
    if (!faces.ok()) {
        return faces.error();
    }
    Result<Program> distance = Program::build({"body.vert"}, {"stop.frag"});
    if (!distance.ok()) {
        return distance.error();
    }
    return DepthPass(std::move(faces).value(), std::move(distance).value(), width, height);
}

DepthPass::DepthPass(Program faces, Program distance, int width, int height)
    : faces_(std::move(faces)), distance_(std::move(distance)), vertices_({3, 3}) {
    sum_ = make_single_target(width, height, GL_RGBA32F, GL_NEAREST);
    grey_sum_ = make_single_target(width, height, GL_R32F, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, *grey_sum_.colours[0].name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_RED);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, GL_RED);
    stop_ = make_single_target(width, height, GL_R32F, GL_NEAREST, GL_CLAMP_TO_EDGE, true);
}

void DepthPass::draw(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
                     const PixelRect& tool_area, const PixelRect& body_area) {
    find_tint(*frame.model);
    reference_ = middle_of(frame);
    stream_.clear();
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        append_signed_faces(frame.model->solids[i], frame.solids[i], fine_, stream_);
    }
    {
        const Scissor scissor(tool_area);
        draw_tools(frame, tools, view);
    }
    const Scissor scissor(body_area);
    draw_faces(view);
}

void DepthPass::find_tint(const WorldModel& model) {
    Vec3 strongest = Vec3::Zero();
    for (const SolidModel& solid : model.solids) {
        for (const Material& material : solid.materials) {
            strongest = material.extinction.norm() > strongest.norm() ? material.extinction : strongest;
        }
    }
    grey_ = strongest.x() > 0.0;
    for (const SolidModel& solid : model.solids) {
        for (const Material& material : solid.materials) {
            const double off = material.extinction.cross(strongest).norm();
            grey_ = grey_ && off <= 1e-12 * strongest.squaredNorm();
        }
    }
    tint_ = grey_ ? Vec3(strongest / strongest.x()) : Vec3(Vec3::Ones());
}

void DepthPass::draw_tools(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view) {
    stop_.bind();
    const std::array<GLfloat, 4> nothing{no_stop, 0.0F, 0.0F, 0.0F};
    const GLfloat farthest = 1.0F;
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glEnable(GL_DEPTH_TEST);
    distance_.use();
    set_view(distance_, view);
    distance_.set("reference", reference_);
    for (std::size_t i = 0; i < frame.tools.size(); ++i) {
        if (frame.tools[i].present) {
            distance_.set("world_from_body", matrix_of(frame.tools[i].pose));
            vertices_.send(triangles_of(tools[i]));
            vertices_.draw();
        }
    }
    glDisable(GL_DEPTH_TEST);
}

void DepthPass::draw_faces(const View& view) {
    optical_depth().bind();
    const std::array<GLfloat, 4> none{};
    glClearBufferfv(GL_COLOR, 0, none.data());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    faces_.use();
    set_view(faces_, view);
    faces_.set("world_from_body", Mat4(Mat4::Identity()));
    faces_.set("reference", reference_);
    faces_.set("stop", stop_.colours[0], 0);
    vertices_.send(stream_);
    vertices_.draw();
    glDisable(GL_BLEND);
}

}  // namespace rhexis
