// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/rating_answers.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/near_names.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

using nlohmann::json;

std::string text_in(const json& object, const char* key) {
    return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : "";
}

Result<records::RatedItem> item_from(const std::string& id, const json& answer, const std::string& where) {
    constexpr const char* allowed = R"(score: 1 to 5, or null for not applicable)";
    if (!answer.is_object() || !answer.contains("score")) {
        return Error{"item " + id + " has no score", where, allowed};
    }
    const json& score = answer["score"];
    if (score.is_null()) {
        return records::RatedItem{id, std::nullopt, text_in(answer, "comment")};
    }
    if (!score.is_number_integer() || score.get<double>() < 1.0 || score.get<double>() > 5.0) {
        return Error{"item " + id + " has the score " + score.dump(), where, allowed};
    }
    return records::RatedItem{id, score.get<int>(), text_in(answer, "comment")};
}

Status take_items(const json& items, const std::string& where, records::Rating& rating) {
    const std::vector<std::string>& known = rated_item_names();
    for (const auto& [id, answer] : items.items()) {
        if (std::find(known.begin(), known.end(), id) == known.end()) {
            return Error{"there is no item " + id, where, suggestion(id, known)};
        }
    }
    for (const std::string& id : known) {
        const Result<records::RatedItem> item = item_from(id, items.value(id, json()), where);
        if (!item) {
            return item.error();
        }
        rating.items.push_back(item.value());
    }
    return success();
}

}  // namespace

const std::vector<std::string>& rated_item_names() {
    static const std::vector<std::string> names = {"T1",  "T2",  "T3",  "T4",  "T5", "T6", "T7", "T8", "T9", "T10",
                                                   "T11", "T12", "T13", "T14", "G1", "G2", "G3", "G4", "G5", "G6"};
    return names;
}

Result<Answers> read_answers(const std::string& path) {
    const Result<std::string> text = read_whole_file(path);
    if (!text) {
        return text.error();
    }
    const json given = json::parse(text.value(), nullptr, false);
    if (!given.is_object() || given.value("schema", json()) != 1 || text_in(given, "form") != "OSACSS" ||
        !given.value("items", json()).is_object()) {
        return Error{"this is no file of answers", path, "what 'Save answers' of a form of rhexis rate saves"};
    }
    Answers answers;
    answers.code = text_in(given, "case");
    answers.rating.comment = text_in(given, "comment");
    const Status taken = take_items(given["items"], path, answers.rating);
    return taken ? Result<Answers>(std::move(answers)) : taken.error();
}

std::string code_of(const std::string& sha256) { return sha256.substr(0, 12); }

}  // namespace rhexis::cli
