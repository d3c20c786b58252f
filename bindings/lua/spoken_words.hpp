// SPDX-License-Identifier: GPL-3.0-or-later
// What instruments and settings are called, and all shared translations: scripts/report/spoken.lua.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

struct SpokenWords {
    std::map<std::string, std::string> texts;        ///< translations by the English text; none in English
    std::map<std::string, std::string> instruments;  ///< by name
    std::map<std::string, std::string> settings;     ///< by name
};

/// root: folder of scripts/. language: "" and "en" are English.
Result<SpokenWords> load_spoken_words(const std::string& root, const std::string& language,
                                      const std::vector<std::string>& instruments);

}  // namespace rhexis
