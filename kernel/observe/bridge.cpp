// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/bridge.hpp"

#include <algorithm>

#include "mesh/least_cut.hpp"
#include "mesh/places.hpp"

namespace rhexis {

namespace {

constexpr double beside = 2.0;  ///< room for a crack that does not run straight, in a nucleus of 3.3 mm radius [mm]

bool in_nucleus(const SolidModel& lens, int coarse) {
    return lens.materials[lens.coarse.region[coarse]].name == "nucleus";
}

Vec3 middle_of(const SolidModel& lens, int coarse) {
    Vec3 sum = Vec3::Zero();
    for (const int node : lens.coarse.tets[coarse]) {
        sum += 0.25 * lens.coarse.nodes[node];
    }
    return sum;
}

/// Of a place from the upright plane through the groove [mm].
double distance_from(const GrooveShape& groove, const Vec3& place) {
    const Vec2 from = (place - 0.5 * (groove.near_end + groove.far_end)).head<2>();
    return from.x() * groove.direction.y() - from.y() * groove.direction.x();
}

Vec3 fine_node(const SolidModel& lens, int node) { return fine_point(lens.fine, lens.coarse.nodes, node); }

double face_area(const SolidModel& lens, int fine, std::size_t opposite) {
    const std::array<int, 4>& tet = lens.fine.tets[fine];
    const std::array<int, 3>& face = tet_faces[opposite];
    const Vec3 a = fine_node(lens, tet[face[0]]);
    return 0.5 * (fine_node(lens, tet[face[1]]) - a).cross(fine_node(lens, tet[face[2]]) - a).norm();
}

/// What holds neighbouring coarse tetrahedra of the nucleus together: the area of fine faces that both sides still
/// have.
std::vector<Joint> nucleus_joints(const SolidModel& lens, const SolidState& state) {
    const auto alive = [&](int fine) {
        return state.present[fine / 8] != 0 && state.fraction[fine] > 0.0 && in_nucleus(lens, fine / 8);
    };
    std::vector<Joint> joints;
    for (int f = 0; f < static_cast<int>(lens.fine.tets.size()); ++f) {
        for (std::size_t k = 0; k < 4; ++k) {
            const int other = lens.fine.neighbours[f][k];
            if (other < f || other / 8 == f / 8 || !alive(f) || !alive(other)) {
                continue;
            }
            const BrokenFace pair{std::min(f, other) / 8, std::max(f, other) / 8};
            if (!std::binary_search(state.broken.begin(), state.broken.end(), pair)) {
                joints.push_back({pair[0], pair[1], face_area(lens, f, k)});
            }
        }
    }
    return joints;
}

}  // namespace

Bridge find_bridge(const SolidModel& lens, const SolidState& state, const GrooveShape& groove) {
    std::vector<CutSide> sides(lens.coarse.tets.size(), CutSide::free);
    for (int t = 0; t < static_cast<int>(sides.size()); ++t) {
        const double distance = distance_from(groove, middle_of(lens, t));
        if (state.present[t] != 0 && in_nucleus(lens, t) && std::abs(distance) > beside) {
            sides[t] = distance > 0.0 ? CutSide::first : CutSide::second;
        }
    }
    const std::vector<Joint> joints = nucleus_joints(lens, state);
    const LeastCut cut = least_cut(joints, sides);
    Bridge bridge{cut.strength, Vec3::Zero()};
    for (const int j : cut.joints) {
        bridge.place +=
            joints[j].strength / cut.strength * 0.5 * (middle_of(lens, joints[j].a) + middle_of(lens, joints[j].b));
    }
    return bridge;
}

double section_area(const SolidModel& lens, const ColumnGrid& grid, const GrooveShape& groove) {
    const Vec2 middle = (0.5 * (groove.near_end + groove.far_end)).head<2>();
    double area = 0.0;
    for (int i = -grid.count; i <= grid.count; ++i) {
        const int cell = grid.cell_at(middle + i * grid.cell * groove.direction);
        if (!grid.inside(cell)) {
            continue;
        }
        for (int s = grid.first[cell]; s < grid.first[cell + 1]; ++s) {
            const ColumnSegment& segment = grid.segments[s];
            if (lens.materials[segment.material].name == "nucleus") {
                area += grid.cell * (segment.high - segment.low);
            }
        }
    }
    return area;
}

}  // namespace rhexis
