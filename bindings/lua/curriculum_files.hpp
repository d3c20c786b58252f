// SPDX-License-Identifier: GPL-3.0-or-later
// Where a curriculum's scripts lie, and the hash that names their content.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

struct CurriculumFiles {
    std::string id;      ///< name of the folder, or of the file without its ending
    std::string folder;  ///< searched by `require`, and for the plan of the virtual surgeon
    std::string script;  ///< path of the curriculum itself
    std::string chunk;   ///< its name in messages: "groove/curriculum.lua"
    std::string
        sha256;  ///< over names and contents of all .lua files of the folder but its tests (of a lone file: its)
};

/// name: a folder with a curriculum.lua, a .lua file, or the bare name of a folder in root/curricula. Fails with near
/// names when there is none.
Result<CurriculumFiles> find_curriculum(const std::string& name, const std::string& root);

/// Of what find_curriculum finds; "" when it fails.
std::string hash_of_curriculum(const std::string& name, const std::string& root);

/// Likewise without translations (curriculum.fr.lua): what decides how an attempt goes and what it scores.
std::string hash_of_what_decides(const std::string& name, const std::string& root);

/// SHA-256 over names and contents of all .lua files below a folder, tests left out.
Result<std::string> hash_of_scripts(const std::string& folder);

/// Whether a file holds scenario tests, by its name: tests/NAME.lua or NAME_test.lua.
bool is_scenario_file(const std::string& path);

/// The names of the folders in root/curricula, sorted.
std::vector<std::string> curricula_in(const std::string& root);

/// Content of a file; fails when it cannot be read or is larger than 4 MiB.
Result<std::string> read_script(const std::string& path);

}  // namespace rhexis
