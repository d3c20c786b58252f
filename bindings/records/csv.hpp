// SPDX-License-Identifier: GPL-3.0-or-later
// The store as tables: UTF-8, one header, comma and RFC 4180 quotes, SI units in the names of columns.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "records/attempt.hpp"

namespace rhexis::records {

/// File name to content: attempts.csv, items.csv, measures.csv, events.csv, ratings.csv.
std::map<std::string, std::string> csv_of(const std::vector<Attempt>& attempts, const std::vector<Rating>& ratings);

}  // namespace rhexis::records
