// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/skin_pairs.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "base/index.hpp"

namespace rhexis::scenes {
namespace {

struct SweptBox {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
    Vec3 high = Vec3::Constant(std::numeric_limits<double>::lowest());
    bool of_b = false;
    int triangle = 0;
};

void add_boxes(const MovingSkin& skin, bool of_b, std::vector<SweptBox>& boxes) {
    for (std::size_t t = 0; t < skin.skin.triangles.size(); ++t) {
        SweptBox box;
        double half = 0.0;
        for (const int corner : skin.skin.triangles[t]) {
            half = std::max(half, skin.skin.half[at(corner)]);
            for (const Vec3& place : {skin.from[at(corner)], skin.to[at(corner)]}) {
                box.low = box.low.cwiseMin(place);
                box.high = box.high.cwiseMax(place);
            }
        }
        // more than the rounding of what is compared
        const double around = half + 1e-9;
        box.low -= Vec3::Constant(around);
        box.high += Vec3::Constant(around);
        box.of_b = of_b;
        box.triangle = static_cast<int>(t);
        boxes.push_back(box);
    }
}

bool meet(const SweptBox& a, const SweptBox& b) {
    return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace

SkinParts::SkinParts(const Skin& skin) : corners_(skin.triangles.size()), edges_(skin.triangles.size()) {
    std::vector<std::uint8_t> taken(skin.half.size(), 0);
    std::map<std::pair<int, int>, int> known;
    for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
        const std::array<int, 3>& n = skin.triangles[t];
        for (std::size_t k = 0; k < 3; ++k) {
            if (taken[at(n[k])] == 0) {
                taken[at(n[k])] = 1;
                corners_[t].push_back(n[k]);
            }
            const int next = n[(k + 1) % 3];
            if (known.try_emplace(std::minmax(n[k], next), static_cast<int>(t)).second) {
                edges_[t].push_back({{n[k], next}, static_cast<int>(t)});
            }
        }
    }
}

std::span<const int> SkinParts::corners(int triangle) const { return corners_[at(triangle)]; }

std::span<const SkinEdge> SkinParts::edges(int triangle) const { return edges_[at(triangle)]; }

Mover mover(const MovingSkin& skin, int corner) {
    return {skin.from[at(corner)], skin.to[at(corner)], skin.skin.half[at(corner)]};
}

std::array<Mover, 3> movers(const MovingSkin& skin, const std::array<int, 3>& corners) {
    return {mover(skin, corners[0]), mover(skin, corners[1]), mover(skin, corners[2])};
}

bool shares_place(const Skin& skin, const std::array<int, 2>& own, const std::array<int, 3>& other) {
    for (const int a : own) {
        for (const int b : other) {
            if (a >= 0 && b >= 0 && skin.place[at(a)] == skin.place[at(b)]) {
                return true;
            }
        }
    }
    return false;
}

bool near_triangle(const Skin& skin, const std::array<int, 2>& own, int triangle) {
    const std::vector<int>& near = skin.near[at(skin.parent[at(triangle)])];
    for (const int corner : own) {
        for (std::size_t k = 0; corner >= 0 && k < 3; ++k) {
            const int node = skin.nodes[at(corner)][k];
            if (node >= 0 && std::binary_search(near.begin(), near.end(), node)) {
                return true;
            }
        }
    }
    return false;
}

/// By sweeping along x.
void near_triangles(const MovingSkin& a, const MovingSkin& b, const std::function<void(int, int)>& take) {
    const bool same = &a == &b;
    std::vector<SweptBox> boxes;
    add_boxes(a, false, boxes);
    if (!same) {
        add_boxes(b, true, boxes);
    }
    std::sort(boxes.begin(), boxes.end(), [](const SweptBox& p, const SweptBox& q) {
        return std::tuple(p.low.x(), p.of_b, p.triangle) < std::tuple(q.low.x(), q.of_b, q.triangle);
    });
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low.x() <= boxes[i].high.x(); ++j) {
            if ((!same && boxes[i].of_b == boxes[j].of_b) || !meet(boxes[i], boxes[j])) {
                continue;
            }
            const bool turned = boxes[i].of_b;
            take(boxes[turned ? j : i].triangle, boxes[turned ? i : j].triangle);
        }
    }
}

}  // namespace rhexis::scenes
