// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/grown_pattern.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace rhexis {
namespace {

/// Of a row whose columns may have changed.
void find_slots_again(const BlockPattern& before, int row, std::span<const int> row_now, const BlockPattern& now,
                      int own, std::vector<int>& slot_now) {
    int slot = now.first[at(own)];
    for (int old = before.first[at(row)]; old < before.first[at(row) + 1]; ++old) {
        const int column = row_now[at(before.column[at(old)])];
        while (slot < now.first[at(own) + 1] && now.column[at(slot)] < column) {
            ++slot;
        }
        const bool there = slot < now.first[at(own) + 1] && now.column[at(slot)] == column;
        slot_now[at(old)] = there ? slot : -1;
    }
}

}  // namespace

GrownPattern grown_pattern(const BlockPattern& before, int rows, std::span<const int> row_now,
                           const std::vector<std::uint8_t>& changed, std::vector<std::array<int, 2>> entries) {
    std::sort(entries.begin(), entries.end());
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
    GrownPattern result;
    BlockPattern& now = result.pattern;
    now.first.reserve(at(rows) + 1);
    now.column.reserve(before.column.size() + entries.size());
    now.first.push_back(0);
    result.slot_now.assign(before.column.size() + 1, -1);
    std::size_t next = 0;  // of entries
    std::size_t row = 0;   // before
    for (int own = 0; own < rows; ++own) {
        const bool known = row < row_now.size() && row_now[row] == own;
        if (changed[at(own)] != 0) {
            for (; next < entries.size() && entries[next][0] == own; ++next) {
                now.column.push_back(entries[next][1]);
            }
            now.first.push_back(now.blocks());
            if (known) {
                find_slots_again(before, static_cast<int>(row), row_now, now, own, result.slot_now);
            }
        } else {
            for (int old = before.first[row]; old < before.first[row + 1]; ++old) {
                result.slot_now[at(old)] = now.blocks();
                now.column.push_back(row_now[at(before.column[at(old)])]);
            }
            now.first.push_back(now.blocks());
        }
        row += known ? 1 : 0;
    }
    result.slot_now.back() = now.blocks();
    find_mirrors(now);
    return result;
}

}  // namespace rhexis
