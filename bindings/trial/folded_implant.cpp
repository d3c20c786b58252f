// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/folded_implant.hpp"

#include <nlohmann/json.hpp>

#include "base/hash.hpp"
#include "base/index.hpp"
#include "base/program.hpp"
#include "session/build_world.hpp"
#include "session/folded_start.hpp"
#include "session/implant_fold.hpp"
#include "trial/kept_states.hpp"
#include "trial/places.hpp"
#include "trial/progress.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

/// What the folded implant depends on, of the scene.
std::map<std::string, double> settings_of_fold(const SceneDescription& scene) {
    std::map<std::string, double> settings = all_settings(scene);
    std::erase_if(settings, [](const auto& entry) { return !shapes_folded_implant(entry.first); });
    return settings;
}

bool still_good(const std::string& path, const std::string& fingerprint) {
    const Result<PreparedState> kept = read_state(path);
    if (!kept || !is_folded_implant(kept.value())) {
        return false;
    }
    const json identity = json::parse(kept.value().made.identity, nullptr, false);
    return identity.is_object() && identity.value("/start/fingerprint"_json_pointer, "") == fingerprint;
}

Result<PreparedState> folded(const std::map<std::string, double>& settings, bool quiet) {
    Result<ImplantFold> fold = ImplantFold::create(folding_scene(settings));
    if (!fold) {
        return fold.error();
    }
    Progress progress("folding the implant", quiet);
    while (!fold.value().done()) {
        const FoldProgress now = fold.value().progress();
        progress.show(now.share, folding_stages()[at(now.stage)].name);
        if (Status status = fold.value().step(); !status) {
            return status.error();
        }
    }
    return fold.value().result();
}

Status make(const std::string& path, const std::map<std::string, double>& settings, const std::string& fingerprint,
            bool quiet) {
    Result<PreparedState> state = folded(settings, quiet);
    if (!state) {
        return state.error();
    }
    const json start = {{"name", "folded"}, {"fingerprint", fingerprint}};
    state.value().made.identity = json({{"start", start}}).dump();
    return write_state(path, state.value());
}

}  // namespace

Result<std::string> hash_of_program() {
    const Result<std::string> program = read_whole_file(program_path());
    if (!program) {
        return program.error();
    }
    StateHash bytes;
    bytes.add_bytes(program.value().data(), program.value().size());
    return hex(bytes.value());
}

Result<std::string> find_folded_implant(const SceneDescription& scene, bool quiet) {
    const Result<std::string> program = hash_of_program();
    if (!program) {
        return program.error();
    }
    const std::map<std::string, double> settings = settings_of_fold(scene);
    const std::string fingerprint = sha256_hex(json({program.value(), build_note(), settings}).dump());
    const Result<std::string> folder = folder_of_states();
    if (!folder) {
        return folder.error();
    }
    const std::string path = folder.value() + "/folded-" + sha256_hex(json(settings).dump()).substr(0, 12) + ".rhxs";
    const Turn turn(path);
    if (!still_good(path, fingerprint)) {
        if (Status made = make(path, settings, fingerprint, quiet); !made) {
            return made.error();
        }
    }
    return path;
}

}  // namespace rhexis
