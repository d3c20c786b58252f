// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/block_matrix.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace rhexis {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<std::vector<int>> neighbours(int rows, std::span<const int> first, std::span<const int> node) {
    std::vector<std::vector<int>> result(at(rows));
    for (int i = 0; i < rows; ++i) {
        result[at(i)].push_back(i);
    }
    for (std::size_t group = 0; group + 1 < first.size(); ++group) {
        for (int a = first[group]; a < first[group + 1]; ++a) {
            for (int b = first[group]; b < first[group + 1]; ++b) {
                result[at(node[at(a)])].push_back(node[at(b)]);
            }
        }
    }
    for (std::vector<int>& row : result) {
        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
    }
    return result;
}

}  // namespace

int BlockPattern::slot(int row, int wanted) const {
    const auto begin = column.begin() + first[at(row)];
    const auto end = column.begin() + first[at(row) + 1];
    const auto found = std::lower_bound(begin, end, wanted);
    return found != end && *found == wanted ? static_cast<int>(found - column.begin()) : -1;
}

BlockPattern block_pattern(int rows, std::span<const int> first, std::span<const int> node) {
    BlockPattern pattern;
    pattern.first.push_back(0);
    for (const std::vector<int>& row : neighbours(rows, first, node)) {
        pattern.column.insert(pattern.column.end(), row.begin(), row.end());
        pattern.first.push_back(static_cast<int>(pattern.column.size()));
    }
    pattern.mirror.resize(pattern.column.size());
    pattern.diagonal.resize(at(rows));
    for (int i = 0; i < rows; ++i) {
        pattern.diagonal[at(i)] = pattern.slot(i, i);
        for (int slot = pattern.first[at(i)]; slot < pattern.first[at(i) + 1]; ++slot) {
            pattern.mirror[at(slot)] = pattern.slot(pattern.column[at(slot)], i);
        }
    }
    return pattern;
}

BlockValues zero_values(const BlockPattern& pattern) { return BlockValues(9 * at(pattern.blocks() + 1) + 1, 0.0); }

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
