// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/lens_pieces.hpp"

#include <algorithm>

#include "mesh/components.hpp"

namespace rhexis {

std::vector<LensPiece> lens_pieces(const SolidModel& lens, const std::vector<double>& volumes,
                                   const SolidState& state) {
    const std::vector<int> names = pieces_by_nodes(lens.coarse.tets, lens.coarse.nodes.size(), state.present);
    std::vector<int> place(names.size(), -1);
    std::vector<LensPiece> pieces;
    for (std::size_t t = 0; t < names.size(); ++t) {
        if (names[t] < 0) {
            continue;
        }
        int& index = place[names[t]];
        if (index < 0) {
            index = static_cast<int>(pieces.size());
            pieces.push_back({names[t], 0.0, Vec3::Zero(), 1e9, -1e9});
        }
        LensPiece& piece = pieces[index];
        const double left = volumes[t] * remaining_fraction(lens, state, static_cast<int>(t));
        piece.volume += left;
        for (const int node : lens.coarse.tets[t]) {
            piece.centre += 0.25 * left * state.position[node];
            piece.lowest = std::min(piece.lowest, state.position[node].z());
            piece.highest = std::max(piece.highest, state.position[node].z());
        }
    }
    for (LensPiece& piece : pieces) {
        piece.centre /= std::max(piece.volume, 1e-12);
    }
    return pieces;
}

}  // namespace rhexis
