// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands below `rhexis records` have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/language.hpp"
#include "records/gates.hpp"
#include "records/store.hpp"

namespace rhexis::cli {

/// Options of all of them; each uses what it has named on its command line.
struct RecordsOptions {
    std::string store;
    std::string trainee;
    std::string exercise;
    std::string cohort;
    std::string arm;
    std::string attempt;
    std::vector<std::string> folders;
    std::string csv_style = "plain";
    std::string out;
    std::string html;
    std::string language;
    std::string gates;
    std::string course;
    double pass = -1.0;  ///< below 0: as the gates say
    bool json = false;
    bool yes = false;
    bool runs = false;
};

/// The store that is named, or the user's own. Attempts whose process came to its report and was killed before it
/// could store it are stored now.
Result<records::Store> open_records(const RecordsOptions& given);

/// The finished attempts that the filter lets through, with their events and items, oldest first.
Result<std::vector<records::Attempt>> finished_attempts(records::Store& store, const RecordsOptions& given);

records::Wanted wanted_by(const RecordsOptions& given);

/// Fails where nothing was found because a name of the filter is nowhere in the store.
Status check_wanted(records::Store& store, const RecordsOptions& given, const std::vector<records::Attempt>& found);

/// --gates FILE and --pass SHARE, or rubrics/gates.json.
Result<records::Gates> gates_of(const RecordsOptions& given, const Context& context);

/// --language, of the page that `html` asks for: what is printed is English, so without a page it is refused.
void add_page_language(CLI::App& command, const std::shared_ptr<RecordsOptions>& given, CLI::Option* html);

/// Whether there are texts in the language of the page, if one is asked for; before anything is printed.
Status check_page_language(const RecordsOptions& given, const Context& context);

/// Writes the page that a module of scripts/ makes of `data` to --html, in the language of --language.
int write_records_page(const RecordsOptions& given, const std::string& module, nlohmann::json data,
                       const Context& context);

// One file for the commands that each of them adds below `records`.
void add_records_lists(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context);
void add_records_course(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context);
void add_records_progress(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context);
void add_records_agreement(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context);
void add_records_keeping(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context);

}  // namespace rhexis::cli
