// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/piece_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rhexis {

namespace {

constexpr double pair_reach = 0.35;  ///< pairs are sought this far, the size of a fine tetrahedron [mm]
constexpr double facing = -0.2;      ///< cosine between normals above which surfaces do not face each other
constexpr double deepest = -0.3;     ///< overlap beyond this is of another side of the piece [mm]

/// Surface vertices sorted by the cell of a grid that they lie in.
class Cells {
public:
    Cells(const std::vector<Vec3>& points, double size) : size_(size) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            entries_.push_back({key(cell(points[i])), static_cast<int>(i)});
        }
        std::sort(entries_.begin(), entries_.end());
    }

    /// Visits what lies in the cells around each wanted point, the points in the order of their cells.
    template <typename Wanted, typename Visit>
    void for_each(const std::vector<Vec3>& points, const Wanted& wanted, const Visit& visit) const {
        std::array<std::size_t, 9> first{};  // of each row of three cells; they only go forward
        for (const auto& [own_cell, point] : entries_) {
            if (!wanted(point)) {
                continue;
            }
            const std::array<long, 3> middle = cell(points[point]);
            for (std::size_t row = 0; row < 9; ++row) {
                const long i = middle[0] + static_cast<long>(row / 3) - 1;
                const long j = middle[1] + static_cast<long>(row % 3) - 1;
                const std::uint64_t low = key({i, j, middle[2] - 1});
                const std::uint64_t high = key({i, j, middle[2] + 1});
                std::size_t& from = first[row];
                while (from < entries_.size() && entries_[from].first < low) {
                    ++from;
                }
                for (std::size_t e = from; e < entries_.size() && entries_[e].first <= high; ++e) {
                    visit(point, entries_[e].second);
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
    const double radius = pair_reach + std::min(moved, pair_reach);
    struct Nearest {
        int vertex = -1;
        double square = HUGE_VAL;
    };
    std::vector<Nearest> nearest(vertices.size());
    const auto wanted = [&](int v) { return !vertices[v].between; };  // else its two nodes are there for it
    Cells(points, radius).for_each(points, wanted, [&](int v, int w) {
        if (vertices[w].piece == vertices[v].piece) {
            return;
        }
        const double square = (points[v] - points[w]).squaredNorm();
        // of two equally near ones the lower: what is visited first does not matter
        const bool nearer = square < nearest[v].square || (square == nearest[v].square && w < nearest[v].vertex);
        if (square < radius * radius && nearer && normals[v].dot(normals[w]) < facing &&
            normals[w].dot(points[v] - points[w]) > deepest) {
            nearest[v] = {w, square};
        }
    });
    for (int v = 0; v < static_cast<int>(vertices.size()); ++v) {
        const int other = nearest[v].vertex;
        const bool both = other >= 0 && nearest[other].vertex == v;
        if (other >= 0 && !(both && other < v)) {
            pairs.push_back({v, other, normals[other]});
        }
    }
}

}  // namespace rhexis
