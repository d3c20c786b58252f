// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_patches.hpp"

#include <algorithm>
#include <cstddef>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "mesh/adjacency.hpp"

namespace rhexis {
namespace {

constexpr int nowhere = -1;

class Patching {
public:
    Patching(const std::vector<std::array<int, 4>>& tets, int most)
        : tets_(tets), neighbours_(face_neighbours(tets)), patch_of_(tets.size(), nowhere), most_(at(most)) {}

    std::vector<std::vector<int>> run() {
        for (int t = 0; t < static_cast<int>(tets_.size()); ++t) {
            if (patch_of_[at(t)] == nowhere) {
                grow(t);
            }
        }
        for (std::vector<int>& patch : patches_) {
            if (2 * patch.size() < most_) {
                join(patch);
            }
        }
        std::erase_if(patches_, [](const std::vector<int>& patch) { return patch.empty(); });
        return std::move(patches_);
    }

private:
    void take(int tet, int patch) {
        patch_of_[at(tet)] = patch;
        patches_[at(patch)].push_back(tet);
    }

    void grow(int first) {
        const int own = static_cast<int>(patches_.size());
        patches_.emplace_back();
        nodes_.clear();
        for (int next = first; next != nowhere; next = next_for(own)) {
            take(next, own);
            nodes_.insert(nodes_.end(), tets_[at(next)].begin(), tets_[at(next)].end());
            if (patches_[at(own)].size() == most_) {
                return;
            }
        }
    }

    /// The free neighbour that shares most nodes with the patch; of these the one with the fewest ways to go elsewhere.
    [[nodiscard]] int next_for(int patch) const {
        int best = nowhere;
        int best_score = 0;
        for (const int member : patches_[at(patch)]) {
            for (const int other : neighbours_[at(member)]) {
                if (other == nowhere || patch_of_[at(other)] != nowhere) {
                    continue;
                }
                const int score = 5 * shared_nodes(other) - free_neighbours(other);
                if (best == nowhere || score > best_score) {
                    best = other;
                    best_score = score;
                }
            }
        }
        return best;
    }

    [[nodiscard]] int shared_nodes(int tet) const {
        return static_cast<int>(std::count_if(tets_[at(tet)].begin(), tets_[at(tet)].end(), [this](int node) {
            return std::find(nodes_.begin(), nodes_.end(), node) != nodes_.end();
        }));
    }

    [[nodiscard]] int free_neighbours(int tet) const {
        return static_cast<int>(
            std::count_if(neighbours_[at(tet)].begin(), neighbours_[at(tet)].end(),
                          [this](int other) { return other != nowhere && patch_of_[at(other)] == nowhere; }));
    }

    void join(std::vector<int>& patch) {
        int best = nowhere;
        for (const int member : patch) {
            for (const int other : neighbours_[at(member)]) {
                const int found = other == nowhere ? nowhere : patch_of_[at(other)];
                if (found != nowhere && found != patch_of_[at(member)] &&
                    (best == nowhere || patches_[at(found)].size() < patches_[at(best)].size())) {
                    best = found;
                }
            }
        }
        if (best != nowhere) {
            for (const int member : std::vector<int>(std::move(patch))) {
                take(member, best);
            }
            patch.clear();
        }
    }

    const std::vector<std::array<int, 4>>& tets_;
    std::vector<std::array<int, 4>> neighbours_;
    std::vector<int> patch_of_;
    std::vector<std::vector<int>> patches_;
    std::vector<int> nodes_;  ///< of the patch that grows
    std::size_t most_;
};

}  // namespace

std::vector<std::vector<int>> tet_patches(const std::vector<std::array<int, 4>>& tets, int most) {
    RHEXIS_ASSERT(most >= 1);
    return Patching(tets, most).run();
}

}  // namespace rhexis
