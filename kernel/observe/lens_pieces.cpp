// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/lens_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/components.hpp"
#include "mesh/places.hpp"

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

std::vector<Vec3> nearest_tissue(const SolidModel& lens, const SolidState& state, const std::vector<LensPiece>& pieces,
                                 const Vec3& place) {
    constexpr double least = 1.0 / 3.0;
    const std::vector<int> names = pieces_by_nodes(lens.coarse.tets, lens.coarse.nodes.size(), state.present);
    std::vector<Vec3> nearest;
    std::vector<double> squares(pieces.size(), HUGE_VAL);
    for (const LensPiece& piece : pieces) {
        nearest.push_back(piece.centre);
    }
    for (std::size_t t = 0; t < names.size(); ++t) {
        const auto piece = std::lower_bound(pieces.begin(), pieces.end(), names[t],
                                            [](const LensPiece& a, int name) { return a.first < name; });
        if (names[t] < 0 || piece == pieces.end() || piece->first != names[t]) {
            continue;
        }
        const auto index = static_cast<std::size_t>(piece - pieces.begin());
        const std::array<int, 4>& tet = lens.coarse.tets[t];
        const Vec3 middle =
            0.25 * (state.position[tet[0]] + state.position[tet[1]] + state.position[tet[2]] + state.position[tet[3]]);
        const double size = (state.position[tet[0]] - middle).norm();
        if ((middle - place).norm() > std::sqrt(squares[index]) + 2.0 * size) {
            continue;
        }
        for (std::size_t f = 8 * t; f < 8 * t + 8; ++f) {
            const Vec3 child = fine_middle(lens.fine, state.position, static_cast<int>(f));
            const double square = (child - place).squaredNorm();
            if (state.fraction[f] >= least && square < squares[index]) {
                squares[index] = square;
                nearest[index] = child;
            }
        }
    }
    return nearest;
}

}  // namespace rhexis
