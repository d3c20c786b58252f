// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/piece_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rhexis {

namespace {

constexpr double reach = 0.35;    ///< pairs are sought this far, the size of a fine tetrahedron [mm]
constexpr double facing = -0.2;   ///< cosine between normals above which surfaces do not face each other
constexpr double deepest = -0.3;  ///< overlap beyond this is of another side of the piece [mm]

/// Surface vertices sorted by the cell of a grid that they lie in.
class Cells {
public:
    Cells(const std::vector<Vec3>& points, double size) : size_(size) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            entries_.push_back({key(cell(points[i])), static_cast<int>(i)});
        }
        std::sort(entries_.begin(), entries_.end());
    }

    template <typename Visit>
    void near(const Vec3& point, const Visit& visit) const {
        const std::array<long, 3> middle = cell(point);
        for (long i = -1; i <= 1; ++i) {
            for (long j = -1; j <= 1; ++j) {
                for (long k = -1; k <= 1; ++k) {
                    const std::uint64_t wanted = key({middle[0] + i, middle[1] + j, middle[2] + k});
                    const std::pair<std::uint64_t, int> lowest{wanted, -1};
                    for (auto entry = std::lower_bound(entries_.begin(), entries_.end(), lowest);
                         entry != entries_.end() && entry->first == wanted; ++entry) {
                        visit(entry->second);
                    }
                }
            }
        }
    }

private:
    [[nodiscard]] std::array<long, 3> cell(const Vec3& p) const {
        return {std::lround(p.x() / size_), std::lround(p.y() / size_), std::lround(p.z() / size_)};
    }
    static std::uint64_t key(const std::array<long, 3>& c) {
        std::uint64_t sum = 0;
        for (const long i : c) {
            sum = (sum << 21) | (static_cast<std::uint64_t>(i + (1 << 20)) & 0x1fffff);
        }
        return sum;
    }

    double size_;
    std::vector<std::pair<std::uint64_t, int>> entries_;
};

}  // namespace

void find_piece_pairs(const ContactSurface& surface, const std::vector<Vec3>& nodes, double moved,
                      std::vector<PiecePair>& pairs) {
    pairs.clear();
    if (!surface.in_pieces()) {
        return;
    }
    const std::vector<SurfaceVertex>& vertices = surface.vertices();
    std::vector<Vec3> points;
    points.reserve(vertices.size());
    for (const SurfaceVertex& vertex : vertices) {
        points.push_back(point_of(vertex, nodes));
    }
    std::vector<Vec3> normals;
    surface.normals(nodes, normals);
    const double radius = reach + std::min(moved, reach);
    const Cells cells(points, radius);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (vertices[v].between) {
            continue;  // its two nodes are there for it
        }
        double nearest = radius * radius;
        int found = -1;
        cells.near(points[v], [&](int w) {
            const double square = (points[v] - points[w]).squaredNorm();
            if (vertices[w].piece != vertices[v].piece && square < nearest && normals[v].dot(normals[w]) < facing &&
                normals[w].dot(points[v] - points[w]) > deepest) {
                nearest = square;
                found = w;
            }
        });
        if (found >= 0) {
            pairs.push_back({static_cast<int>(v), found, normals[found]});
        }
    }
}

}  // namespace rhexis
