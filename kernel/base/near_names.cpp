// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/near_names.hpp"

#include <algorithm>

namespace rhexis {
namespace {

std::string joined(std::span<const std::string> names, const char* last) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) {
            text += i + 1 == names.size() ? last : ", ";
        }
        text += names[i];
    }
    return text;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                cost[i][j] = static_cast<int>(i + j);
                continue;
            }
            const int replaced = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
            }
        }
    }
    return cost[a.size()][b.size()];
}

std::vector<std::string> near_names(std::string_view word, std::span<const std::string> candidates, int count) {
    const int farthest = std::max<int>(1, static_cast<int>(word.size()) / 3);
    std::vector<std::pair<int, std::string>> near;
    for (const std::string& candidate : candidates) {
        const int distance = edit_distance(word.substr(0, 100), std::string_view(candidate).substr(0, 100));
        if (distance <= farthest) {
            near.emplace_back(distance, candidate);
        }
    }
    std::sort(near.begin(), near.end());
    std::vector<std::string> names;
    for (const auto& [distance, name] : near) {
        if (static_cast<int>(names.size()) < count) {
            names.push_back(name);
        }
    }
    return names;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
    if (candidates.empty()) {
        return "there is none";
    }
    const std::vector<std::string> near = near_names(word, candidates);
    if (!near.empty()) {
        return "did you mean " + joined(near, " or ") + "?";
    }
    return "one of " + joined(candidates, ", ");
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
    std::string text;
    for (const std::string& name : near_names(word, candidates)) {
        text += (text.empty() ? "'" : " or '") + name + "'";
    }
    return text.empty() ? text : " (did you mean " + text + "?)";
}

}  // namespace rhexis
