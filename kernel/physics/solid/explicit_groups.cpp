// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/explicit_groups.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "base/index.hpp"

namespace rhexis {
namespace {

/// What is not yet packed, and how many of those meet at each node.
class Remaining {
public:
    Remaining(const std::vector<std::array<int, 4>>& tets, int nodes) : tets_(tets), degree_(at(nodes), 0) {
        order_.resize(tets.size());
        std::iota(order_.begin(), order_.end(), 0);
        for (const std::array<int, 4>& tet : tets) {
            count(tet, 1);
        }
    }

    [[nodiscard]] bool empty() const { return order_.empty(); }

    /// Busiest first: by the most that meet at one of its nodes, then by how many meet at all. Sorting again only now
    /// and then costs little fill and makes the whole nearly linear.
    void sort() {
        sort_by([this](int t) {
            const std::array<int, 4>& tet = tets_[at(t)];
            return degree_[at(tet[0])] + degree_[at(tet[1])] + degree_[at(tet[2])] + degree_[at(tet[3])];
        });
        sort_by([this](int t) {
            const std::array<int, 4>& tet = tets_[at(t)];
            return std::max(std::max(degree_[at(tet[0])], degree_[at(tet[1])]),
                            std::max(degree_[at(tet[2])], degree_[at(tet[3])]));
        });
    }

    /// Takes up to `lanes` tetrahedra that share no node.
    std::vector<int> take(int lanes) {
        std::vector<int> taken;
        std::vector<int> used;
        std::size_t kept = 0;
        std::size_t i = 0;
        for (; i < order_.size() && static_cast<int>(taken.size()) < lanes; ++i) {
            const std::array<int, 4>& tet = tets_[at(order_[i])];
            const bool clash = std::any_of(tet.begin(), tet.end(), [&used](int node) {
                return std::find(used.begin(), used.end(), node) != used.end();
            });
            if (clash) {
                order_[kept++] = order_[i];
                continue;
            }
            taken.push_back(order_[i]);
            used.insert(used.end(), tet.begin(), tet.end());
            count(tet, -1);
        }
        order_.erase(order_.begin() + static_cast<std::ptrdiff_t>(kept),
                     order_.begin() + static_cast<std::ptrdiff_t>(i));
        return taken;
    }

private:
    void count(const std::array<int, 4>& tet, int change) {
        for (const int node : tet) {
            degree_[at(node)] += change;
        }
    }

    /// Largest first, equal ones as they were; by counting, for keys are small.
    template <typename Key>
    void sort_by(Key key) {
        keys_.clear();
        first_.assign(1, 0);
        for (const int t : order_) {
            keys_.push_back(key(t));
            first_.resize(std::max(first_.size(), at(keys_.back()) + 1), 0);
            ++first_[at(keys_.back())];
        }
        int before = 0;
        for (std::size_t k = first_.size(); k-- > 0;) {
            before += std::exchange(first_[k], before);
        }
        sorted_.resize(order_.size());
        for (std::size_t i = 0; i < order_.size(); ++i) {
            sorted_[at(first_[at(keys_[i])]++)] = order_[i];
        }
        order_.swap(sorted_);
    }

    const std::vector<std::array<int, 4>>& tets_;
    std::vector<int> degree_;
    std::vector<int> order_;
    std::vector<int> keys_;   ///< scratch of a sort, as what follows
    std::vector<int> first_;  ///< per key: where the first with it goes
    std::vector<int> sorted_;
};

}  // namespace

LaneAssignment assign_lanes(const std::vector<std::array<int, 4>>& tets, int nodes, int lanes) {
    LaneAssignment result;
    result.slot.resize(tets.size());
    Remaining remaining(tets, nodes);
    const int sort_every = 1 + static_cast<int>(tets.size()) / 4000;
    while (!remaining.empty()) {
        if (result.groups % sort_every == 0) {
            remaining.sort();
        }
        const std::vector<int> taken = remaining.take(lanes);
        for (std::size_t lane = 0; lane < taken.size(); ++lane) {
            result.slot[at(taken[lane])] = result.groups * lanes + static_cast<int>(lane);
        }
        ++result.groups;
    }
    return result;
}

}  // namespace rhexis
