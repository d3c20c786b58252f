// SPDX-License-Identifier: GPL-3.0-or-later
// The store as tables: UTF-8, one header, RFC 4180 quotes, SI units in the names of columns.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "records/attempt.hpp"

namespace rhexis::records {

/// How a table is written. By default as programs read it; a European Excel takes semicolons, decimal commas and, to
/// know UTF-8, a byte order mark.
struct CsvStyle {
    char separator = ',';
    char decimal = '.';
    bool mark = false;
};

/// File name to content: attempts.csv, items.csv, measures.csv, events.csv, ratings.csv.
std::map<std::string, std::string> csv_of(const std::vector<Attempt>& attempts, const std::vector<Rating>& ratings,
                                          const CsvStyle& style = {});

}  // namespace rhexis::records
