// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/block_matrix.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis {
namespace {

/// Groups of each row: group[offset[row]] .. group[offset[row + 1] - 1].
struct RowGroups {
    std::vector<int> offset;
    std::vector<int> group;
};

RowGroups groups_of_rows(int rows, std::span<const int> first, std::span<const int> node) {
    RowGroups result;
    result.offset.assign(at(rows) + 1, 0);
    for (const int n : node) {
        ++result.offset[at(n) + 1];
    }
    for (std::size_t row = 0; row < at(rows); ++row) {
        result.offset[row + 1] += result.offset[row];
    }
    result.group.resize(node.size());
    std::vector<int> next(result.offset.begin(), result.offset.end() - 1);
    for (int group = 0; group + 1 < static_cast<int>(first.size()); ++group) {
        for (int i = first[at(group)]; i < first[at(group) + 1]; ++i) {
            result.group[at(next[at(node[at(i)])]++)] = group;
        }
    }
    return result;
}

}  // namespace

void find_mirrors(BlockPattern& pattern) {
    pattern.mirror.resize(pattern.column.size());
    pattern.diagonal.resize(pattern.first.size() - 1);
    // rows are met in ascending order, and so are the columns of each: the mirror of a slot is the next one of its row
    std::vector<int> next(pattern.first.begin(), pattern.first.end() - 1);
    for (int i = 0; i < pattern.rows(); ++i) {
        for (int slot = pattern.first[at(i)]; slot < pattern.first[at(i) + 1]; ++slot) {
            const int j = pattern.column[at(slot)];
            pattern.mirror[at(slot)] = next[at(j)]++;
            if (j == i) {
                pattern.diagonal[at(i)] = slot;
            }
        }
    }
}

BlockPattern permuted(const BlockPattern& pattern, std::span<const int> order, std::span<const int> place) {
    BlockPattern result;
    result.first.reserve(pattern.first.size());
    result.column.resize(pattern.column.size());
    result.first.push_back(0);
    int* const columns = result.column.data();
    int end = 0;
    for (const int row : order) {
        const int begin = end;
        for (int slot = pattern.first[at(row)]; slot < pattern.first[at(row) + 1]; ++slot) {
            const int column = place[at(pattern.column[at(slot)])];
            int i = end++;
            for (; i > begin && columns[i - 1] > column; --i) {  // rows are short
                columns[i] = columns[i - 1];
            }
            columns[i] = column;
        }
        result.first.push_back(end);
    }
    find_mirrors(result);
    return result;
}

int BlockPattern::slot(int row, int wanted) const {
    const auto begin = column.begin() + first[at(row)];
    const auto end = column.begin() + first[at(row) + 1];
    const auto found = std::lower_bound(begin, end, wanted);
    return found != end && *found == wanted ? static_cast<int>(found - column.begin()) : -1;
}

BlockPattern block_pattern(int rows, std::span<const int> first, std::span<const int> node) {
    const RowGroups groups = groups_of_rows(rows, first, node);
    BlockPattern pattern;
    pattern.first.reserve(at(rows) + 1);
    pattern.column.reserve(8 * at(rows));
    pattern.first.push_back(0);
    std::vector<int> seen(at(rows), -1);
    for (int row = 0; row < rows; ++row) {
        const std::size_t begin = pattern.column.size();
        pattern.column.push_back(row);
        seen[at(row)] = row;
        for (int i = groups.offset[at(row)]; i < groups.offset[at(row) + 1]; ++i) {
            const int group = groups.group[at(i)];
            for (int k = first[at(group)]; k < first[at(group) + 1]; ++k) {
                const int column = node[at(k)];
                if (seen[at(column)] != row) {
                    seen[at(column)] = row;
                    pattern.column.push_back(column);
                }
            }
        }
        std::sort(pattern.column.begin() + static_cast<std::ptrdiff_t>(begin), pattern.column.end());
        pattern.first.push_back(static_cast<int>(pattern.column.size()));
    }
    find_mirrors(pattern);
    return pattern;
}

std::size_t values_of(const BlockPattern& pattern) { return 9 * at(pattern.blocks() + 1) + 1; }

BlockValues zero_values(const BlockPattern& pattern) { return BlockValues(values_of(pattern), 0.0); }

Mat3 block_of(const BlockValues& values, int slot) { return Eigen::Map<const Mat3>(values.data() + 9 * at(slot)); }

void add_block(BlockValues& values, int slot, const Mat3& block) {
    Eigen::Map<Mat3>(values.data() + 9 * at(slot)) += block;
}

void clear_upper(const BlockPattern& pattern, BlockValues& values) {
    for (int i = 0; i < pattern.rows(); ++i) {
        std::fill(values.begin() + 9 * pattern.diagonal[at(i)], values.begin() + 9 * pattern.first[at(i) + 1], 0.0);
    }
    std::fill(values.end() - 10, values.end(), 0.0);
}

void mirror_upper(const BlockPattern& pattern, BlockValues& values) {
    for (int i = 0; i < pattern.rows(); ++i) {
        for (int slot = pattern.diagonal[at(i)] + 1; slot < pattern.first[at(i) + 1]; ++slot) {
            const double* const from = values.data() + 9 * at(slot);
            double* const to = values.data() + 9 * at(pattern.mirror[at(slot)]);
            for (std::size_t c = 0; c < 3; ++c) {
                for (std::size_t r = 0; r < 3; ++r) {
                    to[3 * c + r] = from[3 * r + c];
                }
            }
        }
    }
}

void multiply(const BlockPattern& pattern, const BlockValues& values, std::span<const double> x, std::span<double> y) {
    RHEXIS_ASSERT(x.size() >= 3 * at(pattern.rows()) && y.size() >= 3 * at(pattern.rows()));
    for (int i = 0; i < pattern.rows(); ++i) {
        Vec3 sum = Vec3::Zero();
        for (int slot = pattern.first[at(i)]; slot < pattern.first[at(i) + 1]; ++slot) {
            const Eigen::Map<const Mat3> block(values.data() + 9 * at(slot));
            const Eigen::Map<const Vec3> part(x.data() + 3 * at(pattern.column[at(slot)]));
            sum += block * part;
        }
        Eigen::Map<Vec3>(y.data() + 3 * at(i)) = sum;
    }
}

}  // namespace rhexis
