// SPDX-License-Identifier: GPL-3.0-or-later
// The boxes of an MP4 file: 4 bytes of length, 4 letters, and what they hold.
#pragma once

#include <string>

#include "base/result.hpp"

namespace rhexis {

/// True if the file's boxes end with the file and one of them is the index.
bool is_whole_mp4(const std::string& path);

/// Writes `from` to `to` with the index before the pictures, so that a browser plays it while it loads. A file that has
/// it there already, or that is too large for its index's numbers to move, is copied as it is. Fails if `from` is not
/// whole or `to` cannot be written.
Status write_index_first(const std::string& from, const std::string& to);

}  // namespace rhexis
