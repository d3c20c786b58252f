// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/opening_files.hpp"

#include <filesystem>
#include <utility>

#include "session/torn_opening.hpp"
#include "trial/places.hpp"

namespace rhexis {
namespace {

constexpr const char* diameter_setting = "capsulorhexis.diameter_mm";

/// "NAME:START" in its two parts, the second empty where it is none.
std::pair<std::string, std::string> exercise_and_start(const std::string& given) {
    const std::size_t colon = given.rfind(':');
    return colon == std::string::npos ? std::pair(given, std::string())
                                      : std::pair(given.substr(0, colon), given.substr(colon + 1));
}

/// The file that an opening is read from: one that is there, or what a start of an exercise is kept in.
Result<std::string> file_of_opening(const std::string& given, const StartRequest& request) {
    const auto [exercise, start] = exercise_and_start(given);
    std::error_code ignored;
    if (start.empty() || std::filesystem::exists(given, ignored)) {
        return recording_path(given);
    }
    StartRequest of_exercise{exercise, start, {}, request.root, request.quiet, "", true};
    for (const auto& [name, value] : request.set) {
        if (name.starts_with("patient.")) {
            of_exercise.set[name] = value;
        }
    }
    const Result<Start> made = find_start(of_exercise);
    return made ? Result<std::string>(made.value().state) : made.error();
}

}  // namespace

Result<std::vector<double>> opening_from(const std::string& given, const StartRequest& request) {
    if (given.empty()) {
        return std::vector<double>();
    }
    if (request.set.contains(diameter_setting)) {
        return Error{"the opening is that of " + given + ", and " + diameter_setting + " is set too", "",
                     "the one or the other"};
    }
    const Result<std::string> file = file_of_opening(given, request);
    const Result<TornOpening> torn = file ? read_torn_opening(file.value()) : file.error();
    if (!torn) {
        return torn.error();
    }
    return torn.value().unfit ? Result<std::vector<double>>(*torn.value().unfit) : torn.value().radii;
}

}  // namespace rhexis
