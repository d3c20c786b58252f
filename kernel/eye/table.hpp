// SPDX-License-Identifier: GPL-3.0-or-later
// Values between the rows of a small table, with the same bits on every machine.
#pragma once

#include <span>

namespace rhexis {

struct TableRow {
    double at = 0.0;
    double value = 0.0;
};

/// Straight lines between rows; the end values outside. rows: ascending in `at`, not empty.
double linear_between(std::span<const TableRow> rows, double at);

/// Straight lines of the logarithm between rows; the end values outside. Values > 0.
double geometric_between(std::span<const TableRow> rows, double at);

}  // namespace rhexis
