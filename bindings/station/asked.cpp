// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/asked.hpp"

#include <array>
#include <charconv>
#include <vector>

#include "base/near_names.hpp"
#include "base/numbers.hpp"

namespace rhexis::station {
namespace {

Result<Asked> dial_asked(const Stand& stand, const std::string& setting, std::string_view value) {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < stand.dials.size(); ++i) {
        const Dial& dial = stand.dials[i];
        known.push_back(dial.setting);
        if (dial.setting != setting) {
            continue;
        }
        Asked asked{-1, static_cast<int>(i), 0.0};
        const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), asked.value);
        const bool whole = fault == std::errc() && end == value.data() + value.size();
        if (!whole || !(asked.value >= dial.low && asked.value <= dial.high)) {
            return Error{"the staff was asked for " + setting + " = " + std::string(value), "",
                         short_number(dial.low) + " to " + short_number(dial.high)};
        }
        return asked;
    }
    return Error{"the machine has no dial '" + setting + "'", "", suggestion(setting, known)};
}

std::string shortest(double value) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

Result<Asked> what_is_asked(const Stand& stand, std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals != std::string_view::npos) {
        return dial_asked(stand, std::string(text.substr(0, equals)), text.substr(equals + 1));
    }
    std::vector<std::string> known;
    for (std::size_t i = 0; i < stand.requests.size(); ++i) {
        known.push_back(stand.requests[i].id);
        if (stand.requests[i].id == text || stand.requests[i].title == text) {
            return Asked{static_cast<int>(i), -1, 0.0};
        }
    }
    return Error{"the exercise has no request '" + std::string(text) + "'", "",
                 known.empty() ? "it has none" : suggestion(std::string(text), known)};
}

std::string words_of(const Command& command) {
    if (command.kind == CommandKind::request) {
        return command.name;
    }
    return command.kind == CommandKind::adjust ? command.name + "=" + shortest(command.value) : "";
}

}  // namespace rhexis::station
