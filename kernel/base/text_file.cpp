// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/text_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace rhexis {

namespace fs = std::filesystem;

Result<std::string> read_text_file(const std::string& path, std::size_t most_bytes) {
    std::error_code failure;
    const fs::file_status what = fs::status(path, failure);
    if (what.type() == fs::file_type::none) {  // a folder on the way to it cannot be looked into
        return Error{"cannot be read: " + failure.message(), path, ""};
    }
    if (what.type() != fs::file_type::regular) {
        return Error{fs::exists(what) ? "is not a file" : "does not exist", path, ""};
    }
    failure.clear();
    const std::uintmax_t size = fs::file_size(path, failure);
    if (!failure && size > most_bytes) {
        return Error{"has " + std::to_string(size) + " bytes", path, "at most " + std::to_string(most_bytes)};
    }
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string text(failure ? 0 : static_cast<std::size_t>(size), '\0');
    if (failure || !file.read(text.data(), static_cast<std::streamsize>(text.size()))) {
        return Error{std::string("cannot be read: ") + std::strerror(errno != 0 ? errno : EIO), path, ""};
    }
    return text;
}

std::string_view without_mark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

}  // namespace rhexis
