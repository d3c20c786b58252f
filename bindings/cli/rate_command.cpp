// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis rate: recordings rated by people who do not know whose they are.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/folder_lock.hpp"
#include "base/output_file.hpp"
#include "base/rng.hpp"
#include "cli/command.hpp"
#include "cli/counted.hpp"
#include "cli/language.hpp"
#include "cli/rated_case.hpp"
#include "cli/rating_answers.hpp"
#include "lua/report_script.hpp"
#include "records/identity.hpp"
#include "records/pseudonym.hpp"
#include "records/store.hpp"
#include "trial/film.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* rate_help =
    "Makes a folder to hand to a rater: for each run a replay on video (of an operation, one of each part) and a form\n"
    "with the twenty items of OSACSS, in an order by chance, without name, group, score or date. It names the\n"
    "exercise, and items which that does not judge are set to N/A, for the rater to change. The form works\n"
    "without a network and saves a file of answers. With --answers these are stored beside the attempt, for\n"
    "rhexis records agreement.\n"
    "\n"
    "  rhexis rate runs/groove-P07-20260301-093000\n"
    "  rhexis rate runs/groove-P*/ --out for_rater_1 --seed 1       every rater another order\n"
    "  rhexis rate runs/groove-P*/ --answers rater_1/*.json --rater R1\n"
    "  rhexis records agreement --html agreement.html\n"
    "\n"
    "Answers are stored of attempts that are stored: rhexis run --trainee, or rhexis records add.";

constexpr double pictures_per_second = 15.0;  ///< enough to follow a hand, and drawn in about the time it operated

struct RateOptions {
    std::vector<std::string> recordings;
    std::string out = "rating";
    std::uint64_t seed = 1;
    bool no_video = false;
    std::vector<std::string> answers;
    std::string rater;
    std::string store;
    bool replace = false;
    std::string language;
};

struct Case {
    std::string code;
    std::string run;                      ///< as it was named
    std::vector<std::string> recordings;  ///< of an operation, those of its parts in order
};

/// Each run once, in an order that depends on nothing but the runs and the seed.
Result<std::vector<Case>> cases_of(const RateOptions& given) {
    std::vector<Case> cases;
    for (const std::string& name : given.recordings) {
        std::vector<std::string> recordings = recordings_of(name);
        const Result<std::string> sha256 = sha256_of_recordings(recordings);
        if (!sha256) {
            return sha256.error();
        }
        cases.push_back({code_of(sha256.value()), name, std::move(recordings)});
    }
    const auto by_code = [](const Case& a, const Case& b) { return a.code < b.code; };
    const auto same_code = [](const Case& a, const Case& b) { return a.code == b.code; };
    std::sort(cases.begin(), cases.end(), by_code);
    cases.erase(std::unique(cases.begin(), cases.end(), same_code), cases.end());
    Rng chance(given.seed, "order of cases");
    for (std::size_t i = cases.size(); i > 1; --i) {
        std::swap(cases[i - 1], cases[static_cast<std::size_t>(chance.integer(0, static_cast<std::int64_t>(i) - 1))]);
    }
    return cases;
}

Status film(const Recording& recording, const std::string& folder, const std::string& label) {
    Result<PictureBook> book = PictureBook::create(folder, true, pictures_per_second);
    if (!book) {
        return Error{book.error().text(), "", "--no-video makes the form without a replay"};
    }
    Status filmed = film_recording(recording, book.value(), false, false, label);
    std::error_code ignored;
    fs::remove(folder + "/frames", ignored);  // it is empty
    return filmed;
}

/// A video in the folder; of an operation, one for each part, in a folder of its own. Adds their places to `videos`.
/// Without videos the recordings are only looked at, whether they are any.
Status film_case(const Case& one, bool no_video, const std::string& folder, const std::string& label,
                 nlohmann::json& videos) {
    for (std::size_t i = 0; i < one.recordings.size(); ++i) {
        const Result<Recording> recording = read_recording(one.recordings[i]);
        if (!recording) {
            return recording.error();
        }
        if (no_video) {
            continue;
        }
        const std::string own = one.recordings.size() > 1 ? "part_" + std::to_string(i + 1) + "/" : "";
        Status status = prepare_folder(folder + "/" + own);
        if (status) {
            status = film(recording.value(), folder + "/" + own, label);
        }
        if (!status) {
            return status;
        }
        videos.push_back(own + "video.mp4");
    }
    return success();
}

Status make_case(const RateOptions& given, const Case& one, std::size_t number, std::size_t of,
                 const Context& context) {
    const std::string folder = given.out + "/case_" + (number < 10 ? "0" : "") + std::to_string(number);
    Status status = prepare_folder(folder);
    nlohmann::json data = case_of_run(one.run, given.language, context.root);
    data.update({{"case", one.code},
                 {"number", number},
                 {"of", of},
                 {"parts", one.recordings.size()},
                 {"language", given.language}});
    nlohmann::json videos = nlohmann::json::array();
    if (status) {
        status = film_case(one, given.no_video, folder, std::to_string(number) + " of " + std::to_string(of), videos);
    }
    data["videos"] = std::move(videos);
    if (!status) {
        return status;
    }
    const Result<std::string> html = page_html(context.root, "records.form", data);
    status = html ? write_file(folder + "/form.html", html.value()) : Status(html.error());
    if (status) {
        std::printf("%zu of %zu  %s/form.html\n", number, of, folder.c_str());
        std::fflush(stdout);
    }
    return status;
}

int make_package(RateOptions given, const Context& context) {
    const Result<std::string> language = language_of_page(given.language, context.root);
    if (!language) {
        return complain(language.error());
    }
    given.language = language.value().empty() ? "en" : language.value();
    const Result<std::vector<Case>> cases = cases_of(given);
    if (!cases) {
        return complain(cases.error());
    }
    std::error_code ignored;
    if (fs::exists(given.out, ignored) && !fs::is_empty(given.out, ignored)) {
        return complain({"this folder is not empty", given.out, "--out DIR, a new folder for each rater"});
    }
    const Result<FolderLock> lock = FolderLock::take(given.out);
    if (!lock) {
        return complain(lock.error());
    }
    for (std::size_t i = 0; i < cases.value().size(); ++i) {
        const Status made = make_case(given, cases.value()[i], i + 1, cases.value().size(), context);
        if (!made) {
            return complain(made.error());
        }
    }
    std::printf("%s to rate: hand the folder %s to the rater\n", counted(cases.value().size(), "case").c_str(),
                given.out.c_str());
    return done;
}

/// The attempt whose recording goes by this code, if that is among those that were named.
Result<std::string> attempt_with(const std::string& code, const std::vector<Case>& cases,
                                 const std::vector<records::Attempt>& attempts, const std::string& file) {
    const auto named = std::find_if(cases.begin(), cases.end(), [&](const Case& one) { return one.code == code; });
    if (named == cases.end()) {
        return Error{"these are answers about another recording", file, "those of its form"};
    }
    for (const records::Attempt& attempt : attempts) {
        if (code_of(attempt.recording_sha256) == code) {
            return attempt.id;
        }
    }
    return Error{"no stored attempt has this recording", named->run,
                 "rhexis records add RUN_DIR --trainee PSEUDONYM stores it"};
}

Result<std::vector<records::Rating>> read_ratings(const RateOptions& given, records::Store& store) {
    const Result<std::vector<Case>> cases = cases_of(given);
    records::Wanted finished;
    finished.finished = true;
    const Result<std::vector<records::Attempt>> attempts = store.attempts(finished);
    if (!cases || !attempts) {
        return cases ? attempts.error() : cases.error();
    }
    std::vector<records::Rating> ratings;
    for (const std::string& file : given.answers) {
        Result<Answers> answers = read_answers(file);
        if (!answers) {
            return answers.error();
        }
        const Result<std::string> attempt = attempt_with(answers.value().code, cases.value(), attempts.value(), file);
        if (!attempt) {
            return attempt.error();
        }
        records::Rating& rating = ratings.emplace_back(std::move(answers.value().rating));
        rating.attempt = attempt.value();
        rating.rater = given.rater;
        rating.rated = records::now_utc();
    }
    return ratings;
}

int store_answers(const RateOptions& given) {
    if (const Status status = records::check_pseudonym(given.rater, "--rater"); !status) {
        return complain(status.error());
    }
    Result<records::Store> store =
        records::Store::open_existing(given.store.empty() ? records::default_store() : given.store);
    if (!store) {
        return complain(store.error());
    }
    const Result<std::vector<records::Rating>> ratings = read_ratings(given, store.value());
    const Status stored = ratings ? store.value().rate(ratings.value(), given.replace) : Status(ratings.error());
    if (!stored) {
        return complain(stored.error());
    }
    std::printf("%s by %s stored\n", counted(ratings.value().size(), "rating").c_str(), given.rater.c_str());
    return done;
}

}  // namespace

void add_rate(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("rate", "Have recordings rated by people who do not know whose they are");
    command->footer(rate_help);
    auto given = std::make_shared<RateOptions>();
    command->add_option("recordings", given->recordings, "Recordings, or folders of runs")->required();
    CLI::Option* answers = command->add_option("--answers", given->answers, "Files that the forms saved: store them");
    // Of making forms; beside --answers they would do nothing.
    command->add_option("--out", given->out, "New folder for the rater")->capture_default_str()->excludes(answers);
    command->add_option("--seed", given->seed, "Of the order")->capture_default_str()->excludes(answers);
    command->add_option("--language", given->language, language_help)->excludes(answers);
    command->add_flag("--no-video", given->no_video, "Forms only, without replays")->excludes(answers);
    CLI::Option* rater = command->add_option("--rater", given->rater, "Pseudonym of who rated")->needs(answers);
    answers->needs(rater);
    command->add_flag("--replace", given->replace, "In the place of what this rater said before")->needs(answers);
    command->add_option("--records", given->store, "Record store [RHEXIS_RECORDS, or the user's own]")->needs(answers);
    command->callback([given, &context] {
        context.status = given->answers.empty() ? make_package(*given, context) : store_answers(*given);
    });
}

}  // namespace rhexis::cli
