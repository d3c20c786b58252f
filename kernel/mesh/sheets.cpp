// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "mesh/shapes.hpp"

namespace rhexis {
namespace {

/// A row of nodes from left to right, and the next one above it.
struct Rows {
    int first;
    int count;
    int next_first;
    int next_count;
};

/// Triangles between two rows whose ends are at the same x: always the shorter diagonal.
void fill_between(const Rows& rows, TriMesh& mesh) {
    int low = 0;
    int high = 0;
    const auto x = [&](int node) { return mesh.nodes[static_cast<std::size_t>(node)].x(); };
    while (low + 1 < rows.count || high + 1 < rows.next_count) {
        const bool on_low = high + 1 == rows.next_count ||
                            (low + 1 < rows.count && std::abs(x(rows.first + low + 1) - x(rows.next_first + high)) <
                                                         std::abs(x(rows.next_first + high + 1) - x(rows.first + low)));
        if (on_low) {
            mesh.triangles.push_back({rows.first + low, rows.first + low + 1, rows.next_first + high});
            ++low;
        } else {
            mesh.triangles.push_back({rows.first + low, rows.next_first + high + 1, rows.next_first + high});
            ++high;
        }
    }
}

/// The direction at so many sixths of a turn from +x. Without trigonometry, so the same bits on every machine: along
/// the side of a hexagon, spaced by a rational tangent (to 1e-4 of an angle), then drawn to the circle.
Vec3 at_sixths(int sector, double share) {
    const double h = 0.5 * std::sqrt(3.0);
    const Vec3 corner[7] = {Vec3(1.0, 0.0, 0.0), Vec3(0.5, h, 0.0),  Vec3(-0.5, h, 0.0), Vec3(-1.0, 0.0, 0.0),
                            Vec3(-0.5, -h, 0.0), Vec3(0.5, -h, 0.0), Vec3(1.0, 0.0, 0.0)};
    constexpr double sixth = 1.0471975511965977;  // [rad]
    const double x = sixth * (share - 0.5);
    const double along = 0.5 + h * x * (15.0 - x * x) / (15.0 - 6.0 * x * x);
    return (corner[sector] + along * (corner[sector + 1] - corner[sector])).normalized();
}

}  // namespace

TriMesh square_sheet(double side, int triangles) {
    // rows r of edges e = side / n with r = n / (sqrt(3) / 2): 2 n r triangles, and one more in every other row
    const int n = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles * std::sqrt(3.0) / 4.0))));
    const int rows = std::max(2, static_cast<int>(std::lround(n * 2.0 / std::sqrt(3.0))));
    TriMesh mesh;
    std::vector<int> first;
    for (int row = 0; row <= rows; ++row) {
        first.push_back(static_cast<int>(mesh.nodes.size()));
        const bool shifted = row % 2 == 1;
        const double y = side * row / rows;
        if (shifted) {
            mesh.nodes.emplace_back(0.0, y, 0.0);
        }
        for (int i = 0; i <= (shifted ? n - 1 : n); ++i) {
            mesh.nodes.emplace_back(side * (i + (shifted ? 0.5 : 0.0)) / n, y, 0.0);
        }
        if (shifted) {
            mesh.nodes.emplace_back(side, y, 0.0);
        }
    }
    first.push_back(static_cast<int>(mesh.nodes.size()));
    for (std::size_t row = 0; row + 2 < first.size(); ++row) {
        fill_between({first[row], first[row + 1] - first[row], first[row + 1], first[row + 2] - first[row + 1]}, mesh);
    }
    return mesh;
}

TriMesh round_sheet(double radius, int triangles) {
    const int rings = std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 6.0))));
    TriMesh mesh;
    mesh.nodes.emplace_back(0.0, 0.0, 0.0);
    const auto node = [](int ring, int i) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring); };
    for (int ring = 1; ring <= rings; ++ring) {
        for (int i = 0; i < 6 * ring; ++i) {
            mesh.nodes.push_back(radius * ring / rings * at_sixths(i / ring, static_cast<double>(i % ring) / ring));
        }
        for (int sector = 0; sector < 6; ++sector) {
            for (int i = 0; i < ring; ++i) {
                const int outer = sector * ring + i;
                const int inner = sector * (ring - 1) + i;
                mesh.triangles.push_back({node(ring, outer), node(ring, outer + 1), node(ring - 1, inner)});
                if (i + 1 < ring) {
                    mesh.triangles.push_back({node(ring - 1, inner), node(ring, outer + 1), node(ring - 1, inner + 1)});
                }
            }
        }
    }
    return mesh;
}

TriMesh jittered(TriMesh sheet, double share, std::uint64_t seed) {
    const std::vector<std::uint8_t> edge = on_boundary(sheet, tri_neighbours(sheet));
    const double size = share * mean_edge(sheet);
    Rng rng(seed, "jittered sheet");
    for (std::size_t n = 0; n < sheet.nodes.size(); ++n) {
        const Vec2 way = 2.0 * uniform2(rng) - Vec2::Ones();
        if (edge[n] == 0) {
            sheet.nodes[n].head<2>() += size * way;
        }
    }
    return sheet;
}

}  // namespace rhexis
