// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of random numbers. Compilers differ in the order in which they evaluate arguments: here the last component is
// always drawn first, so that one seed gives one result.
#pragma once

#include "base/rng.hpp"
#include "math/types.hpp"

namespace rhexis {

template <int size>
Eigen::Vector<double, size> drawn_last_first(Rng& rng, double (Rng::*draw)()) {
    Eigen::Vector<double, size> numbers;
    for (int i = size - 1; i >= 0; --i) {
        numbers[i] = (rng.*draw)();
    }
    return numbers;
}

/// Components uniform in [0, 1).
inline Vec2 uniform2(Rng& rng) { return drawn_last_first<2>(rng, &Rng::uniform); }
inline Vec3 uniform3(Rng& rng) { return drawn_last_first<3>(rng, &Rng::uniform); }

/// Standard normal deviates.
inline Vec2 normal2(Rng& rng) { return drawn_last_first<2>(rng, &Rng::normal); }
inline Vec3 normal3(Rng& rng) { return drawn_last_first<3>(rng, &Rng::normal); }

}  // namespace rhexis
