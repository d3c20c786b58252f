// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/medium_clip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/eye_balls.hpp"
#include "render/vertex_floats.hpp"

namespace rhexis {

namespace {

constexpr double shortest_mm = 4.0;  ///< sides that are not split any more

struct Corner {
    ToolMesh::Vertex vertex;
    double outside = 0.0;  ///< distance from the eye's wall, negative inside [mm]
};

struct Clip {
    Medium medium;
    Vec4 cornea;
    Vec4 globe;
    const Pose& pose;
    std::vector<float>& stream;

    [[nodiscard]] Corner at(const ToolMesh::Vertex& vertex) const {
        const Vec3 place = pose.to_world(vertex.place);
        const auto beyond = [&](const Vec4& ball) { return (place - ball.head<3>()).norm() - ball.w(); };
        return {vertex, std::min(beyond(cornea), beyond(globe))};
    }

    void append(const std::array<Corner, 3>& corners) const {
        for (const Corner& corner : corners) {
            append_floats(corner.vertex.place, stream);
            append_floats(corner.vertex.normal, stream);
        }
    }

    /// A place of a triangle is at most its longest side over the square root of 3 from a corner, and distances from
    /// the wall differ by no more than that.
    void add(const std::array<Corner, 3>& corners) const {
        int longest = 0;
        std::array<double, 3> sides;
        for (int i = 0; i < 3; ++i) {
            sides[i] = (corners[(i + 1) % 3].vertex.place - corners[i].vertex.place).norm();
            longest = sides[i] > sides[longest] ? i : longest;
        }
        const double reach = sides[longest] / std::sqrt(3.0);
        const auto [least, most] = std::minmax({corners[0].outside, corners[1].outside, corners[2].outside});
        const bool elsewhere = medium == Medium::inside ? least > reach : most < -reach;
        const bool here = medium == Medium::inside ? most < -reach : least > reach;
        if (elsewhere) {
            return;
        }
        if (here || sides[longest] < shortest_mm) {
            append(corners);
            return;
        }
        const Corner& a = corners[longest];
        const Corner& b = corners[(longest + 1) % 3];
        const Corner& c = corners[(longest + 2) % 3];
        const Corner middle = at({0.5 * (a.vertex.place + b.vertex.place), 0.5 * (a.vertex.normal + b.vertex.normal)});
        add({a, middle, c});
        add({middle, b, c});
    }
};

}  // namespace

void append_triangles_in(Medium medium, const EyeAnatomy& eye, const Pose& pose, const ToolMesh::Part& part,
                         std::vector<float>& stream) {
    const Clip clip{medium, cornea_ball(eye), globe_ball(eye), pose, stream};
    for (std::size_t i = 0; i + 2 < part.corners.size(); i += 3) {
        clip.add({clip.at(part.corners[i]), clip.at(part.corners[i + 1]), clip.at(part.corners[i + 2])});
    }
}

}  // namespace rhexis
