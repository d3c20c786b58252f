// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of nodes, triangles and tips are int, for -1 says that there is none; containers count in std::size_t. This
// is the step from one to the other.
#pragma once

#include <cstddef>

#include "base/assert.hpp"

namespace rhexis {

/// The place of a thing in its container. i: 0 or more.
inline std::size_t at(int i) {
    RHEXIS_ASSERT(i >= 0);
    return static_cast<std::size_t>(i);
}

}  // namespace rhexis
