// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/moving_gap.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/nearest_place.hpp"

namespace rhexis::scenes {
namespace {

constexpr int most_cells = 200000;
/// Of the largest way: more than what rounding makes of differences, a hundred halvings and a scalar product.
constexpr double rounding_share = 1e-13;

double thickness_of(double a, double b) { return a > 0.0 && b > 0.0 ? a + b : 2.0 * (a + b); }

/// What thickness asks for, less what is allowed of it.
double reach_of(double a, double b, double depth) { return std::max(0.0, a + b - depth * thickness_of(a, b)); }

const Vec3& when(const Mover& corner, std::size_t end) { return end == 0 ? corner.from : corner.to; }

/// The triangle as a square, one side of which is its first corner: first towards the opposite side, then along that.
std::size_t corner_at(std::size_t across, std::size_t along) { return across == 0 ? 0 : 1 + along; }

struct Cell {
    GapCube corner;
    double from = 0.0;  ///< of the first parameter
    double to = 1.0;
};

/// Whether all of it lies beyond its reach along the mean of its corners.
bool is_free(const GapCube& cube, double slack) {
    Vec3 along = Vec3::Zero();
    for (const GapCorner& corner : cube) {
        along += corner.way;
    }
    const double length = along.norm();
    return length > 0.0 && std::all_of(cube.begin(), cube.end(), [&](const GapCorner& corner) {
               return along.dot(corner.way) > length * (corner.reach + slack);
           });
}

/// Square of the greatest change of the way along a parameter.
double change_along(const GapCube& cube, std::size_t parameter) {
    const std::size_t bit = std::size_t{1} << parameter;
    double square = 0.0;
    for (std::size_t i = 0; i < 8; ++i) {
        if ((i & bit) == 0) {
            square = std::max(square, (cube[i | bit].way - cube[i].way).squaredNorm());
        }
    }
    return square;
}

Cell half_of(const Cell& cell, std::size_t parameter, bool upper) {
    const std::size_t bit = std::size_t{1} << parameter;
    Cell half = cell;
    for (std::size_t i = 0; i < 8; ++i) {
        if ((i & bit) == 0) {
            GapCorner& moved = half.corner[upper ? i : i | bit];
            moved.way = 0.5 * (cell.corner[i].way + cell.corner[i | bit].way);
            moved.reach = 0.5 * (cell.corner[i].reach + cell.corner[i | bit].reach);
        }
    }
    if (parameter == 0) {
        (upper ? half.from : half.to) = 0.5 * (cell.from + cell.to);
    }
    return half;
}

double share_of(double part, double whole) { return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0; }

double apart_by(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, double along) {
    const Vec3 place = p + along * (q - p);
    const double other = share_of((b - a).dot(place - a), (b - a).squaredNorm());
    return (a + other * (b - a) - place).norm();
}

}  // namespace

GapCube corner_to_triangle(const Mover& corner, const std::array<Mover, 3>& triangle, double depth) {
    GapCube cube;
    for (std::size_t i = 0; i < 8; ++i) {
        const Mover& other = triangle[corner_at(i >> 1 & 1, i >> 2 & 1)];
        cube[i] = {when(corner, i & 1) - when(other, i & 1), reach_of(corner.half, other.half, depth)};
    }
    return cube;
}

GapCube edge_to_edge(const std::array<Mover, 2>& a, const std::array<Mover, 2>& b, double depth) {
    GapCube cube;
    for (std::size_t i = 0; i < 8; ++i) {
        const Mover& own = a[i >> 1 & 1];
        const Mover& other = b[i >> 2 & 1];
        cube[i] = {when(own, i & 1) - when(other, i & 1), reach_of(own.half, other.half, depth)};
    }
    return cube;
}

GapCube edge_to_triangle(const std::array<Mover, 2>& edge, const std::array<Mover, 3>& triangle) {
    GapCube cube;
    for (std::size_t i = 0; i < 8; ++i) {
        cube[i] = {edge[i & 1].from - triangle[corner_at(i >> 1 & 1, i >> 2 & 1)].from, 0.0};
    }
    return cube;
}

// Depth first: one place that cannot be told is enough.
Verdict stays_apart(const GapCube& cube, double resolution) {
    double largest = 0.0;
    for (const GapCorner& corner : cube) {
        largest = std::max(largest, corner.way.lpNorm<Eigen::Infinity>());
    }
    const double slack = rounding_share * largest;
    if (is_free(cube, slack)) {
        return {};
    }
    std::vector<Cell> left{{cube}};
    for (int cells = 0; !left.empty(); ++cells) {
        const Cell cell = left.back();
        left.pop_back();
        if (is_free(cell.corner, slack)) {
            continue;
        }
        const std::array<double, 3> change{change_along(cell.corner, 0), change_along(cell.corner, 1),
                                           change_along(cell.corner, 2)};
        const auto most = std::max_element(change.begin(), change.end());
        if (!(*most > resolution * resolution) || cells == most_cells) {
            return {false, cell.from};
        }
        const std::size_t parameter = static_cast<std::size_t>(most - change.begin());
        left.push_back(half_of(cell, parameter, true));
        left.push_back(half_of(cell, parameter, false));
    }
    return {};
}

double end_distance(const Mover& corner, const std::array<Mover, 3>& triangle) {
    const std::array<Vec3, 3> places{triangle[0].to, triangle[1].to, triangle[2].to};
    return (place_in(places, nearest_to_point(places, corner.to)) - corner.to).norm();
}

/// Where the lines come nearest to each other, and from the ends.
double end_distance(const std::array<Mover, 2>& a, const std::array<Mover, 2>& b) {
    const Vec3& p = a[0].to;
    const Vec3& q = a[1].to;
    const Vec3& r = b[0].to;
    const Vec3& s = b[1].to;
    const Vec3 own = q - p;
    const Vec3 other = s - r;
    const double mixed = own.dot(other);
    const double square = own.squaredNorm() * other.squaredNorm() - mixed * mixed;
    const double inner = other.squaredNorm() * own.dot(r - p) - mixed * other.dot(r - p);
    return std::min({apart_by(p, q, r, s, share_of(inner, square)), apart_by(p, q, r, s, 0.0),
                     apart_by(p, q, r, s, 1.0), apart_by(r, s, p, q, 0.0), apart_by(r, s, p, q, 1.0)});
}

bool changed_sides(const std::array<Mover, 4>& corners) {
    const auto volume = [&](std::size_t end) {
        const Vec3& origin = when(corners[0], end);
        return (when(corners[1], end) - origin)
            .cross(when(corners[2], end) - origin)
            .dot(when(corners[3], end) - origin);
    };
    return (volume(0) > 0.0) != (volume(1) > 0.0);
}

}  // namespace rhexis::scenes
