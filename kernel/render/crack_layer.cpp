// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/crack_layer.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "render/depth_pass.hpp"
#include "render/vertex_floats.hpp"

namespace rhexis {

namespace {

constexpr double crack_depth_mm = 1.0;  ///< deeper ones look no deeper. Proposal
constexpr double ribbon_mm = 0.30;      ///< half the width of what is drawn along a crack
constexpr int smoothings = 8;           ///< of the way of a crack, which the mesh makes a zigzag

using CrackFace = std::array<int, 3>;

/// The face that two tetrahedra had in common, in the first one's nodes. Nodes that came apart were copied: they lay in
/// one place at rest.
std::optional<CrackFace> common_face(const TetMesh& mesh, const BrokenFace& broken) {
    const std::array<int, 4>& here = mesh.tets[broken[0]];
    const std::array<int, 4>& there = mesh.tets[broken[1]];
    for (const std::array<int, 3>& local : tet_faces) {
        const CrackFace face{here[local[0]], here[local[1]], here[local[2]]};
        const bool shared = std::all_of(face.begin(), face.end(), [&](int node) {
            return std::any_of(there.begin(), there.end(),
                               [&](int other) { return mesh.nodes[other] == mesh.nodes[node]; });
        });
        if (shared) {
            return face;
        }
    }
    return std::nullopt;
}

bool has_tissue_on_both_sides(const SolidModel& model, const SolidState& state, const BrokenFace& broken) {
    constexpr double enough = 0.05;
    return std::all_of(broken.begin(), broken.end(),
                       [&](int tet) { return remaining_fraction(model, state, tet) > enough; });
}

std::vector<CrackFace> crack_faces(const SolidModel& model, const SolidState& state) {
    std::vector<CrackFace> faces;
    for (const BrokenFace& broken : state.broken) {
        if (has_tissue_on_both_sides(model, state, broken)) {
            if (const std::optional<CrackFace> face = common_face(model.coarse, broken)) {
                faces.push_back(*face);
            }
        }
    }
    return faces;
}

/// Places of the nodes of faces, each drawn to the mean of its neighbours.
std::map<int, Vec3> smoothed(const std::vector<CrackFace>& faces, const std::vector<Vec3>& positions) {
    std::map<int, Vec3> places;
    for (const CrackFace& face : faces) {
        for (int node : face) {
            places.emplace(node, positions[node]);
        }
    }
    for (int round = 0; round < smoothings; ++round) {
        std::map<int, std::pair<Vec3, double>> sums;
        for (const CrackFace& face : faces) {
            for (int i = 0; i < 3; ++i) {
                auto& [sum, count] = sums.try_emplace(face[i], Vec3(Vec3::Zero()), 0.0).first->second;
                sum += places.at(face[(i + 1) % 3]) + places.at(face[(i + 2) % 3]);
                count += 2.0;
            }
        }
        for (auto& [node, place] : places) {
            const auto& [sum, count] = sums.at(node);
            place = 0.5 * (place + sum / count);
        }
    }
    return places;
}

/// A ribbon along the longest side of a face as it is seen, through its middle: the deeper the face reaches along the
/// line of sight, the stronger.
void append_ribbon(const std::array<Vec3, 3>& corners, const Vec3& axis, std::vector<float>& stream) {
    const auto across = [&](const Vec3& way) { return Vec3(way - way.dot(axis) * axis); };
    Vec3 along = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        const Vec3 side = across(corners[(i + 1) % 3] - corners[i]);
        along = side.norm() > along.norm() ? side : along;
    }
    const double length = along.norm();
    if (!(length > 1e-6)) {
        return;
    }
    const double area = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    const double seen = 0.5 * std::abs((corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(axis));
    const double depth = std::sqrt(std::max(0.0, area * area - seen * seen)) / length;
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const Vec3 out = axis.cross(along) / length;
    const auto corner = [&](double way, double beyond) {
        append_floats(middle + 0.75 * way * along + beyond * out, stream);
        append_floats(Vec3(depth / crack_depth_mm, beyond, 0.0), stream);
    };
    for (const auto& [way, beyond] :
         {std::pair(-1.0, -ribbon_mm), std::pair(1.0, -ribbon_mm), std::pair(1.0, ribbon_mm),
          std::pair(-1.0, -ribbon_mm), std::pair(1.0, ribbon_mm), std::pair(-1.0, ribbon_mm)}) {
        corner(way, beyond);
    }
}

}  // namespace

bool has_cracks(const Frame& frame) {
    return std::any_of(frame.solids.begin(), frame.solids.end(),
                       [](const SolidState& solid) { return !solid.broken.empty(); });
}

Result<CrackLayer> CrackLayer::create(int width, int height) {
    Result<Program> program = Program::build({"crack.vert"}, {"crack.frag"});
    return program ? Result<CrackLayer>(CrackLayer(std::move(program).value(), width, height)) : program.error();
}

void CrackLayer::draw(const Frame& frame, const View& view, const Texture& stop, const Vec3& reference,
                      const PixelRect& area) {
    stream_.clear();
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        const std::vector<CrackFace> faces = crack_faces(frame.model->solids[i], frame.solids[i]);
        const std::map<int, Vec3> places = smoothed(faces, frame.solids[i].position);
        for (const CrackFace& face : faces) {
            append_ribbon({places.at(face[0]), places.at(face[1]), places.at(face[2])}, view.axis, stream_);
        }
    }
    const Scissor scissor(area);
    lines_.bind();
    const std::array<GLfloat, 4> none{};
    glClearBufferfv(GL_COLOR, 0, none.data());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    program_.use();
    set_view(program_, view);
    program_.set("reference", reference);
    program_.set("stop", stop, 0);
    vertices_.send(stream_);
    vertices_.draw();
    glDisable(GL_BLEND);
}

}  // namespace rhexis
