// SPDX-License-Identifier: GPL-3.0-or-later
// The least that has to be parted to separate two sets of cells: what bridges them.
#pragma once

#include <cstdint>
#include <vector>

namespace rhexis {

/// Two cells and what holds them together, >= 0.
struct Joint {
    int a = 0;
    int b = 0;
    double strength = 0.0;
};

/// Which side a cell is on; free cells may end on either.
enum class CutSide : std::uint8_t { free, first, second };

struct LeastCut {
    double strength = 0.0;    ///< sum over the joints that part
    std::vector<int> joints;  ///< their indices, ascending
};

/// The joints whose loss separates every cell of the first set from every cell of the second,
/// with the least sum of strengths: maximum flow by shortest augmenting paths [Dinic1970]. Joints that are
/// below 1e-12 count as none. None if a set is empty.
LeastCut least_cut(const std::vector<Joint>& joints, const std::vector<CutSide>& sides);

}  // namespace rhexis
