// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/rhexis_marks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/index.hpp"

namespace rhexis {
namespace {

constexpr double farthest = 1.8;  ///< of a place to take hold of, from the tip [mm]
constexpr double nearest = 0.3;   ///< likewise
constexpr double wanted = 0.8;    ///< likewise

bool within_pupil(const EyeAnatomy& eye, const Vec3& place) { return place.head<2>().norm() < eye.pupil_radius; }

Vec3 middle_now(const MembraneState& state, int triangle) {
    const std::array<int, 3>& n = state.sheet->mesh.triangles[at(triangle)];
    return (state.position[at(n[0])] + state.position[at(n[1])] + state.position[at(n[2])]) / 3.0;
}

/// Of some places the one at the wanted distance from the tip towards their middle.
std::optional<Vec3> one_of(const std::vector<Vec3>& places, const Vec3& tip) {
    if (places.empty()) {
        return std::nullopt;
    }
    Vec3 middle = Vec3::Zero();
    for (const Vec3& place : places) {
        middle += place / static_cast<double>(places.size());
    }
    const Vec3 way = middle - tip;
    const Vec3 aim = way.norm() > 1e-6 ? Vec3(tip + wanted * way.normalized()) : tip;
    return *std::min_element(places.begin(), places.end(), [&aim](const Vec3& a, const Vec3& b) {
        return (a - aim).squaredNorm() < (b - aim).squaredNorm();
    });
}

/// Can be taken hold of: within reach of the tip, and not behind the iris.
bool within_reach(const Vec3& place, const Vec3& tip, const EyeAnatomy& eye) {
    const double distance = (place - tip).norm();
    return distance > nearest && distance < farthest && within_pupil(eye, place);
}

std::optional<Vec3> on_fold(const MembraneState& state, const Vec3& tip, const EyeAnatomy& eye) {
    std::vector<Vec3> places;
    for (int t = 0; t < static_cast<int>(state.sheet->mesh.triangles.size()); ++t) {
        const Vec3 middle = middle_now(state, t);
        if (within_reach(middle, tip, eye) && folded(state, t)) {
            places.push_back(middle);
        }
    }
    return one_of(places, tip);
}

std::optional<Vec3> on_lip(const MembraneState& state, const std::vector<int>& lip, const Vec3& tip,
                           const EyeAnatomy& eye) {
    std::vector<Vec3> places;
    const TriNeighbours& near = state.sheet->neighbours;
    for (std::size_t i = 1; i < lip.size(); ++i) {
        for (int k = near.offset[at(lip[i])]; k < near.offset[at(lip[i]) + 1]; ++k) {
            const Vec3 middle = middle_now(state, near.triangles[at(k)]);
            if (within_reach(middle, tip, eye)) {
                places.push_back(middle);
            }
        }
    }
    return one_of(places, tip);
}

/// So far behind the tip, along the margin as it lies now; its end, where it is shorter. margin: two nodes or more.
Vec3 behind_tip(const MembraneState& state, const std::vector<int>& margin) {
    double left = wanted;
    for (std::size_t i = 1; i < margin.size(); ++i) {
        const Vec3& from = state.position[at(margin[i - 1])];
        const Vec3 way = state.position[at(margin[i])] - from;
        if (way.norm() > left) {
            return from + left * way.normalized();
        }
        left -= way.norm();
    }
    return state.position[at(margin.back())];
}

void add_tear(const MembraneState& state, const RhexisShape& rhexis, const EyeAnatomy& eye,
              std::vector<Landmark>& marks) {
    const std::vector<int>& lip = rhexis.lip;
    if (lip.empty()) {
        return;
    }
    const Vec3& tip = state.position[at(lip[0])];
    marks.push_back({"tear_tip", within_pupil(eye, tip), tip, 0.0});
    if (rhexis.margin.size() > 1) {
        const Vec3 margin = behind_tip(state, rhexis.margin);
        marks.push_back({"margin", within_pupil(eye, margin), margin, 0.0});
    }
    const std::optional<Vec3> fold = on_fold(state, tip, eye);
    const std::optional<Vec3> flap = fold ? fold : on_lip(state, lip, tip, eye);
    if (flap) {
        marks.push_back({"flap", true, *flap, fold ? 1.0 : 0.0});
    }
}

void add_held(const MembraneState& state, const EyeAnatomy& eye, std::vector<Landmark>& marks) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const SheetGrip& grip : state.grips) {
        if (!grip.pushed) {
            sum += state.position[at(grip.node)];
            ++count;
        }
    }
    if (count > 0) {
        marks.push_back({"held", within_pupil(eye, sum / count), sum / count, 0.0});
    }
}

}  // namespace

void add_rhexis_landmarks(const ObserveInput& input, const RhexisShape& rhexis, int membrane,
                          std::vector<Landmark>& marks) {
    const EyeAnatomy& eye = input.eye.anatomy;
    const MembraneState& state = input.state.membranes[at(membrane)];
    const std::optional<SupportModel>& lens = input.world.membranes[at(membrane)].support;
    if (lens) {
        marks.push_back({"lens_front", true, Vec3(0.0, 0.0, lens->shape.anterior + state.support.lift), 0.0});
    }
    if (input.state.viscoelastic) {
        const double fill = input.state.viscoelastic->fill;
        marks.push_back({"viscoelastic", true, Vec3(0.0, 0.0, eye.iris_z), fill});
    }
    add_tear(state, rhexis, eye, marks);
    add_held(state, eye, marks);
    if (rhexis.closed) {
        marks.push_back({"rim", true, Vec3(rhexis.centre.x(), rhexis.centre.y(), lens ? lens->shape.anterior : 0.0),
                         0.5 * rhexis.mean_diameter});
    }
}

}  // namespace rhexis
