// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/near_name.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rhexis {
namespace {

// Insertions, deletions, substitutions and swaps of neighbours that turn a into b.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before;
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substitution = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, substitution});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        before = last;
        last.swap(row);
    }
    return last[b.size()];
}

}  // namespace

std::vector<std::string> near_names(std::string_view name, const std::vector<std::string>& names) {
    constexpr std::size_t longest = 80;  // of a name worth comparing
    name = name.substr(0, longest);
    const std::size_t most = std::max<std::size_t>(1, name.size() / 3);
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const std::string& candidate : names) {
        const std::size_t distance = edit_distance(name, std::string_view(candidate).substr(0, longest));
        const bool extends = name.size() >= 3 && candidate.find(name) != std::string::npos;
        if (distance <= most || extends) {
            near.emplace_back(distance, candidate);
        }
    }
    std::sort(near.begin(), near.end());
    std::vector<std::string> result;
    for (std::size_t k = 0; k < near.size() && k < 3; ++k) {
        result.push_back(near[k].second);
    }
    return result;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& names) {
    const std::vector<std::string> near = near_names(name, names);
    std::string text;
    for (const std::string& one : near) {
        text += (text.empty() ? "'" : ", '") + one + "'";
    }
    return text.empty() ? "" : " (did you mean " + text + "?)";
}

}  // namespace rhexis
