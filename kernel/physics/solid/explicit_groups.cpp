// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/explicit_groups.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

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

    /// Busiest first. Sorting again only now and then costs little fill and makes the whole nearly linear.
    void sort() {
        std::stable_sort(order_.begin(), order_.end(), [this](int a, int b) { return urgency(a) > urgency(b); });
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
    [[nodiscard]] int urgency(int t) const {
        const std::array<int, 4>& tet = tets_[at(t)];
        int most = 0;
        int sum = 0;
        for (const int node : tet) {
            most = std::max(most, degree_[at(node)]);
            sum += degree_[at(node)];
        }
        return 1000 * most + sum;
    }

    const std::vector<std::array<int, 4>>& tets_;
    std::vector<int> degree_;
    std::vector<int> order_;
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
