// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis records agreement: simulator against raters, and raters among themselves.
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/counted.hpp"
#include "cli/places.hpp"
#include "cli/records_command.hpp"
#include "lua/report_script.hpp"
#include "records/comparison.hpp"

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
                "bias (95 % limits)", "n");
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

Result<json> agreement_of(const RecordsOptions& given) {
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
    return data;
}

int agreement(const RecordsOptions& given, const Context& context) {
    if (const Status status = check_page_language(given, context); !status) {
        return complain(status.error());
    }
    const Result<json> data = agreement_of(given);
    if (!data) {
        return complain(data.error());
    }
    if (given.json) {
        std::cout << data.value().dump(2) << '\n';
    } else {
        print(data.value());
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
        "the raters (Bland and Altman 1986). Total: mean points per item x 20, over the items that everybody scored.");
    command->add_option("--exercise", given->exercise, "Of attempts at this one only");
    command->add_option("--cohort", given->cohort, "Of attempts of this cohort only");
    CLI::Option* html = command->add_option("--html", given->html, "Write a page with the table and a chart per item");
    add_page_language(*command, given, html);
    command->add_flag("--json", given->json, "Print it as JSON, with every pair of raters and every point");
    command->callback([given, &context] { context.status = agreement(*given, context); });
}

}  // namespace rhexis::cli
