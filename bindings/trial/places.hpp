// SPDX-License-Identifier: GPL-3.0-or-later
// Where things lie on disk.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

/// The folder with scripts/ and curricula/: RHEXIS_HOME, or beside the program (in the source tree that it was built
/// in, or share/rhexis of where it is installed). Empty when there is none.
std::string find_root();

/// Makes the folder and its parents and makes sure that files can be written there.
Status prepare_folder(const std::string& folder);

Result<std::string> read_whole_file(const std::string& path);

/// A file that is named by its path, or as NAME of folder/NAME.json. kind: what it is, for the message: "study".
Result<std::string> find_json_file(const std::string& kind, const std::string& name, const std::string& folder);

/// The JSON object in a file that rhexis run wrote.
Result<nlohmann::json> read_json_file(const std::string& path);

/// "DIR/recording.rhx" for a run's folder (or its .part when the run was cut short), else the path itself.
std::string recording_path(const std::string& given);

/// The folders of the parts of an operation's run, in order; none: it is not one.
std::vector<std::string> part_folders(const std::string& run);

/// Fails for a run that was killed: it has a recording, and no report.
Status came_to_its_report(const std::string& run);

/// The recording of a run, or those of its parts in order.
std::vector<std::string> recordings_of(const std::string& run);

/// SHA-256 of a recording; of several, of theirs one after the other.
Result<std::string> sha256_of_recordings(const std::vector<std::string>& recordings);

}  // namespace rhexis
