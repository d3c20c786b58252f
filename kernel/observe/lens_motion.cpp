// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/lens_motion.hpp"

#include <cmath>

#include "mesh/places.hpp"

namespace rhexis {
namespace {

Vec3 rotated(const Vec2& turn, const Vec3& v) {
    return {turn.x() * v.x() - turn.y() * v.y(), turn.y() * v.x() + turn.x() * v.y(), v.z()};
}

struct Means {
    double volume = 0.0;
    Vec3 rest = Vec3::Zero();
    Vec3 now = Vec3::Zero();
};

Means means_of(const SolidModel& lens, const std::vector<double>& volumes, const SolidState& state) {
    Means means;
    for (std::size_t t = 0; t < volumes.size(); ++t) {
        if (state.present[t] != 0) {
            means.volume += volumes[t];
            means.rest += volumes[t] * centroid(lens.coarse.nodes, lens.coarse.tets[t]);
            means.now += volumes[t] * centroid(state.position, lens.coarse.tets[t]);
        }
    }
    if (means.volume > 0.0) {
        means.rest /= means.volume;
        means.now /= means.volume;
    }
    return means;
}

/// The turn about z that fits best: the direction of sum w (r . x, r x x) over offsets r at rest and x now.
Vec2 turn_of(const SolidModel& lens, const std::vector<double>& volumes, const SolidState& state, const Means& means) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t t = 0; t < volumes.size(); ++t) {
        if (state.present[t] != 0) {
            const Vec3 r = centroid(lens.coarse.nodes, lens.coarse.tets[t]) - means.rest;
            const Vec3 x = centroid(state.position, lens.coarse.tets[t]) - means.now;
            sum += volumes[t] * Vec2(r.x() * x.x() + r.y() * x.y(), r.x() * x.y() - r.y() * x.x());
        }
    }
    const double length = sum.norm();
    return length > 0.0 ? Vec2(sum / length) : Vec2(Vec2::UnitX());
}

}  // namespace

Vec3 LensMotion::to_rest(const Vec3& place) const {
    return rotated(Vec2(turn.x(), -turn.y()), place - centre - shift) + centre;
}

Vec3 LensMotion::to_eye(const Vec3& rest) const { return rotated(turn, rest - centre) + centre + shift; }

std::vector<double> coarse_volumes(const SolidModel& lens) {
    std::vector<double> volumes;
    volumes.reserve(lens.coarse.tets.size());
    const std::vector<Vec3>& x = lens.coarse.nodes;
    for (const std::array<int, 4>& tet : lens.coarse.tets) {
        volumes.push_back(tet_volume(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]));
    }
    return volumes;
}

LensMotion lens_motion(const SolidModel& lens, const std::vector<double>& volumes, const SolidState& state) {
    const Means means = means_of(lens, volumes, state);
    if (means.volume <= 0.0) {
        return {};
    }
    LensMotion motion;
    motion.centre = means.rest;
    motion.shift = means.now - means.rest;
    motion.turn = turn_of(lens, volumes, state, means);
    return motion;
}

}  // namespace rhexis
