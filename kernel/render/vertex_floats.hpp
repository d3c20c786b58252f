// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors as the numbers of vertices.
#pragma once

#include <vector>

#include "math/types.hpp"

namespace rhexis {

/// Appends its three numbers.
inline void append_floats(const Vec3& triple, std::vector<float>& stream) {
    for (int i = 0; i < 3; ++i) {
        stream.push_back(static_cast<float>(triple[i]));
    }
}

}  // namespace rhexis
