// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/lens_pieces.hpp"

#include <algorithm>

#include "mesh/components.hpp"

namespace rhexis {

namespace {

/// Per tetrahedron the lowest one that it hangs together with; what hangs together shares nodes.
std::vector<int> piece_names(const SolidModel& lens, const SolidState& state) {
    const int count = static_cast<int>(lens.coarse.tets.size());
    UnionFind sets(count);
    std::vector<int> first(lens.coarse.nodes.size(), -1);
    for (int t = 0; t < count; ++t) {
        if (state.present[t] != 0) {
            for (const int node : lens.coarse.tets[t]) {
                first[node] = first[node] < 0 ? t : first[node];
                sets.join(first[node], t);
            }
        }
    }
    std::vector<int> names(lens.coarse.tets.size(), -1);
    for (int t = 0; t < count; ++t) {
        names[t] = state.present[t] != 0 ? sets.find(t) : -1;
    }
    return names;
}

}  // namespace

std::vector<LensPiece> lens_pieces(const SolidModel& lens, const std::vector<double>& volumes,
                                   const SolidState& state) {
    const std::vector<int> names = piece_names(lens, state);
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
