// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/least_cut.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace rhexis {

namespace {

constexpr double nothing = 1e-12;

/// Both directions of a joint lie side by side: arcs 2 j and 2 j + 1 are each other's way back.
class Network {
public:
    Network(const std::vector<Joint>& joints, const std::vector<CutSide>& sides)
        : sides_(&sides), offset_(sides.size() + 1, 0), level_(sides.size(), -1), next_(sides.size(), 0) {
        for (const Joint& joint : joints) {
            ++offset_[joint.a + 1];
            ++offset_[joint.b + 1];
            to_.push_back(joint.b);
            to_.push_back(joint.a);
            left_.push_back(joint.strength);
            left_.push_back(joint.strength);
        }
        for (std::size_t i = 1; i < offset_.size(); ++i) {
            offset_[i] += offset_[i - 1];
        }
        arcs_.resize(to_.size());
        std::vector<int> place(offset_.begin(), offset_.end() - 1);
        for (std::size_t j = 0; j < joints.size(); ++j) {
            arcs_[place[joints[j].a]++] = static_cast<int>(2 * j);
            arcs_[place[joints[j].b]++] = static_cast<int>(2 * j + 1);
        }
    }

    /// After flow: whether a cell is still joined to the first set.
    [[nodiscard]] bool on_first_side(int cell) const { return level_[cell] >= 0; }

    double flow() {
        double sum = 0.0;
        while (find_levels()) {
            std::copy(offset_.begin(), offset_.end() - 1, next_.begin());
            for (std::size_t cell = 0; cell < sides_->size(); ++cell) {
                while ((*sides_)[cell] == CutSide::first) {
                    const double pushed = augment(static_cast<int>(cell));
                    if (!(pushed > 0.0)) {
                        break;
                    }
                    sum += pushed;
                }
            }
        }
        return sum;
    }

private:
    /// Steps from the first set; false when the second cannot be reached.
    bool find_levels() {
        std::fill(level_.begin(), level_.end(), -1);
        std::vector<int> queue;
        for (std::size_t cell = 0; cell < sides_->size(); ++cell) {
            if ((*sides_)[cell] == CutSide::first) {
                level_[cell] = 0;
                queue.push_back(static_cast<int>(cell));
            }
        }
        bool reached = false;
        for (std::size_t i = 0; i < queue.size(); ++i) {
            const int cell = queue[i];
            reached = reached || (*sides_)[cell] == CutSide::second;
            for (int k = offset_[cell]; k < offset_[cell + 1]; ++k) {
                const int other = to_[arcs_[k]];
                if (left_[arcs_[k]] > nothing && level_[other] < 0) {
                    level_[other] = level_[cell] + 1;
                    queue.push_back(other);
                }
            }
        }
        return reached;
    }

    /// One path down the levels to the second set, by depth first; what went along it, 0 when there is none left.
    double augment(int start) {
        path_.clear();
        int cell = start;
        while ((*sides_)[cell] != CutSide::second) {
            int& k = next_[cell];
            while (k < offset_[cell + 1] &&
                   !(left_[arcs_[k]] > nothing && level_[to_[arcs_[k]]] == level_[cell] + 1)) {
                ++k;
            }
            if (k < offset_[cell + 1]) {
                path_.push_back(arcs_[k]);
                cell = to_[arcs_[k]];
            } else if (path_.empty()) {
                return 0.0;
            } else {
                cell = to_[path_.back() ^ 1];
                path_.pop_back();
                ++next_[cell];
            }
        }
        double least = std::numeric_limits<double>::infinity();
        for (const int arc : path_) {
            least = std::min(least, left_[arc]);
        }
        for (const int arc : path_) {
            left_[arc] -= least;
            left_[arc ^ 1] += least;
        }
        return least;
    }

    const std::vector<CutSide>* sides_;
    std::vector<int> offset_, arcs_;  ///< arcs of cell i: arcs_[offset_[i]] .. arcs_[offset_[i + 1] - 1]
    std::vector<int> to_;
    std::vector<double> left_;
    std::vector<int> level_, next_, path_;
};

}  // namespace

LeastCut least_cut(const std::vector<Joint>& joints, const std::vector<CutSide>& sides) {
    Network network(joints, sides);
    LeastCut cut;
    cut.strength = network.flow();
    for (std::size_t j = 0; j < joints.size(); ++j) {
        if (network.on_first_side(joints[j].a) != network.on_first_side(joints[j].b) && joints[j].strength > nothing) {
            cut.joints.push_back(static_cast<int>(j));
        }
    }
    return cut;
}

}  // namespace rhexis
