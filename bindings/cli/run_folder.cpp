// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_folder.hpp"

#include <filesystem>

#include "base/output_file.hpp"
#include "records/identity.hpp"
#include "records/report_fields.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using records::Attempt;

}  // namespace

Status write_note(const std::string& folder, const Attempt& attempt, bool added) {
    json note = records::note_of(attempt);
    if (added) {
        note["added"] = true;
    }
    return write_file(folder + "/" + note_file, note.dump(2) + "\n");
}

Result<Attempt> read_note(const std::string& folder) {
    const std::string path = folder + "/" + note_file;
    const Result<json> note = read_json_file(path);
    if (!note) {
        return note.error();
    }
    Result<Attempt> attempt = records::attempt_from_note(note.value(), path);
    if (attempt) {
        attempt.value().folder = fs::absolute(folder).lexically_normal().string();
    }
    return attempt;
}

Status complete(Attempt& attempt, const json& report) {
    Status taken = records::take_report(report, attempt);
    if (!taken) {
        return taken;
    }
    attempt.ended = records::now_utc();
    attempt.recording_sha256.clear();
    std::vector<std::string> recordings = recordings_of(attempt.folder);
    std::erase_if(recordings, [](const std::string& recording) { return !fs::exists(recording); });
    if (!recordings.empty()) {
        const Result<std::string> sha256 = sha256_of_recordings(recordings);
        if (!sha256) {
            return sha256.error();
        }
        attempt.recording_sha256 = sha256.value();
    }
    attempt.state = records::AttemptState::finished;
    return success();
}

Status complete_from_folder(Attempt& attempt) {
    const std::string& folder = attempt.folder;
    if (Status whole = came_to_its_report(folder); !whole) {
        return whole;
    }
    const Result<json> report = read_json_file(folder + "/report.json");
    if (!report) {
        return report.error();
    }
    const Result<json> note = read_json_file(folder + "/" + note_file);
    if (note && !note.value().value("added", false) && report.value().value("attempt", json()) != attempt.id) {
        return Error{"the report in this folder is of another attempt", folder, ""};
    }
    return complete(attempt, report.value());
}

bool delete_run(const std::string& folder, const std::string& trainee) {
    const Result<Attempt> note = read_note(folder);
    if (!note || note.value().trainee.pseudonym != trainee) {
        return false;
    }
    std::error_code ignored;
    for (const char* file : {"report.html", "report.json", "series.json", "video.mp4", "recording.rhx",
                             "recording.rhx.part", "frames", "parts", note_file}) {
        fs::remove_all(fs::path(folder) / file, ignored);
    }
    fs::remove(folder, ignored);  // stays where something else is in it
    return true;
}

}  // namespace rhexis::cli
