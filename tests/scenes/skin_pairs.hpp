// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of moving surfaces come near each other in a step: the broad phase of penetration.hpp. Every corner and
// every edge belongs to one triangle, so that of a pair of triangles each pair of parts is looked at once.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "scenes/penetration.hpp"

namespace rhexis::scenes {

struct SkinEdge {
    std::array<int, 2> corners{};
    int triangle = 0;  ///< that it belongs to
};

class SkinParts {
public:
    explicit SkinParts(const Skin& skin);
    [[nodiscard]] std::span<const int> corners(int triangle) const;
    [[nodiscard]] std::span<const SkinEdge> edges(int triangle) const;

private:
    std::vector<std::vector<int>> corners_;
    std::vector<std::vector<SkinEdge>> edges_;
};

Mover mover(const MovingSkin& skin, int corner);
std::array<Mover, 3> movers(const MovingSkin& skin, const std::array<int, 3>& corners);

/// Whether a corner or an edge has a place in common with a triangle or an edge; -1: no corner.
bool shares_place(const Skin& skin, const std::array<int, 2>& own, const std::array<int, 3>& other);

/// Whether a corner or an edge lies so near to a triangle along the surface that it is no other layer.
bool near_triangle(const Skin& skin, const std::array<int, 2>& own, int triangle);

/// Calls take(s, t) for each pair of triangles of two surfaces whose boxes over the step, with their thickness, meet;
/// of one surface with itself (the same object) each pair once.
void near_triangles(const MovingSkin& a, const MovingSkin& b, const std::function<void(int, int)>& take);

}  // namespace rhexis::scenes
