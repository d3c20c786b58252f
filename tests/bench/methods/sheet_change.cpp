// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/sheet_change.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace rhexis::bench {
namespace {

struct Share {
    std::array<int, 3> nodes;
    Mat9 value;
};

NodeMatrix sum_of(const std::vector<Share>& shares, const std::vector<int>& fixed) {
    NodeMatrix sum;
    for (const Share& share : shares) {
        for (const int node : share.nodes) {
            if (!std::binary_search(fixed.begin(), fixed.end(), node)) {
                sum.nodes.push_back(node);
            }
        }
    }
    std::sort(sum.nodes.begin(), sum.nodes.end());
    sum.nodes.erase(std::unique(sum.nodes.begin(), sum.nodes.end()), sum.nodes.end());
    const auto place = [&sum](int node) {
        const auto found = std::lower_bound(sum.nodes.begin(), sum.nodes.end(), node);
        return found != sum.nodes.end() && *found == node ? static_cast<int>(found - sum.nodes.begin()) : -1;
    };
    const Eigen::Index size = 3 * static_cast<Eigen::Index>(sum.nodes.size());
    sum.value = MatX::Zero(size, size);
    for (const Share& share : shares) {
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                const int row = place(share.nodes[at(a)]);
                const int column = place(share.nodes[at(b)]);
                if (row >= 0 && column >= 0) {
                    sum.value.block<3, 3>(3 * row, 3 * column) += share.value.block<3, 3>(3 * a, 3 * b);
                }
            }
        }
    }
    return sum;
}

}  // namespace

void SheetChange::start(const SplitSystem& system) {
    state_ = system.state;
    nodes_ = state_.sheet->mesh.triangles;
    added_.clear();
}

NodeMatrix SheetChange::follow(const SplitSystem& system) {
    const std::vector<std::array<int, 3>>& now = system.state.sheet->mesh.triangles;
    std::vector<Share> shares;
    for (int t = 0; t < static_cast<int>(now.size()); ++t) {
        const bool known = at(t) < nodes_.size();
        if (known && nodes_[at(t)] == now[at(t)]) {
            continue;
        }
        if (known) {
            const auto found = added_.find(t);
            const Mat9 was = found != added_.end() ? found->second : triangle_share(system.model, state_, t, system.dt);
            shares.push_back({nodes_[at(t)], -was});
        }
        added_[t] = triangle_share(system.model, system.state, t, system.dt);
        shares.push_back({now[at(t)], added_[t]});
    }
    nodes_ = now;
    return sum_of(shares, system.model.fixed_nodes);
}

}  // namespace rhexis::bench
