// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis report: report.html again from what a run left behind.
#include <cstdio>
#include <filesystem>

#include "base/folder_lock.hpp"
#include "base/output_file.hpp"
#include "cli/command.hpp"
#include "cli/language.hpp"
#include "trial/html.hpp"
#include "trial/places.hpp"
#include "trial/rescore.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* report_help =
    "Makes report.html again from report.json, series.json and frames/ of a run.\n"
    "\n"
    "  rhexis report runs/groove-expert-1\n"
    "  rhexis report runs/groove-expert-1 --score-with rubrics/ico_oscar.lua      report_ico_oscar.html\n"
    "  rhexis report runs/groove-expert-1 --language fr      items, errors and labels; the exercise's own texts stay";

struct ReportOptions {
    std::string folder;
    std::string score_with;
    std::string language;
};

/// What another judge finds in the recording, in the words of report.json.
Result<nlohmann::json> judged_again(const ReportOptions& given, const Context& context) {
    const Result<Recording> recording = read_recording(recording_path(given.folder));
    if (!recording) {
        return recording.error();
    }
    const Result<Rescore> again =
        rescore(recording.value(), judge_of(recording.value(), given.score_with, context.root));
    if (!again) {
        return again.error();
    }
    if (!again.value().script_error.empty()) {
        return Error{again.value().script_error, given.score_with, ""};
    }
    if (again.value().simulated > 0) {
        std::fprintf(stderr, "rhexis: from step %llu on simulated again: %s; charts and pictures are as recorded\n",
                     static_cast<unsigned long long>(again.value().simulated), again.value().difference.c_str());
    }
    return again.value().result;
}

int report(const ReportOptions& given, const Context& context) {
    if (const Status whole = came_to_its_report(given.folder); !whole) {
        return complain(whole.error());
    }
    nlohmann::json instead = nlohmann::json::object();
    std::string file = given.folder + "/report.html";
    if (!given.score_with.empty()) {
        Result<nlohmann::json> judged = judged_again(given, context);
        if (!judged) {
            return complain(judged.error());
        }
        instead = std::move(judged).value();
        file = given.folder + "/report_" + std::filesystem::path(given.score_with).stem().string() + ".html";
    }
    if (!given.language.empty()) {
        const Result<std::string> language = language_of_page(given.language, context.root);
        if (!language) {
            return complain(language.error());
        }
        instead["language"] = language.value();
    }
    const Result<std::string> html = report_page(context.root, given.folder, instead);
    if (!html) {
        return complain(html.error());
    }
    const Result<FolderLock> lock = FolderLock::take(given.folder);
    const Status written = lock ? write_file(file, html.value()) : Status(lock.error());
    if (!written) {
        return complain(written.error());
    }
    std::printf("%s\n", file.c_str());
    return done;
}

}  // namespace

void add_report(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("report", "Make report.html again from a run's folder");
    command->footer(report_help);
    auto given = std::make_shared<ReportOptions>();
    command->add_option("run_dir", given->folder, "Folder that rhexis run wrote")->required();
    command
        ->add_option("--score-with", given->score_with,
                     "Judge the recording again, by this exercise (folder, file or name) or rubric")
        ->type_name("EXERCISE|RUBRIC");
    command->add_option("--language", given->language, "Of the page: en, fr, ... [that of the run]");
    command->callback([given, &context] { context.status = report(*given, context); });
}

}  // namespace rhexis::cli
