// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/language.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace rhexis::cli {
namespace {

bool has_texts(const std::string& language, const std::string& root) {
    std::error_code ignored;
    return std::filesystem::exists(root + "/scripts/texts/" + language + ".lua", ignored);
}

}  // namespace

std::string language_of_environment(const std::string& root) {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(name);
        if (value != nullptr && *value != '\0') {
            const std::string language = std::string(value).substr(0, 2);
            return has_texts(language, root) ? language : "";
        }
    }
    return "";
}

Result<std::string> language_of_page(const std::string& given, const std::string& root) {
    if (given.empty() || given == "en") {
        return given.empty() ? language_of_environment(root) : given;
    }
    const bool plain =
        given.size() == 2 && std::all_of(given.begin(), given.end(), [](char c) { return c >= 'a' && c <= 'z'; });
    if (!plain || !has_texts(given, root)) {
        return Error{"--language " + given + ": there are no texts in it", "", "en, or a file of scripts/texts, as fr"};
    }
    return given;
}

}  // namespace rhexis::cli
