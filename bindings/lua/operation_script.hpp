// SPDX-License-Identifier: GPL-3.0-or-later
// What an operation is made of: exercises, one after the other, on one eye (scripts/operation.lua).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/result.hpp"

namespace rhexis {

struct OperationPart {
    std::string id;
    std::string title;
    std::string exercise;    ///< as for rhexis run
    std::string start;       ///< of its starts.lua; "": none
    bool continues = false;  ///< begins in the state that the part before it left
    std::string opening;     ///< id of the part in which the opening of the bag was torn; "": none
    std::string where;       ///< file:line
};

struct Operation {
    std::string name;         ///< as for rhexis run
    nlohmann::json identity;  ///< {"id","title","version","sha256"}
    std::string summary;
    std::vector<std::string> objectives;
    std::vector<OperationPart> parts;
    std::vector<std::string> untranslated;  ///< texts of its own that lack a translation, each a line
};

/// Nothing when the curriculum is an exercise. Fails when it, or an exercise that it names, cannot be found or read,
/// or when a part is itself an operation (which names the way round when they are made of each other).
/// language: of its texts, "" for English.
Result<std::optional<Operation>> load_operation(const std::string& curriculum, const std::string& root,
                                                const std::string& language = "");

}  // namespace rhexis
