// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_sheet.hpp"

#include "base/index.hpp"
#include "mesh/nearest_place.hpp"

namespace rhexis {

void ShellSheet::look(const MembraneState& sheet) {
    sheet_ = &sheet;
    boxes_.assign(sheet.sheet->mesh.triangles.size(), Box{});
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
        for (const int node : sheet.sheet->mesh.triangles[t]) {
            boxes_[t].add(sheet.position[at(node)], 0.0);
        }
    }
    grid_.fill(boxes_);
}

// Of places at one distance, such as those of an edge that two triangles share, the lowest triangle's counts.
std::array<ShellSheet::Foot, 2> ShellSheet::nearest(const Vec3& place, const Vec3& forward, double within) {
    std::array<Foot, 2> feet;
    std::array<int, 2> triangle{-1, -1};
    grid_.near(place, within, [&](int t) {
        if (square_to(boxes_[at(t)], place) > within * within) {
            return;
        }
        const std::array<int, 3>& n = sheet_->sheet->mesh.triangles[at(t)];
        const std::vector<Vec3>& x = sheet_->position;
        const std::array<Vec3, 3> corner{x[at(n[0])], x[at(n[1])], x[at(n[2])]};
        const std::array<double, 3> weights = nearest_to_point(corner, place);
        const Vec3 way = place_in(corner, weights) - place;
        const double distance = way.norm();
        const std::size_t side = forward.dot(way) > 0.0 ? 1 : 0;
        if (distance < within &&
            (distance < feet[side].distance || (distance == feet[side].distance && t < triangle[side]))) {
            feet[side] = {distance, way, n, weights};
            triangle[side] = t;
        }
    });
    return feet;
}

}  // namespace rhexis
