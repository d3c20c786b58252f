// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/words.hpp"

#include <map>
#include <utility>

namespace rhexis::station {
namespace {

std::string found(const std::map<std::string, std::string>& words, const std::string& key) {
    const auto at = words.find(key);
    return at == words.end() ? key : at->second;
}

}  // namespace

Result<Words> Words::load(const std::string& root, const std::string& language,
                          const std::vector<std::string>& instruments) {
    Result<SpokenWords> spoken = load_spoken_words(root, language, instruments);
    if (!spoken) {
        return spoken.error();
    }
    Words words;
    words.spoken_ = std::move(spoken).value();
    return words;
}

std::string Words::operator()(const std::string& english, std::initializer_list<std::string> values) const {
    std::string text = found(spoken_.texts, english);
    std::size_t from = 0;
    for (const std::string& value : values) {
        const std::size_t at = text.find("%s", from);
        if (at == std::string::npos) {
            break;
        }
        text.replace(at, 2, value);
        from = at + value.size();
    }
    return text;
}

std::string Words::instrument(const std::string& name) const { return found(spoken_.instruments, name); }
std::string Words::setting(const std::string& name) const { return found(spoken_.settings, name); }

}  // namespace rhexis::station
