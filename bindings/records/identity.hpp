// SPDX-License-Identifier: GPL-3.0-or-later
// Names and dates of what is stored.
#pragma once

#include <string>

namespace rhexis::records {

/// A random UUID (version 4, RFC 9562).
std::string new_id();

/// Now, in UTC: "2026-03-01T09:30:00Z".
std::string now_utc();

}  // namespace rhexis::records
