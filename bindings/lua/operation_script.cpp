// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/operation_script.hpp"

#include <algorithm>
#include <filesystem>

#include "lua/curriculum_files.hpp"
#include "lua/exercise_script.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

std::string text_of(const json& object, const char* key) {
    return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : std::string();
}

/// An exercise in a folder beside the operation's own file goes before one in curricula/.
std::string place_of(const std::string& exercise, const CurriculumFiles& operation) {
    const std::filesystem::path beside = std::filesystem::path(operation.folder) / exercise;
    std::error_code ignored;
    return std::filesystem::exists(beside, ignored) ? beside.string() : exercise;
}

OperationPart part_from(const json& given, const CurriculumFiles& operation) {
    return {text_of(given, "id"),    text_of(given, "title"),         place_of(text_of(given, "exercise"), operation),
            text_of(given, "start"), given.value("continues", false), text_of(given, "opening"),
            text_of(given, "where")};
}

/// Follows operations that are made of operations until the way comes round or ends.
Status no_operation_within(const OperationPart& part, std::vector<std::string> way, const std::string& root) {
    const Result<CurriculumFiles> files = find_curriculum(part.exercise, root);
    if (!files) {
        const bool bare = part.exercise.find('/') == std::string::npos;
        const std::string beside = bare ? "or a folder, as seen from the operation's: ../" + part.exercise : "";
        const std::string& known = files.error().allowed;
        const std::string between = known.empty() || beside.empty() ? "" : "; ";
        return Error{"part " + part.id + ": " + files.error().what, part.where, known + between + beside};
    }
    const Result<json> listing = ExerciseScript::listing(files.value(), root);
    if (!listing) {
        return listing.error();
    }
    if (!listing.value().is_object()) {
        return success();
    }
    const bool round = std::find(way.begin(), way.end(), files.value().script) != way.end();
    if (round) {
        return Error{"circular composition: part " + part.id + " leads back to " + files.value().id, part.where,
                     "an operation is made of exercises"};
    }
    way.push_back(files.value().script);
    for (const json& inner : listing.value().at("parts")) {
        Status below = no_operation_within(part_from(inner, files.value()), way, root);
        if (!below) {
            return below;
        }
    }
    return Error{"part " + part.id + ": " + files.value().id + " is itself an operation", part.where,
                 "exercises; name its parts here"};
}

}  // namespace

Result<std::optional<Operation>> load_operation(const std::string& curriculum, const std::string& root,
                                                const std::string& language) {
    const Result<CurriculumFiles> files = find_curriculum(curriculum, root);
    if (!files) {
        return files.error();
    }
    const Result<json> listing = ExerciseScript::listing(files.value(), root, language);
    if (!listing) {
        return listing.error();
    }
    if (!listing.value().is_object()) {
        return std::optional<Operation>();
    }
    const json& found = listing.value();
    Operation operation;
    operation.name = curriculum;
    operation.identity = {{"id", files.value().id},
                          {"title", found.at("title")},
                          {"version", found.at("version")},
                          {"sha256", files.value().sha256}};
    operation.summary = text_of(found, "summary");
    operation.untranslated = found.at("untranslated").get<std::vector<std::string>>();
    operation.objectives = found.at("objectives").get<std::vector<std::string>>();
    for (const json& given : found.at("parts")) {
        operation.parts.push_back(part_from(given, files.value()));
        Status fits = no_operation_within(operation.parts.back(), {files.value().script}, root);
        if (!fits) {
            return fits.error();
        }
    }
    return std::optional<Operation>(std::move(operation));
}

}  // namespace rhexis
