// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files in and out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace rhexis {

/// The content of a regular file of at most `most_bytes`. Errors name the path.
Result<std::string> read_text_file(const std::string& path, std::size_t most_bytes);

/// Writes beside the target and renames, so that the file appears whole or not at all, also where several processes
/// write it at once.
Status write_text_file(const std::string& path, std::string_view content);

}  // namespace rhexis
