// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the store. A change that older programs cannot read raises the version.
#pragma once

#include <vector>

namespace rhexis::records {

inline constexpr int schema_version = 3;
inline constexpr int application_id = 0x72687872;  ///< "rhxr", in the file's header

/// Statements that make the tables of a new store.
std::vector<const char*> schema_statements();

/// Statements that bring a store of an older version up to this one.
std::vector<const char*> upgrade_statements(int from_version);

}  // namespace rhexis::records
