// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/curriculum_files.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/hash.hpp"
#include "base/near_names.hpp"
#include "base/text_file.hpp"
#include "lua/lua_state.hpp"

namespace rhexis {
namespace {

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) {
        list += (list.empty() ? "" : ", ") + name;
    }
    return list.empty() ? "none" : list;
}

/// Paths of all scripts below a folder but its tests, relative to it, in a fixed order.
std::vector<std::string> scripts_below(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (fs::recursive_directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        if (at->is_regular_file(failed) && at->path().extension() == ".lua" && !is_scenario_file(at->path().string())) {
            names.push_back(fs::relative(at->path(), folder, failed).generic_string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

Result<std::string> hash_of(const fs::path& folder, const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) {
        Result<std::string> text = read_script((folder / name).string());
        if (!text) {
            return text.error();
        }
        all += name + '\0' + std::to_string(text.value().size()) + '\0' + text.value();
    }
    return sha256_hex(all);
}

Result<CurriculumFiles> with_hash(CurriculumFiles files, const std::vector<std::string>& names) {
    Result<std::string> hash = hash_of(files.folder, names);
    if (!hash) {
        return hash.error();
    }
    files.sha256 = hash.value();
    return files;
}

Result<CurriculumFiles> from_folder(const fs::path& given) {
    const fs::path folder = fs::weakly_canonical(given);
    CurriculumFiles files;
    files.id = folder.filename().string();
    files.folder = folder.string();
    files.script = (folder / "curriculum.lua").string();
    files.chunk = files.id + "/curriculum.lua";
    return with_hash(files, scripts_below(folder));
}

Result<CurriculumFiles> from_file(const fs::path& given) {
    const fs::path path = fs::weakly_canonical(given);
    if (path.filename() == "curriculum.lua") {
        return from_folder(path.parent_path());
    }
    CurriculumFiles files;
    files.id = path.stem().string();
    files.folder = path.parent_path().string();
    files.script = path.string();
    files.chunk = path.filename().string();
    return with_hash(files, {files.chunk});
}

}  // namespace

std::vector<std::string> curricula_in(const std::string& root) {
    std::vector<std::string> names;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(root) / "curricula", failed)) {
        if (fs::is_regular_file(entry.path() / "curriculum.lua", failed)) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

bool is_scenario_file(const std::string& path) {
    const fs::path file(path);
    return file.extension() == ".lua" &&
           (file.parent_path().filename() == "tests" || file.stem().string().ends_with("_test"));
}

std::string hash_of_curriculum(const std::string& name, const std::string& root) {
    const Result<CurriculumFiles> files = find_curriculum(name, root);
    return files ? files.value().sha256 : "";
}

std::string hash_of_what_decides(const std::string& name, const std::string& root) {
    const Result<CurriculumFiles> files = find_curriculum(name, root);
    if (!files || fs::path(files.value().script).filename() != "curriculum.lua") {
        return files ? files.value().sha256 : "";
    }
    std::vector<std::string> names = scripts_below(files.value().folder);
    std::erase_if(names,
                  [](const std::string& file) { return file.starts_with("curriculum.") && file != "curriculum.lua"; });
    const Result<std::string> hash = hash_of(files.value().folder, names);
    return hash ? hash.value() : "";
}

Result<std::string> hash_of_scripts(const std::string& folder) { return hash_of(folder, scripts_below(folder)); }

Result<std::string> read_script(const std::string& path) { return read_text_file(path, lua::largest_script); }

Result<CurriculumFiles> find_curriculum(const std::string& name, const std::string& root) {
    std::error_code failed;
    if (name.empty()) {
        return Error{"no curriculum is named", "curriculum", "a folder, a file, or a name in curricula/"};
    }
    if (fs::is_regular_file(fs::path(name) / "curriculum.lua", failed)) {
        return from_folder(name);
    }
    if (fs::is_regular_file(name, failed)) {
        return from_file(name);
    }
    if (fs::is_directory(name, failed) && name.find('/') != std::string::npos) {
        return Error{"the folder holds no curriculum.lua", name, ""};
    }
    const std::vector<std::string> known = curricula_in(root);
    if (std::find(known.begin(), known.end(), name) != known.end()) {
        return from_folder(fs::path(root) / "curricula" / name);
    }
    if (name.find('/') != std::string::npos) {
        return Error{"there is no such folder or file, and no curriculum.lua in it", name, ""};
    }
    const std::string near = did_you_mean(name, known);
    return Error{"there is no curriculum '" + name + "'" + near, "", near.empty() ? "curricula: " + joined(known) : ""};
}

}  // namespace rhexis
