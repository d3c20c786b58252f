// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files that are read; see output_file.hpp for those that are written.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace rhexis {

/// The content of a regular file of at most `most_bytes`. Errors name the path.
Result<std::string> read_text_file(const std::string& path, std::size_t most_bytes);

/// Without the byte order mark that some editors put at the beginning of UTF-8.
std::string_view without_mark(std::string_view text);

}  // namespace rhexis
