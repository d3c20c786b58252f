// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/accuracy_words.hpp"

#include "base/numbers.hpp"
#include "session/accuracy_quantities.hpp"
#include "session/choose_accuracy.hpp"

namespace rhexis {
namespace {

using nlohmann::json;
using Numbers = std::map<std::string, double>;

/// "lens 0.1, anterior_capsule 0.15".
std::string kept_unsaid(std::string_view quantity) {
    if (quantity == time_quantity) {
        return short_number(standard_time_error_s);
    }
    std::string text;
    for (const AccuracyModel& model : accuracy_models()) {
        for (const ModelQuantity& own : model.quantities) {
            if (own.name == quantity) {
                text += (text.empty() ? "" : ", ") + std::string(model.tissue) + " " + short_number(own.standard);
            }
        }
    }
    return text;
}

/// As the engine gives it: a table without names reads as a list.
Numbers numbers_in(const json& object) { return object.is_object() ? object.get<Numbers>() : Numbers(); }

SceneAccuracy accuracy_in(const json& given) {
    SceneAccuracy accuracy{given.at("step_s"), given.at("step_by_hand"), given.at("time_s"), {}};
    for (const json& model : given.at("models")) {
        accuracy.models.push_back({model.at("model"), model.at("way"), numbers_in(model.at("mesh")),
                                   numbers_in(model.at("budget")), numbers_in(model.at("expected")), model.at("cost"),
                                   model.at("by_hand"), numbers_in(model.at("instead")), model.at("machine")});
    }
    return accuracy;
}

AccuracyWish wish_in(const json& given) {
    AccuracyWish wish;
    wish.budget = numbers_in(given.at("accuracy"));
    wish.where = given.value("accuracy_where", "");
    if (given.at("step_by_hand") == true) {
        wish.step_s = given.at("step_s").get<double>();
    }
    if (given.at("patient").contains("tetrahedra")) {
        wish.by_hand.insert("patient.tetrahedra");
    }
    for (const auto& [name, value] : given.at("settings").items()) {
        wish.by_hand.insert(name);
    }
    return wish;
}

}  // namespace

json quantities_json() {
    json list = json::array();
    for (const AccuracyQuantity& quantity : accuracy_quantities()) {
        list.push_back({{"name", quantity.name},
                        {"unit", quantity.unit},
                        {"from", quantity.minimum},
                        {"to", quantity.maximum},
                        {"meaning", quantity.meaning},
                        {"kept", kept_unsaid(quantity.name)}});
    }
    return list;
}

json accuracy_json(const SceneAccuracy& accuracy) {
    json models = json::array();
    for (const ModelAccuracy& model : accuracy.models) {
        models.push_back({{"model", model.model},
                          {"way", model.way},
                          {"mesh", model.mesh},
                          {"budget", model.budget},
                          {"expected", model.expected},
                          {"cost", model.cost},
                          {"by_hand", model.by_hand},
                          {"instead", model.instead},
                          {"machine", model.machine}});
    }
    return {{"step_s", accuracy.step_s},
            {"step_by_hand", accuracy.step_by_hand},
            {"time_s", accuracy.time_s},
            {"models", models},
            {"cost", expected_cost(accuracy)}};
}

Status choose_accuracy_of(const json& given, const std::string& root, SceneDescription& scene) {
    if (given.contains("chosen") && given["chosen"].is_object()) {
        set_accuracy(accuracy_in(given["chosen"]), scene);
        return success();
    }
    const Result<std::vector<AccuracyTable>> tables = read_accuracy_tables(root + "/assets/accuracy", scene);
    if (!tables) {
        return tables.error();
    }
    const Result<SceneAccuracy> chosen = choose_accuracy(scene, wish_in(given), tables.value());
    if (!chosen) {
        return chosen.error();
    }
    set_accuracy(chosen.value(), scene);
    return success();
}

}  // namespace rhexis
