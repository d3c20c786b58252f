// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/kept_parts.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/assert.hpp"
#include "base/output_file.hpp"
#include "base/text_file.hpp"
#include "tracking/json_fields.hpp"

namespace rhexis::tracking {
namespace {

constexpr std::size_t longest_part = std::size_t{256} << 20;  ///< [bytes]

std::string text_of(const std::vector<double>& row) {
    std::string text = "[";
    char number[32];
    for (const double value : row) {
        RHEXIS_ASSERT(std::isfinite(value));
        std::snprintf(number, sizeof number, text.size() > 1 ? ", %.6g" : "%.6g", value);
        text += number;
    }
    return text + "]";
}

/// None: some of it is no list of numbers.
std::optional<Numbers> numbers_of(const Json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    Numbers numbers;
    for (const auto& [name, row] : json.items()) {
        if (!row.is_array()) {
            return std::nullopt;
        }
        std::vector<double>& values = numbers[name];
        for (const Json& value : row) {
            if (!value.is_number()) {
                return std::nullopt;
            }
            values.push_back(value.get<double>());
        }
    }
    return numbers;
}

}  // namespace

void append(const Numbers& from, Numbers& to) {
    for (const auto& [name, row] : from) {
        std::vector<double>& all = to[name];
        all.insert(all.end(), row.begin(), row.end());
    }
}

const std::vector<double>& row_of(const Numbers& numbers, const std::string& name) {
    static const std::vector<double> none;
    const auto found = numbers.find(name);
    return found == numbers.end() ? none : found->second;
}

Result<KeptParts> KeptParts::open(const std::string& folder) {
    Result<FolderLock> lock = FolderLock::take(folder);
    if (!lock) {
        return lock.error();
    }
    KeptParts parts;
    parts.folder_ = folder;
    parts.lock_ = std::make_unique<FolderLock>(std::move(lock).value());
    return parts;
}

std::string KeptParts::path_of(std::uint64_t seed, const std::string& part) const {
    return folder_ + "/" + std::to_string(seed) + "-" + part + ".json";
}

Result<std::optional<Numbers>> KeptParts::read(std::uint64_t seed, const std::string& part,
                                               const std::string& plan) const {
    const std::string path = path_of(seed, part);
    if (folder_.empty() || !std::filesystem::exists(path)) {
        return std::optional<Numbers>{};
    }
    const Result<std::string> text = read_text_file(path, longest_part);
    if (!text) {
        return text.error();
    }
    const Json json = Json::parse(text.value(), nullptr, false);
    if (!json.is_object() || !json.contains("plan") || !json.contains("numbers")) {
        return Error{"this is no part of a measurement", path, "another folder, or without this file"};
    }
    if (json["plan"] != plan) {
        return Error{"this was measured with " + json["plan"].dump(), path,
                     "\"" + plan + "\"; another folder, or without this file"};
    }
    std::optional<Numbers> numbers = numbers_of(json["numbers"]);
    if (!numbers) {
        return Error{"numbers are missing in it", path, "another folder, or without this file"};
    }
    return numbers;
}

Status KeptParts::write(std::uint64_t seed, const std::string& part, const std::string& plan,
                        const Numbers& numbers) const {
    if (folder_.empty()) {
        return success();
    }
    std::string text = "{\n \"plan\": \"" + plan + "\",\n \"numbers\": {";
    const char* before = "\n  ";
    for (const auto& [name, row] : numbers) {
        text += before + ("\"" + name + "\": ") + text_of(row);
        before = ",\n  ";
    }
    return write_file(path_of(seed, part), text + "\n }\n}\n");
}

}  // namespace rhexis::tracking
