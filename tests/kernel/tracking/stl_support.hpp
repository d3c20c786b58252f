// SPDX-License-Identifier: GPL-3.0-or-later
// What is read back from the file of something to be printed.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "math/types.hpp"

namespace rhexis::tracking::testing {

using StlCorner = std::array<float, 3>;
using StlFacet = std::array<StlCorner, 4>;  // normal, then corners

inline std::vector<StlFacet> read_stl(const std::string& bytes) {
    REQUIRE(bytes.size() >= 84);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    REQUIRE(bytes.size() == 84 + 50 * static_cast<std::size_t>(count));
    std::vector<StlFacet> facets(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(facets[i].data(), bytes.data() + 84 + 50 * i, sizeof(StlFacet));
    }
    return facets;
}

inline Vec3 vector_of(const StlCorner& corner) { return {corner[0], corner[1], corner[2]}; }

/// Facets that hang together by edges, each shell by itself: they follow one another in the file, so a new one begins
/// where all edges before are paired.
struct StlShell {
    double volume = 0.0;
    std::vector<StlFacet> facets{};
};

/// Each edge is one of two facets, which turn against each other along it; else the test fails.
inline std::vector<StlShell> closed_shells_of(const std::vector<StlFacet>& facets) {
    std::vector<StlShell> shells(1);
    std::map<std::pair<StlCorner, StlCorner>, bool> edges;  // of the shell; true: its opposite is there
    std::size_t open = 0;
    for (const StlFacet& facet : facets) {
        for (std::size_t i = 0; i < 3; ++i) {
            const StlCorner& from = facet[1 + i];
            const StlCorner& to = facet[1 + (i + 1) % 3];
            const auto opposite = edges.find({to, from});
            const bool first = edges.emplace(std::make_pair(from, to), opposite != edges.end()).second;
            REQUIRE(first);
            if (opposite != edges.end()) {
                REQUIRE_FALSE(opposite->second);
                opposite->second = true;
                --open;
            } else {
                ++open;
            }
        }
        shells.back().volume += vector_of(facet[1]).dot(vector_of(facet[2]).cross(vector_of(facet[3]))) / 6.0;
        shells.back().facets.push_back(facet);
        if (open == 0) {
            shells.emplace_back();
            edges.clear();
        }
    }
    CHECK(open == 0);
    shells.pop_back();
    return shells;
}

}  // namespace rhexis::tracking::testing
