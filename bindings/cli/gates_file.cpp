// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/gates_file.hpp"

#include "trial/places.hpp"

namespace rhexis::cli {

Result<records::Gates> read_gates(const std::string& file, const std::string& root) {
    const std::string path = file.empty() ? root + "/rubrics/gates.json" : file;
    const Result<std::string> text = read_whole_file(path);
    if (!text) {
        return text.error();
    }
    const nlohmann::json given = nlohmann::json::parse(text.value(), nullptr, false);
    if (given.is_discarded()) {
        return Error{"this is no JSON", path, "gates as in rubrics/gates.json"};
    }
    return records::gates_from(given, path);
}

}  // namespace rhexis::cli
