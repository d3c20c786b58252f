// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/pseudonym.hpp"

#include <algorithm>
#include <string_view>

namespace rhexis::records {
namespace {

constexpr std::size_t longest = 40;

bool plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
}

}  // namespace

Status check_pseudonym(const std::string& name, const std::string& option) {
    constexpr const char* allowed = "a pseudonym of up to 40 letters, digits, '-', '_' and '.', as in P07";
    if (name.empty() || name.size() > longest) {
        return Error{option + " is " + (name.empty() ? "empty" : "longer than 40 letters"), "", allowed};
    }
    if (name.find('@') != std::string::npos) {
        return Error{option + " " + name + " looks like an e-mail address; the store keeps pseudonyms only", "",
                     allowed};
    }
    if (!std::all_of(name.begin(), name.end(), plain) || name.front() == '-' || name.front() == '.') {
        return Error{option + " '" + name + "' is no pseudonym", "", allowed};
    }
    return success();
}

}  // namespace rhexis::records
