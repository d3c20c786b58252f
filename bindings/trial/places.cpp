// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/places.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/hash.hpp"
#include "base/near_names.hpp"
#include "base/output_file.hpp"
#include "base/program.hpp"

namespace rhexis {
namespace {

namespace fs = std::filesystem;

bool is_root(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(folder / "scripts" / "exercise.lua", ignored);
}

}  // namespace

std::string find_root() {
    const char* home = std::getenv("RHEXIS_HOME");
    if (home != nullptr && *home != '\0') {
        return home;
    }
    std::error_code failed;
    fs::path folder = fs::canonical(program_path(), failed).parent_path();
    for (int level = 0; level < 6 && !failed && !folder.empty(); ++level) {
        for (const fs::path& candidate : {folder / "share" / "rhexis", folder}) {
            if (is_root(candidate)) {
                return candidate.string();
            }
        }
        folder = folder.parent_path();
    }
    return {};
}

Status prepare_folder(const std::string& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) {
        return Error{"cannot make this folder: " + failed.message(), folder, "a folder that can be written"};
    }
    const std::string probe = folder + "/.rhexis-probe";
    const Status status = write_file(probe, "probe\n");
    ::unlink(probe.c_str());
    if (!status) {
        return Error{status.error().what, folder, "a folder that can be written, on a disk that is not full"};
    }
    return success();
}

Result<std::string> read_whole_file(const std::string& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
        return Error{"this is a folder", path, "a file"};
    }
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream content;
    if (!stream || (!(content << stream.rdbuf()) && stream.bad())) {
        return Error{std::string("cannot read: ") + std::strerror(errno), path, ""};
    }
    return std::move(content).str();
}

namespace {

std::vector<std::string> json_files_in(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        if (at->path().extension() == ".json") {
            names.push_back(at->path().stem().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

Result<std::string> find_json_file(const std::string& kind, const std::string& name, const std::string& folder) {
    std::error_code ignored;
    for (const std::string& path : {name, folder + "/" + name + ".json"}) {
        if (fs::is_regular_file(path, ignored)) {
            return path;
        }
    }
    return Error{"there is no " + kind + " '" + name + "'", "", suggestion(name, json_files_in(folder))};
}

Result<nlohmann::json> read_json_file(const std::string& path) {
    const Result<std::string> text = read_whole_file(path);
    if (!text) {
        return text.error();
    }
    nlohmann::json value = nlohmann::json::parse(text.value(), nullptr, false);
    if (!value.is_object()) {
        return Error{"this is no JSON object", path, "a file written by rhexis run"};
    }
    return value;
}

std::string recording_path(const std::string& given) {
    std::error_code ignored;
    if (!fs::is_directory(given, ignored)) {
        return given;
    }
    const fs::path whole = fs::path(given) / "recording.rhx";
    const fs::path part = fs::path(given) / "recording.rhx.part";
    return !fs::exists(whole, ignored) && fs::exists(part, ignored) ? part.string() : whole.string();
}

std::vector<std::string> part_folders(const std::string& run) {
    std::vector<std::string> parts;
    std::error_code failed;
    for (fs::directory_iterator at(run + "/parts", failed), end; !failed && at != end; at.increment(failed)) {
        parts.push_back(at->path().string());
    }
    std::sort(parts.begin(), parts.end());
    return parts;
}

Status came_to_its_report(const std::string& run) {
    std::error_code ignored;
    if (fs::exists(run + "/report.json", ignored) || !fs::exists(run + "/recording.rhx.part", ignored)) {
        return success();
    }
    return Error{"this run was cut short before it came to its report", run,
                 "rhexis replay " + run + " --score-with EXERCISE judges what was recorded"};
}

std::vector<std::string> recordings_of(const std::string& run) {
    std::vector<std::string> recordings;
    for (const std::string& part : part_folders(run)) {
        recordings.push_back(recording_path(part));
    }
    return recordings.empty() ? std::vector{recording_path(run)} : recordings;
}

Result<std::string> sha256_of_recordings(const std::vector<std::string>& recordings) {
    std::string all;
    for (const std::string& recording : recordings) {
        const Result<std::string> bytes = read_whole_file(recording);
        if (!bytes) {
            return bytes.error();
        }
        all += sha256_hex(bytes.value());
    }
    return recordings.size() == 1 ? all : sha256_hex(all);
}

}  // namespace rhexis
