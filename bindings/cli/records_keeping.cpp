// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis records add, delete, export.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "base/folder_lock.hpp"
#include "base/output_file.hpp"
#include "cli/counted.hpp"
#include "cli/records_command.hpp"
#include "cli/run_folder.hpp"
#include "records/csv.hpp"
#include "records/identity.hpp"
#include "records/pseudonym.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

using records::Attempt;

/// A run that has a trainee keeps the group that it was made in; another that is named now would be lost.
Status same_group(const Attempt& attempt, const std::string& folder, const RecordsOptions& given) {
    for (const auto& [option, named, noted] : {std::tuple("--cohort", given.cohort, attempt.trainee.cohort),
                                               std::tuple("--arm", given.arm, attempt.trainee.arm)}) {
        if (!named.empty() && named != noted) {
            return Error{std::string(option) + " " + named + ": the run was made with " +
                             (noted.empty() ? "none" : option + (" " + noted)),
                         folder, std::string("without ") + option};
        }
    }
    return success();
}

/// The attempt that a folder tells of: by its note, or of a run without one, by the trainee that is named now.
Result<Attempt> attempt_in(const std::string& folder, const RecordsOptions& given) {
    Result<Attempt> attempt = read_note(folder);
    if (attempt && !given.trainee.empty() && attempt.value().trainee.pseudonym != given.trainee) {
        return Error{"the run is of another trainee, " + attempt.value().trainee.pseudonym, folder,
                     "without --trainee"};
    }
    if (const Status same = attempt ? same_group(attempt.value(), folder, given) : success(); !same) {
        return same.error();
    }
    std::error_code ignored;
    if (!attempt && std::filesystem::exists(folder + "/" + note_file, ignored)) {
        return attempt.error();
    }
    if (!attempt) {
        if (!std::filesystem::exists(folder + "/report.json", ignored)) {
            return Error{"no run that came to its report lies here", folder, "a folder that rhexis run wrote"};
        }
        if (given.trainee.empty()) {
            return Error{"the run was of no trainee", folder, "--trainee PSEUDONYM says of whom it is"};
        }
        Attempt made;
        made.id = records::new_id();
        made.trainee = {given.trainee, given.cohort, given.arm};
        made.begun = records::now_utc();
        made.folder = std::filesystem::absolute(folder).lexically_normal().string();
        attempt = made;
    }
    const Status completed = complete_from_folder(attempt.value());
    return completed ? attempt : completed.error();
}

int add(const RecordsOptions& given) {
    for (const auto& [option, name] :
         {std::pair("--trainee", given.trainee), std::pair("--cohort", given.cohort), std::pair("--arm", given.arm)}) {
        const Status status = name.empty() ? success() : records::check_pseudonym(name, option);
        if (!status) {
            return complain(status.error());
        }
    }
    Result<records::Store> store = records::Store::open(given.store.empty() ? records::default_store() : given.store);
    if (!store) {
        return complain(store.error());
    }
    for (const std::string& folder : given.folders) {
        const Result<Attempt> attempt = attempt_in(folder, given);
        if (!attempt) {
            return complain(attempt.error());
        }
        Status status = store.value().finish(attempt.value());
        if (status && !read_note(folder)) {
            status = write_note(folder, attempt.value(), true);
        }
        if (!status) {
            return complain(status.error());
        }
        std::printf("%s: stored as %s of %s\n", folder.c_str(), attempt.value().id.substr(0, 8).c_str(),
                    attempt.value().trainee.pseudonym.c_str());
    }
    return done;
}

int remove(const RecordsOptions& given) {
    Result<records::Store> store = open_records(given);
    if (!store) {
        return complain(store.error());
    }
    const Result<std::vector<Attempt>> attempts = store.value().attempts(wanted_by(given));
    const Result<std::vector<records::Rating>> ratings = store.value().ratings();
    if (!attempts || !ratings) {
        return complain(attempts ? ratings.error() : attempts.error());
    }
    std::size_t rated = 0;
    for (const records::Rating& rating : ratings.value()) {
        rated += rating.rater == given.trainee ? 1 : 0;
    }
    if (attempts.value().empty() && rated == 0) {
        return complain({"nothing is stored of " + given.trainee, store.value().path(),
                         "rhexis records trainees lists who is there"});
    }
    const std::string what = counted(attempts.value().size(), "attempt") + " with all ratings, and " +
                             counted(rated, "rating") + " by " + given.trainee;
    if (!given.yes) {
        return complain({"this would delete " + what + "; nothing was deleted", store.value().path(), "--yes"});
    }
    const Result<std::vector<std::string>> folders = store.value().remove(given.trainee);
    if (!folders) {
        return complain(folders.error());
    }
    std::printf("deleted: %s\n", what.c_str());
    std::error_code ignored;
    for (const std::string& folder : folders.value()) {
        const bool gone = given.runs && delete_run(folder, given.trainee);
        if (gone || std::filesystem::exists(folder, ignored)) {
            std::printf("  %s  %s\n", gone ? "deleted" : "still there", folder.c_str());
        }
    }
    return done;
}

records::CsvStyle style_named(const std::string& name) {
    return name == "excel-eu" ? records::CsvStyle{';', ',', true} : records::CsvStyle{};
}

int export_csv(const RecordsOptions& given) {
    Result<records::Store> store = open_records(given);
    if (!store) {
        return complain(store.error());
    }
    records::Wanted wanted = wanted_by(given);
    wanted.details = true;
    const Result<std::vector<Attempt>> attempts = store.value().attempts(wanted);
    Result<std::vector<records::Rating>> ratings = store.value().ratings();
    if (!attempts || !ratings) {
        return complain(attempts ? ratings.error() : attempts.error());
    }
    std::erase_if(ratings.value(), [&](const records::Rating& rating) {
        return std::none_of(attempts.value().begin(), attempts.value().end(),
                            [&](const Attempt& attempt) { return attempt.id == rating.attempt; });
    });
    if (const Status known = check_wanted(store.value(), given, attempts.value()); !known) {
        return complain(known.error());  // tables that lie there already stay
    }
    const Result<FolderLock> lock = FolderLock::take(given.out);
    Status status = lock ? prepare_folder(given.out) : Status(lock.error());
    for (const auto& [file, content] :
         records::csv_of(attempts.value(), ratings.value(), style_named(given.csv_style))) {
        status = status ? write_file(given.out + "/" + file, content) : status;
    }
    if (!status) {
        return complain(status.error());
    }
    std::printf("%s in %s/\n", counted(attempts.value().size(), "attempt").c_str(), given.out.c_str());
    return done;
}

}  // namespace

void add_records_keeping(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context) {
    CLI::App* command = records.add_subcommand("add", "Store runs by their folders: what could not be stored before");
    command->add_option("run_dir", given->folders, "Folders that rhexis run wrote")->required();
    CLI::Option* trainee =
        command->add_option("--trainee", given->trainee, "Whose the runs are, if they were made without --trainee");
    command->add_option("--cohort", given->cohort, "Of that trainee; 'reference' for those to compare others with")
        ->needs(trainee);
    command->add_option("--arm", given->arm, "Of that trainee, in a trial")->needs(trainee);
    command->callback([given, &context] { context.status = add(*given); });

    command = records.add_subcommand("export", "Tables for other programs: attempts.csv, items.csv, measures.csv, ...");
    command->add_option("--out", given->out, "Folder for them")->required();
    command
        ->add_option("--csv-style", given->csv_style,
                     "plain: comma and decimal point; excel-eu: as a European Excel opens it, semicolon, decimal comma "
                     "and a byte order mark [plain]")
        ->check(CLI::IsMember({"plain", "excel-eu"}));
    command->add_option("--trainee", given->trainee, "Of this one only");
    command->add_option("--exercise", given->exercise, "At this one only");
    command->add_option("--cohort", given->cohort, "Of this cohort only");
    command->callback([given, &context] { context.status = export_csv(*given); });

    command = records.add_subcommand("delete", "Delete all that is stored of one trainee or rater");
    command->add_option("trainee", given->trainee, "Pseudonym")->required();
    command->add_flag("--yes", given->yes, "Yes: without it nothing is deleted");
    command->add_flag("--runs", given->runs, "Also what rhexis wrote into the folders of the runs");
    command->callback([given, &context] { context.status = remove(*given); });
}

}  // namespace rhexis::cli
