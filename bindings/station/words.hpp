// SPDX-License-Identifier: GPL-3.0-or-later
// What the station says in the language of the trainee. English is the key: what has no translation stays English
// (scripts/texts/fr/station.lua).
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "lua/spoken_words.hpp"

namespace rhexis::station {

class Words {
public:
    /// root: folder of scripts/. language: "fr", ...; "" and "en": English. instruments: of the scene.
    static Result<Words> load(const std::string& root, const std::string& language,
                              const std::vector<std::string>& instruments);

    /// Each %s is replaced by the next value.
    std::string operator()(const std::string& english, std::initializer_list<std::string> values = {}) const;
    [[nodiscard]] bool has(const std::string& english) const { return spoken_.texts.contains(english); }
    /// What people call an instrument of the scene, or a setting.
    [[nodiscard]] std::string instrument(const std::string& name) const;
    [[nodiscard]] std::string setting(const std::string& name) const;

private:
    SpokenWords spoken_;
};

}  // namespace rhexis::station
