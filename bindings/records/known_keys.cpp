// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/known_keys.hpp"

#include <algorithm>

#include "base/near_names.hpp"

namespace rhexis::records {

Status check_keys(const nlohmann::json& given, const std::vector<std::string>& known, const std::string& where) {
    for (const auto& [key, value] : given.items()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            return Error{"what is " + key + "?", where, suggestion(key, known)};
        }
    }
    return success();
}

}  // namespace rhexis::records
