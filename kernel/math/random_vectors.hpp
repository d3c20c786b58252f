// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of random numbers. Compilers differ in the order in which they evaluate arguments: here the last component is
// always drawn first, so that one seed gives one result.
#pragma once

#include "base/rng.hpp"
#include "math/types.hpp"

namespace rhexis {

/// Components uniform in [0, 1), z first.
inline Vec3 uniform3(Rng& rng) {
    const double z = rng.uniform();
    const double y = rng.uniform();
    return {rng.uniform(), y, z};
}

/// Components uniform in [0, 1), y first.
inline Vec2 uniform2(Rng& rng) {
    const double y = rng.uniform();
    return {rng.uniform(), y};
}

/// Standard normal deviates, z first.
inline Vec3 normal3(Rng& rng) {
    const double z = rng.normal();
    const double y = rng.normal();
    return {rng.normal(), y, z};
}

/// Standard normal deviates, y first.
inline Vec2 normal2(Rng& rng) {
    const double y = rng.normal();
    return {rng.normal(), y};
}

}  // namespace rhexis
