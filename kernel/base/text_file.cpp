// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/text_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace rhexis {

namespace fs = std::filesystem;

Result<std::string> read_text_file(const std::string& path, std::size_t most_bytes) {
    std::error_code failure;
    if (!fs::is_regular_file(path, failure)) {
        return Error{fs::exists(path, failure) ? "is not a file" : "does not exist", path, ""};
    }
    const std::uintmax_t size = fs::file_size(path, failure);
    if (!failure && size > most_bytes) {
        return Error{"has " + std::to_string(size) + " bytes", path, "at most " + std::to_string(most_bytes)};
    }
    std::ifstream file(path, std::ios::binary);
    std::string text(failure ? 0 : static_cast<std::size_t>(size), '\0');
    if (failure || !file.read(text.data(), static_cast<std::streamsize>(text.size()))) {
        return Error{"cannot be read", path, ""};
    }
    return text;
}

Status write_text_file(const std::string& path, std::string_view content) {
    const std::string unfinished = path + "." + std::to_string(::getpid()) + ".unfinished";  // others may write it too
    errno = 0;
    std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    std::error_code failure;
    const int reason = errno;
    if (file) {
        fs::rename(unfinished, path, failure);
        if (!failure) {
            return success();
        }
    }
    const std::string why = failure ? failure.message() : std::strerror(reason != 0 ? reason : EIO);
    fs::remove(unfinished, failure);
    return Error{"cannot be written: " + why, path, ""};
}

}  // namespace rhexis
