// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rhexis {

namespace {

std::array<double, 4> face_areas(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return {0.5 * (c - b).cross(d - b).norm(), 0.5 * (d - a).cross(c - a).norm(), 0.5 * (b - a).cross(d - a).norm(),
            0.5 * (c - a).cross(b - a).norm()};
}

}  // namespace

double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a;
    const Vec3 v = c - a;
    const Vec3 w = d - a;
    const double six_volumes = u.cross(v).dot(w);
    const std::array<double, 4> area = face_areas(a, b, c, d);
    const double inscribed = 0.5 * six_volumes / (area[0] + area[1] + area[2] + area[3]);
    const Vec3 numerator = u.squaredNorm() * v.cross(w) + v.squaredNorm() * w.cross(u) + w.squaredNorm() * u.cross(v);
    const double circumscribed = numerator.norm() / (2.0 * std::abs(six_volumes));
    return six_volumes == 0.0 ? 0.0 : 3.0 * inscribed / circumscribed;
}

double shortest_height(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const std::array<double, 4> area = face_areas(a, b, c, d);
    return 3.0 * tet_volume(a, b, c, d) / *std::max_element(area.begin(), area.end());
}

MeshQuality mesh_quality(const TetMesh& mesh) {
    MeshQuality result;
    if (mesh.tets.empty()) {
        return result;
    }
    result.min_ratio = std::numeric_limits<double>::infinity();
    result.min_height = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        std::array<Vec3, 4> x;
        for (std::size_t k = 0; k < 4; ++k) {
            x[k] = mesh.nodes[static_cast<std::size_t>(mesh.tets[t][k])];
        }
        const double ratio = radius_ratio(x[0], x[1], x[2], x[3]);
        result.mean_ratio += ratio;
        if (ratio < result.min_ratio) {
            result.min_ratio = ratio;
            result.worst = static_cast<int>(t);
        }
        result.min_height = std::min(result.min_height, shortest_height(x[0], x[1], x[2], x[3]));
        result.volume += tet_volume(x[0], x[1], x[2], x[3]);
    }
    result.mean_ratio /= static_cast<double>(mesh.tets.size());
    return result;
}

}  // namespace rhexis
