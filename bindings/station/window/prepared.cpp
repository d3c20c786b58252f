// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/prepared.hpp"

#include <filesystem>
#include <utility>

#include "lua/exercise_host.hpp"
#include "station/person.hpp"

namespace rhexis::station {
namespace {

nlohmann::json events_header(const StationOptions& options, const Mapping& mapping) {
    nlohmann::json header = options.begun_with;
    header["curriculum"] = options.attempt.exercise.curriculum;
    header["seed"] = options.attempt.exercise.seed;
    header["set"] = options.attempt.exercise.set;
    header["input"] = device_of(options);
    header["mapping"] = mapping.to_json();
    return header;
}

std::string setting_of(const StationOptions& options, const char* name) {
    const auto found = options.attempt.exercise.set.find(name);
    return found == options.attempt.exercise.set.end() ? "" : found->second;
}

/// The one that is named, else a person's own, else the standard one.
std::string mapping_file(const StationOptions& options) {
    const bool left = setting_of(options, "handedness") == "left";
    const std::string own = own_mapping(options.pad, left);
    std::error_code unknown;
    if (options.mapping.empty() && options.by.empty() && !own.empty() && std::filesystem::exists(own, unknown)) {
        return own;
    }
    return options.mapping.empty() ? standard_mapping(options.attempt.exercise.root, options.pad, left)
                                   : options.mapping;
}

Status offer_mappings(const StationOptions& options, Prepared& prepared) {
    for (const auto& [title, left] : {std::pair("Right-handed", false), {"Left-handed", true}}) {
        Result<Mapping> mapping = Mapping::read(standard_mapping(options.attempt.exercise.root, options.pad, left));
        if (!mapping) {
            return mapping.error();
        }
        prepared.offers.push_back({title, std::move(mapping).value()});
    }
    prepared.own = own_mapping(options.pad, setting_of(options, "handedness") == "left");
    return success();
}

Status read_exercise(const StationOptions& options, Prepared& prepared) {
    const Result<ExerciseHost> host = ExerciseHost::load(options.attempt.exercise);
    if (!host) {
        return host.error();
    }
    prepared.title = host.value().identity().value("title", std::string());
    prepared.step_s = host.value().scene().step_s;
    prepared.instruments = host.value().scene().instruments;
    const std::vector<std::string>& instruments = prepared.instruments;
    if (!options.ghost.empty()) {
        Result<Ghost> ghost = Ghost::read(options.ghost, instruments);
        if (!ghost) {
            return ghost.error();
        }
        prepared.ghost.emplace(std::move(ghost).value());
    }
    Result<HoldScript> holds = HoldScript::load(options.attempt.exercise.root);
    if (!holds) {
        return holds.error();
    }
    prepared.holds.emplace(std::move(holds).value());
    Result<Words> words = Words::load(options.attempt.exercise.root, setting_of(options, "language"), instruments);
    if (!words) {
        return words.error();
    }
    prepared.words = std::move(words).value();
    return success();
}

}  // namespace

Result<Prepared> prepare(const StationOptions& options) {
    Prepared prepared;
    prepared.mapping_file = mapping_file(options);
    if (const Status offered = offer_mappings(options, prepared); !offered) {
        return offered.error();
    }
    Result<Mapping> mapping = Mapping::read(prepared.mapping_file);
    if (options.again) {
        Result<EventFile> file = read_events(options.events);
        if (!file) {
            return file.error();
        }
        prepared.file = std::move(file).value();
        mapping = Mapping::from(prepared.file->header.value("mapping", nlohmann::json::object()));
    }
    if (!mapping) {
        return mapping.error();
    }
    prepared.mapping = std::move(mapping).value();
    if (!options.events.empty() && !options.again) {
        Result<EventWriter> writer = EventWriter::create(options.events, events_header(options, prepared.mapping));
        if (!writer) {
            return writer.error();
        }
        prepared.writer.emplace(std::move(writer).value());
    }
    const Status given = read_exercise(options, prepared);
    return given ? Result<Prepared>(std::move(prepared)) : given.error();
}

std::string device_of(const StationOptions& options) {
    return options.tracked ? tracked_device : options.pad ? "gamepad" : "mouse";
}

bool operates(const StationOptions& options) { return !options.again && (options.by.empty() || options.typed); }

bool is_stepped(const StationOptions& options) { return options.again || (!options.by.empty() && !options.live); }

}  // namespace rhexis::station
