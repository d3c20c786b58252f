// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/penetration.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "scenes/skin_pairs.hpp"

namespace rhexis::scenes {
namespace {

constexpr double resolution_share = 1e-3;  // of the thickness that two places have together
constexpr double solid_resolution = 0.15;  // likewise, against what is rigid: parts grow with its inverse cube,
constexpr double solid_depth = 0.1;        // so that less than this depth is not told from none
constexpr double least_resolution = 1e-6;  // [mm]
constexpr int most_parts = 400000;         // of a triangle against what is rigid

double resolution_for(double halves, double share = resolution_share) { return share * halves + least_resolution; }

double mean_edge_of(const MovingSkin& skin) {
    double sum = 0.0;
    for (const std::array<int, 3>& n : skin.skin.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            sum += (skin.to[at(n[k])] - skin.to[at(n[(k + 1) % 3])]).norm();
        }
    }
    return sum / (3.0 * static_cast<double>(skin.skin.triangles.size()));
}

/// What two parts of surfaces have to do with each other.
struct Pair {
    double halves = 0.0;     ///< thickness to their touching, at most [mm]
    double thickness = 0.0;  ///< [mm]
    bool layers = true;      ///< else neighbours, which only may not cross
};

/// The least depth to which a pair is proven free; adds what was found.
template <class CubeOf, class EndDistance>
void judge_pair(const Pair& pair, const CubeOf& cube_of, const EndDistance& end_distance, bool sides_changed,
                double edge, StepFinding& found) {
    ++found.pairs;
    const double resolution = resolution_for(pair.layers ? pair.halves : 0.0);
    std::size_t level = pair.layers ? 0 : depths_tried.size() - 1;
    Verdict verdict;
    while (level < depths_tried.size() && !(verdict = stays_apart(cube_of(depths_tried[level]), resolution)).apart) {
        ++level;
    }
    const bool crossed = level == depths_tried.size();
    if (level == 0 || (!pair.layers && !crossed)) {
        return;
    }
    found.level = std::max(found.level, level);
    found.crossing += crossed ? 1 : 0;
    found.since = crossed ? std::min(found.since, verdict.since) : found.since;
    const double distance = end_distance();
    const double deep = pair.halves + (crossed && sides_changed ? distance : -distance);
    if (deep > found.deepest) {
        found.deepest = deep;
        found.of_thickness = pair.thickness > 0.0 ? deep / pair.thickness : 0.0;
        found.of_edge = deep / edge;
    }
}

double thickest(const Mover& a, const Mover& b) { return std::max(a.half, b.half); }

Pair pair_of(double a, double b, bool layers) { return {a + b, a > 0.0 && b > 0.0 ? a + b : 2.0 * (a + b), layers}; }

void judge_corner(const MovingSkin& own, int corner, const MovingSkin& other, int triangle, double edge,
                  StepFinding& found) {
    const bool same = &own == &other;
    const std::array<int, 3>& n = other.skin.triangles[at(triangle)];
    if (same && shares_place(own.skin, {{corner, -1}}, n)) {
        return;
    }
    const Mover point = mover(own, corner);
    const std::array<Mover, 3> face = movers(other, n);
    const bool layers = !same || !near_triangle(own.skin, {{corner, -1}}, triangle);
    const double half = std::max(thickest(face[0], face[1]), face[2].half);
    judge_pair(
        pair_of(point.half, half, layers), [&](double depth) { return corner_to_triangle(point, face, depth); },
        [&] { return end_distance(point, face); }, changed_sides({point, face[0], face[1], face[2]}), edge, found);
}

void judge_edges(const MovingSkin& own, const SkinEdge& a, const MovingSkin& other, const SkinEdge& b, double edge,
                 StepFinding& found) {
    const bool same = &own == &other;
    if (same && shares_place(own.skin, a.corners, {b.corners[0], b.corners[1], -1})) {
        return;
    }
    const std::array<Mover, 2> first{mover(own, a.corners[0]), mover(own, a.corners[1])};
    const std::array<Mover, 2> second{mover(other, b.corners[0]), mover(other, b.corners[1])};
    const bool layers =
        !same || !(near_triangle(own.skin, a.corners, b.triangle) || near_triangle(own.skin, b.corners, a.triangle));
    judge_pair(
        pair_of(thickest(first[0], first[1]), thickest(second[0], second[1]), layers),
        [&](double depth) { return edge_to_edge(first, second, depth); }, [&] { return end_distance(first, second); },
        changed_sides({first[0], first[1], second[0], second[1]}), edge, found);
}

StepFinding judge_all(const MovingSkin& a, const MovingSkin& b) {
    StepFinding found;
    const double edge = mean_edge_of(a);
    const SkinParts parts_of_a(a.skin);
    const SkinParts parts_of_b(b.skin);
    near_triangles(a, b, [&](int s, int t) {
        for (const int corner : parts_of_a.corners(s)) {
            judge_corner(a, corner, b, t, edge, found);
        }
        for (const int corner : parts_of_b.corners(t)) {
            judge_corner(b, corner, a, s, edge, found);
        }
        for (const SkinEdge& own : parts_of_a.edges(s)) {
            for (const SkinEdge& other : parts_of_b.edges(t)) {
                judge_edges(a, own, b, other, edge, found);
            }
        }
    });
    return found;
}

int pierced_by(const MovingSkin& own, const MovingSkin& other, int triangle, const SkinEdge& edge) {
    const std::array<int, 3>& n = other.skin.triangles[at(triangle)];
    if (&own == &other && shares_place(own.skin, edge.corners, n)) {
        return 0;
    }
    const std::array<Mover, 2> ends{mover(own, edge.corners[0]), mover(own, edge.corners[1])};
    return stays_apart(edge_to_triangle(ends, movers(other, n)), least_resolution).apart ? 0 : 1;
}

int pierced(const MovingSkin& a, const MovingSkin& b) {
    int count = 0;
    const SkinParts parts_of_a(a.skin);
    const SkinParts parts_of_b(b.skin);
    near_triangles(a, b, [&](int s, int t) {
        for (const SkinEdge& edge : parts_of_a.edges(s)) {
            count += pierced_by(a, b, t, edge);
        }
        for (const SkinEdge& edge : parts_of_b.edges(t)) {
            count += pierced_by(b, a, s, edge);
        }
    });
    return count;
}

/// A part of a triangle for a part of the step.
struct Prism {
    std::array<Mover, 3> corner;
    double from = 0.0;
    double to = 1.0;
};

/// About all of a prism.
struct PrismBall {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
    double half = 0.0;    ///< thickness, at most
    double middle = 0.0;  ///< in its centre
};

PrismBall ball_about(const Prism& prism) {
    PrismBall ball;
    for (const Mover& corner : prism.corner) {
        ball.centre += (corner.from + corner.to) / 6.0;
        ball.half = std::max(ball.half, corner.half);
        ball.middle += corner.half / 3.0;
    }
    for (const Mover& corner : prism.corner) {
        ball.radius = std::max({ball.radius, (corner.from - ball.centre).norm(), (corner.to - ball.centre).norm()});
    }
    return ball;
}

Mover half_way(const Mover& a, const Mover& b) {
    return {0.5 * (a.from + b.from), 0.5 * (a.to + b.to), 0.5 * (a.half + b.half)};
}

std::array<Prism, 2> halves_in_time(const Prism& prism) {
    std::array<Prism, 2> halves{prism, prism};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 middle = 0.5 * (prism.corner[k].from + prism.corner[k].to);
        halves[0].corner[k].to = middle;
        halves[1].corner[k].from = middle;
    }
    halves[0].to = halves[1].from = 0.5 * (prism.from + prism.to);
    return halves;
}

/// Across its longest edge.
std::array<Prism, 2> halves_in_space(const Prism& prism, std::size_t longest) {
    const std::size_t next = (longest + 1) % 3;
    const Mover middle = half_way(prism.corner[longest], prism.corner[next]);
    std::array<Prism, 2> halves{prism, prism};
    halves[0].corner[next] = middle;
    halves[1].corner[longest] = middle;
    return halves;
}

std::array<Prism, 2> halves_of(const Prism& prism, double solid_travel) {
    double travel = 0.0;
    double length = 0.0;
    std::size_t longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        travel = std::max(travel, (prism.corner[k].to - prism.corner[k].from).norm());
        const double own = (prism.corner[k].from - prism.corner[(k + 1) % 3].from).norm();
        longest = own > length ? k : longest;
        length = std::max(length, own);
    }
    return travel + solid_travel * (prism.to - prism.from) > length ? halves_in_time(prism)
                                                                    : halves_in_space(prism, longest);
}

/// Whether a triangle keeps its thickness less a depth from what is rigid.
Verdict keeps_from(const MovingSolid& solid, const Prism& whole, double depth, double resolution) {
    std::vector<Prism> left{whole};
    for (int parts = 0; !left.empty(); ++parts) {
        const Prism prism = left.back();
        left.pop_back();
        const PrismBall ball = ball_about(prism);
        const double kept = std::max(0.0, 1.0 - 2.0 * depth);  // of the thickness on a side
        const double distance = solid.distance(0.5 * (prism.from + prism.to), ball.centre);
        const double around = ball.radius + 0.5 * solid.travel * (prism.to - prism.from);
        if (distance > kept * ball.half + around * (1.0 + 1e-9)) {
            continue;
        }
        if (distance <= kept * ball.middle || around < resolution || parts == most_parts) {
            return {false, prism.from};
        }
        const std::array<Prism, 2> halves = halves_of(prism, solid.travel);
        left.push_back(halves[1]);
        left.push_back(halves[0]);
    }
    return {};
}

}  // namespace

void StepFinding::add(const StepFinding& other) {
    level = std::max(level, other.level);
    crossing += other.crossing;
    since = std::min(since, other.since);
    pairs += other.pairs;
    if (other.of_thickness > of_thickness || (of_thickness == 0.0 && other.deepest > deepest)) {
        deepest = other.deepest;
        of_thickness = other.of_thickness;
        of_edge = other.of_edge;
    }
}

StepFinding verify_itself(const MovingSkin& skin) { return judge_all(skin, skin); }

StepFinding verify_pair(const MovingSkin& a, const MovingSkin& b) { return judge_all(a, b); }

StepFinding verify_solid(const MovingSkin& skin, const MovingSolid& solid) {
    StepFinding found;
    const double edge = mean_edge_of(skin);
    for (const std::array<int, 3>& n : skin.skin.triangles) {
        const Prism whole{movers(skin, n)};
        const double half = ball_about(whole).half;
        const double resolution = resolution_for(half, solid_resolution);
        Verdict verdict;
        std::size_t level = 0;
        while (level < depths_tried.size() &&
               !(verdict = keeps_from(solid, whole, depths_tried[level], resolution)).apart) {
            do {
                ++level;
            } while (level < depths_tried.size() && depths_tried[level] < solid_depth);
        }
        found.pairs += level > 0 ? 1 : 0;
        found.level = std::max(found.level, level);
        if (level == depths_tried.size()) {
            ++found.crossing;
            found.since = std::min(found.since, verdict.since);
        }
        for (std::size_t k = 0; level > 0 && k < 3; ++k) {
            const double deep = whole.corner[k].half - solid.distance(1.0, whole.corner[k].to);
            if (deep > found.deepest) {
                found.deepest = deep;
                found.of_thickness = deep / std::max(2.0 * whole.corner[k].half, least_resolution);
                found.of_edge = deep / edge;
            }
        }
    }
    return found;
}

int pierced_at_start(const MovingSkin& skin) { return pierced(skin, skin); }

int pierced_at_start(const MovingSkin& a, const MovingSkin& b) { return pierced(a, b); }

}  // namespace rhexis::scenes
