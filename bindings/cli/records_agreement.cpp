// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis records agreement: simulator against raters, and raters among themselves.
#include <cstdio>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/counted.hpp"
#include "cli/exercise_title.hpp"
#include "cli/records_command.hpp"
#include "lua/report_script.hpp"
#include "records/comparison.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

using nlohmann::json;

std::string number(const json& value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value.get<double>());
    return text;
}

std::string correlation(const json& icc, const char* which) { return icc.contains("why") ? "-" : number(icc[which]); }

std::string limits(const json& found) {
    return found.contains("why")
               ? "-"
               : number(found["bias"]) + " (" + number(found["low"]) + " to " + number(found["high"]) + ")";
}

std::string count(const json& found) { return found.contains("n") ? std::to_string(found["n"].get<int>()) : "-"; }

/// Why a row lacks a figure, once.
std::string reason(const json& row) {
    const std::string raters = row["raters"]["icc"].value("why", "");
    const std::string simulator = row["simulator"]["icc"].value("why", row["simulator"]["limits"].value("why", ""));
    return (raters.empty() ? "" : "raters: " + raters) + (raters.empty() || simulator.empty() ? "" : "; ") +
           (simulator.empty() ? "" : "simulator: " + simulator);
}

void print(const json& data) {
    std::printf("%s, %s\n", counted(data["attempts"].get<std::size_t>(), "rated attempt").c_str(),
                counted(data["raters"].size(), "rater").c_str());
    for (const json& rater : data["left_out"]) {
        std::printf("left out of the correlation among raters, because of too few ratings: %s\n",
                    rater.get<std::string>().c_str());
    }
    std::printf("       raters among themselves    simulator and mean of raters\n");
    std::printf("%-5s  %-8s  %-8s  %-4s   %-8s  %-26s  %-4s\n", "item", "ICC(2,1)", "ICC(2,k)", "n", "ICC(2,1)",
                "bias, points (95 % limits)", "n");
    for (const json& row : data["rows"]) {
        const json& raters = row["raters"]["icc"];
        const json& own = row["simulator"];
        std::printf("%-5s  %-8s  %-8s  %-4s   %-8s  %-26s  %-4s  %s\n", row["item"].get<std::string>().c_str(),
                    correlation(raters, "single").c_str(), correlation(raters, "average").c_str(),
                    count(raters).c_str(), correlation(own["icc"], "single").c_str(), limits(own["limits"]).c_str(),
                    count(own["limits"]).c_str(), reason(row).c_str());
    }
    for (const json& pair : data["rows"].back()["raters"]["pairs"]) {
        std::printf("total, %s - %s: %s, n %s\n", pair["a"].get<std::string>().c_str(),
                    pair["b"].get<std::string>().c_str(), limits(pair["limits"]).c_str(),
                    count(pair["limits"]).c_str());
    }
}

/// The total, for each exercise on its own.
void print_exercises(const json& exercises) {
    if (exercises.size() < 2) {
        return;
    }
    std::printf("\n%-24s  %-8s  %-8s  %-9s  %s\n", "total, by exercise", "attempts", "raters", "simulator",
                "bias, points of 20 to 100 (95 % limits)");
    for (const json& one : exercises) {
        const json& total = one["total"];
        std::printf("%-24s  %-8d  %-8s  %-9s  %-26s  %s\n", one["exercise"].get<std::string>().c_str(),
                    one["attempts"].get<int>(), correlation(total["raters"]["icc"], "single").c_str(),
                    correlation(total["simulator"]["icc"], "single").c_str(),
                    limits(total["simulator"]["limits"]).c_str(), reason(total).c_str());
    }
}

json by_exercise(const std::vector<records::Attempt>& attempts, const std::vector<records::Rating>& ratings,
                 const std::string& language, const std::string& root) {
    std::map<std::string, std::vector<records::Attempt>> groups;
    for (const records::Attempt& attempt : attempts) {
        groups[attempt.exercise].push_back(attempt);
    }
    json exercises = json::array();
    for (const auto& [exercise, own] : groups) {
        const json data = records::compare_judges(own, ratings);
        if (data["attempts"] != 0) {
            exercises.push_back({{"exercise", exercise},
                                 {"title", title_of(exercise, language, root)},
                                 {"attempts", data["attempts"]},
                                 {"total", data["rows"].back()}});
        }
    }
    return exercises;
}

Result<json> agreement_of(const RecordsOptions& given, const Context& context) {
    Result<records::Store> store = open_records(given);
    if (!store) {
        return store.error();
    }
    const Result<std::vector<records::Attempt>> attempts = finished_attempts(store.value(), given);
    const Result<std::vector<records::Rating>> ratings = store.value().ratings();
    if (!attempts || !ratings) {
        return attempts ? ratings.error() : attempts.error();
    }
    json data = records::compare_judges(attempts.value(), ratings.value());
    if (data["attempts"] == 0) {
        return Error{
            "nobody has rated anything yet", store.value().path(),
            "rhexis rate RECORDING... makes forms, rhexis rate RECORDING --answers FILE --rater NAME stores them"};
    }
    const Result<std::string> language = language_of_page(given.language, context.root);
    if (!language) {
        return language.error();
    }
    data["exercises"] = by_exercise(attempts.value(), ratings.value(), language.value(), context.root);
    return data;
}

int agreement(const RecordsOptions& given, const Context& context) {
    if (const Status status = check_page_language(given, context); !status) {
        return complain(status.error());
    }
    const Result<json> data = agreement_of(given, context);
    if (!data) {
        return complain(data.error());
    }
    if (given.json) {
        std::cout << data.value().dump(2) << '\n';
    } else {
        print(data.value());
        print_exercises(data.value()["exercises"]);
    }
    if (given.html.empty()) {
        return done;
    }
    return write_records_page(given, "records.agreement", data.value(), context);
}

}  // namespace

void add_records_agreement(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context) {
    CLI::App* command = records.add_subcommand("agreement", "ICC and Bland-Altman of simulator and raters, per item");
    command->footer(
        "ICC(2,1): one judge of many; ICC(2,k): the mean of these. Two-way random effects, absolute agreement\n"
        "(Shrout and Fleiss 1979), over the attempts that all raters scored on the item. Bias: simulator minus mean "
        "of\n"
        "the raters (Bland and Altman 1986), in points: 1 to 5 of an item, 20 to 100 of the total, the mean of the "
        "items that\n"
        "everybody scored x 20. Of several exercises, each has a line of its own.");
    command->add_option("--exercise", given->exercise, "Of attempts at this one only");
    command->add_option("--cohort", given->cohort, "Of attempts of this cohort only");
    CLI::Option* html = command->add_option("--html", given->html, "Write a page with the table and a chart per item");
    add_page_language(*command, given, html);
    command->add_flag("--json", given->json, "Print it as JSON, with every pair of raters and every point");
    command->callback([given, &context] { context.status = agreement(*given, context); });
}

}  // namespace rhexis::cli
