// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/depth_pass.hpp"

#include <algorithm>

#include "render/still_lens.hpp"

namespace rhexis {

namespace {

constexpr float seen_extinction = 1e-4F;  ///< changes below are not seen [1/mm]

/// About the middle of all bodies, on a grid: distances are measured from there, so that their sums lose few digits,
/// and it stays while bodies sway.
Vec3 middle_of(const Frame& frame) {
    Vec3 sum = Vec3::Zero();
    double count = 0.0;
    for (const SolidState& solid : frame.solids) {
        for (const Vec3& node : solid.position) {
            sum += node;
            count += 1.0;
        }
    }
    constexpr double grid = 0.5;  // [mm]
    return count > 0.0 && sum.allFinite() ? Vec3(grid * (sum / (grid * count)).array().round()) : Vec3(Vec3::Zero());
}

/// Of all tissues that take light out [1/mm].
std::vector<Vec3> extinctions_of(const Frame& frame) {
    std::vector<Vec3> all;
    for (const SolidModel& solid : frame.model->solids) {
        for (const Material& material : solid.materials) {
            all.push_back(material.extinction);
        }
    }
    if (const std::optional<StillLens> lens = still_lens(frame)) {
        for (const LensZone& zone : lens->zones) {
            all.push_back(zone.extinction);
        }
    }
    return all;
}

/// Sends a part of numbers that lie row by row.
void send(const Texture& texture, const std::vector<float>& numbers, int channels, const PixelRect& area) {
    if (area.empty()) {
        return;
    }
    glBindTexture(GL_TEXTURE_2D, *texture.name);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, texture.width);
    const std::size_t first = channels * (static_cast<std::size_t>(area.y) * texture.width + area.x);
    glTexSubImage2D(GL_TEXTURE_2D, 0, area.x, area.y, area.width, area.height, channels == 1 ? GL_RED : GL_RGB,
                    GL_FLOAT, &numbers[first]);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
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

DepthPass::DepthPass(int width, int height, bool keeps)
    : keeps_(keeps),
      raster_(width, height),
      sum_(make_texture(width, height, GL_RGB32F, GL_NEAREST)),
      grey_sum_(make_texture(width, height, GL_R32F, GL_NEAREST)),
      stop_(make_texture(width, height, GL_R32F, GL_NEAREST)) {
    glBindTexture(GL_TEXTURE_2D, *grey_sum_.name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_RED);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, GL_RED);
}

void DepthPass::draw(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
                     const PixelRect& tool_area, const PixelRect& body_area) {
    find_tint(frame);
    reference_ = middle_of(frame);
    stream_.clear();
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        append_signed_faces(frame.model->solids[i], frame.solids[i], fine_, stream_);
    }
    if (const std::optional<StillLens> lens = still_lens(frame)) {
        append_signed_faces(*lens, stream_);
    }
    raster_.look(view, reference_);
    const PixelRect before = tools_;
    tools_ = draw_tools(frame, tools, view, tool_area);
    changed_ = keeps_ && is_still(view, body_area) ? intersected(body_area, united(before, tools_)) : body_area;
    if (changed_.empty()) {
        return;
    }
    raster_.clear_sum(changed_, grey_ ? 1 : 3);
    raster_.add(stream_, changed_);
    send(optical_depth(), raster_.sum(), raster_.channels(), changed_);
}

/// Whether the bodies are seen as in the picture before; where they are not, they count as drawn now.
bool DepthPass::is_still(const View& view, const PixelRect& body_area) {
    const auto alike = [](const SignedFace& a, const SignedFace& b) {
        return (a.change - b.change).cwiseAbs().maxCoeff() <= seen_extinction &&
               (a.corners[0] - b.corners[0]).cwiseAbs().maxCoeff() <= seen_mm &&
               (a.corners[1] - b.corners[1]).cwiseAbs().maxCoeff() <= seen_mm &&
               (a.corners[2] - b.corners[2]).cwiseAbs().maxCoeff() <= seen_mm;
    };
    const DrawnFrom from{view.clip_from_world, body_area, reference_};
    const int channels = grey_ ? 1 : 3;
    const bool still = from == drawn_.from && channels == drawn_.channels &&
                       std::equal(stream_.begin(), stream_.end(), drawn_.faces.begin(), drawn_.faces.end(), alike);
    if (!still) {
        drawn_ = {from, channels, stream_};
    }
    return still;
}

void DepthPass::find_tint(const Frame& frame) {
    const std::vector<Vec3> extinctions = extinctions_of(frame);
    Vec3 strongest = Vec3::Zero();
    for (const Vec3& extinction : extinctions) {
        strongest = extinction.norm() > strongest.norm() ? extinction : strongest;
    }
    grey_ = strongest.x() > 0.0;
    for (const Vec3& extinction : extinctions) {
        const double off = extinction.cross(strongest).norm();
        grey_ = grey_ && off <= 1e-12 * strongest.squaredNorm();
    }
    tint_ = grey_ ? Vec3(strongest / strongest.x()) : Vec3(Vec3::Ones());
}

PixelRect DepthPass::draw_tools(const Frame& frame, const std::vector<ToolMesh>& tools, const View& view,
                                const PixelRect& area) {
    PixelRect covered;
    raster_.clear_stop(area);
    for (std::size_t i = 0; i < frame.tools.size(); ++i) {
        if (!frame.tools[i].present) {
            continue;
        }
        corners_.clear();
        for (const ToolMesh::Part& part : tools[i].parts) {
            const Pose pose = pose_of(part, frame.tools[i]);
            for (const ToolMesh::Vertex& corner : part.corners) {
                corners_.push_back(pose.to_world(corner.place));
            }
        }
        raster_.stop_at(corners_, area);
        covered = united(covered, rect_around(view, corners_, 2));
    }
    send(stop_, raster_.stop(), 1, area);
    return covered;
}

}  // namespace rhexis
