// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/tear_strength.hpp"

#include <cmath>

namespace rhexis::bench {

double strength_against(const Strength& strength, const Vec2& fibre, const Vec2& u) {
    const double off = std::acos(std::min(1.0, std::abs(u.dot(fibre))));
    return strength.across + (strength.along - strength.across) * std::pow(1.0 - 2.0 / M_PI * off, strength.alpha);
}

StrengthAnswer search_directions(const Mat2& stress, const Strength& strength, const Vec2& fibre, const Vec2& within,
                                 double cosine) {
    StrengthAnswer best;
    for (int i = 0; i < 7200; ++i) {
        const double angle = i * M_PI / 3600.0;
        const Vec2 d(std::cos(angle), std::sin(angle));
        if (!within.isZero() && d.dot(within) < cosine) {
            continue;
        }
        const Vec2 u(-d.y(), d.x());
        const double ratio = u.dot(stress * u) / strength_against(strength, fibre, u);
        if (ratio > best.ratio) {
            best = {ratio, d};
        }
    }
    return best;
}

TipStress one_ring_stress(const MembraneModel& model, const MembraneState& state, const TearTip& tip) {
    // stress_at() takes at least the triangles at the tip
    MembraneModel near = model;
    near.tear_radius = 1e-4;
    return stress_at(near, state, tip.node, tip.direction);
}

}  // namespace rhexis::bench
