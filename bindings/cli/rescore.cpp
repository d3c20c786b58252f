// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/rescore.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/numbers.hpp"
#include "cli/operation.hpp"
#include "cli/places.hpp"
#include "lua/curriculum_files.hpp"
#include "session/replay.hpp"

namespace rhexis::cli {
namespace {

/// The commands that change what is simulated; a text or a picture does not.
std::vector<Command> effective(const std::vector<Command>& commands) {
    std::vector<Command> kept;
    std::copy_if(commands.begin(), commands.end(), std::back_inserter(kept),
                 [](const Command& command) { return command.kind == CommandKind::set; });
    return kept;
}

bool same(const std::vector<Command>& a, const std::vector<Command>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Command& x, const Command& y) { return x.name == y.name && x.value == y.value; });
}

std::string listed(const std::vector<Command>& commands) {
    std::string text;
    for (const Command& command : commands) {
        text += (text.empty() ? "" : ", ") + command.name + " = " + short_number(command.value);
    }
    return text.empty() ? "nothing" : text;
}

bool asks_to_finish(const std::vector<Command>& commands) {
    return std::any_of(commands.begin(), commands.end(),
                       [](const Command& command) { return command.kind == CommandKind::finish; });
}

/// The exercise that was recorded is judged with the values that its run was given by --set; another knows none of
/// them.
bool same_exercise(const nlohmann::json& identity, const std::string& recorded) {
    const nlohmann::json other = nlohmann::json::parse(recorded, nullptr, false);
    return other.is_object() && other.value("id", nlohmann::json(nullptr)) == identity.value("id", nlohmann::json());
}

class Judge {
public:
    Judge(const Recording& recording, ExerciseHost host) : recording_(recording), host_(std::move(host)) {}

    Result<Rescore> judge() {
        rescore_.identity = host_.identity();
        const Status started = host_.start(recording_.header.schema, recording_.header.scene.instruments);
        if (!started) {
            rescore_.script_error = started.error().text();
        }
        std::uint64_t step = 0;
        const Observation* seen = &recording_.start.observation;
        while (rescore_.script_error.empty() && look(*seen, step) && step < recording_.steps.size()) {
            const Status moved = go_on(step);
            if (!moved) {
                return moved.error();
            }
            seen = session_ ? &session_->observation() : &recording_.steps[step].observation;
            ++step;
        }
        return closed();
    }

private:
    /// False when the exercise ends here.
    bool look(const Observation& observation, std::uint64_t step) {
        std::span<const Command> given;
        if (step > 0) {
            given = recording_.steps[step - 1].commands;
        }
        Result<std::vector<Command>> commands = host_.observe(observation, given);
        rescore_.judged = step;
        if (!commands) {
            rescore_.script_error = commands.error().text();
            return false;
        }
        commands_ = std::move(commands).value();
        return !host_.finished() && !asks_to_finish(commands_);
    }

    /// From step to step + 1: recorded, or simulated since the commands differ.
    Status go_on(std::uint64_t step) {
        const RecordedStep& recorded = recording_.steps[step];
        const std::vector<Command> wanted = effective(commands_);
        const std::vector<Command> given = effective(recorded.commands);
        if (!session_ && !same(wanted, given)) {
            rescore_.simulated = step + 1;
            rescore_.difference = "the exercise now sets " + listed(wanted) + ", recorded was " + listed(given);
            Result<Session> session = session_at(recording_, step);
            if (!session) {
                return session.error();
            }
            session_.emplace(std::move(session).value());
        }
        if (session_) {
            session_->step(recorded.samples, commands_);
        }
        return success();
    }

    Result<Rescore> closed() {
        Result<nlohmann::json> result = host_.result();
        if (result) {
            rescore_.result = result.value();
        } else if (rescore_.script_error.empty()) {
            rescore_.script_error = result.error().text();
        }
        return rescore_;
    }

    const Recording& recording_;
    ExerciseHost host_;
    std::optional<Session> session_;
    std::vector<Command> commands_;
    Rescore rescore_;
};

/// The part of an operation that a folder "parts/03_ID" holds.
int index_of(const Operation& operation, const std::string& folder) {
    const std::string name = std::filesystem::path(folder).filename().string();
    for (std::size_t i = 0; i < operation.parts.size(); ++i) {
        if (name.size() > 3 && name.substr(3) == operation.parts[i].id) {
            return static_cast<int>(i) + 1;
        }
    }
    return 0;
}

}  // namespace

ExerciseOptions judge_of(const Recording& recording, const std::string& score_with, const std::string& root) {
    ExerciseOptions options{score_with, "none", recording.header.seed, {}, root};
    options.rubric = find_rubric(score_with, root);
    if (options.rubric.empty()) {
        return options;
    }
    options.curriculum = recording.header.curriculum;
    if (!find_curriculum(options.curriculum, root)) {  // was named by a path from elsewhere
        const nlohmann::json identity = nlohmann::json::parse(recording.header.identity, nullptr, false);
        options.curriculum = identity.is_object() ? identity.value("id", options.curriculum) : options.curriculum;
    }
    return options;
}

Result<Rescore> rescore(const Recording& recording, const ExerciseOptions& options) {
    Result<ExerciseHost> host = ExerciseHost::load(options);
    if (!host) {
        return host.error();
    }
    ExerciseOptions as_recorded = options;
    as_recorded.set = recording.header.set;
    // habits of whoever operated then: nobody does now
    std::erase_if(as_recorded.set, [](const auto& entry) { return entry.first.starts_with("surgeon."); });
    if (as_recorded.set.empty() || !same_exercise(host.value().identity(), recording.header.identity)) {
        return Judge(recording, std::move(host).value()).judge();
    }
    Result<ExerciseHost> same_goals = ExerciseHost::load(as_recorded);
    if (!same_goals) {
        return same_goals.error();
    }
    return Judge(recording, std::move(same_goals).value()).judge();
}

Result<Rescore> rescore_operation(const Operation& operation, const std::string& rubric,
                                  const std::vector<std::string>& parts, const std::string& root) {
    Rescore whole;
    whole.result = nlohmann::json::object();
    for (const std::string& folder : parts) {
        if (!whole.script_error.empty()) {
            break;  // as the operation did
        }
        const Result<Recording> recording = read_recording(recording_path(folder));
        if (!recording) {
            return recording.error();
        }
        const int index = index_of(operation, folder);
        if (index == 0) {
            return Error{"the operation " + operation.name + " has no such part", folder, ""};
        }
        ExerciseOptions options{operation.parts[index - 1].exercise, "none", recording.value().header.seed, {}, root};
        options.rubric = rubric;
        options.part = PartPlace{operation.name, index, whole.result.value("carried", nlohmann::json::object())};
        const Result<Rescore> rescored = rescore(recording.value(), options);
        if (!rescored) {
            return rescored.error();
        }
        if (!rescored.value().script_error.empty()) {
            whole.script_error = folder + ": " + rescored.value().script_error;
        }
        if (rescored.value().result.contains("operation")) {
            whole.result = rescored.value().result["operation"];
        }
    }
    whole.result.erase("carried");
    return whole;
}

}  // namespace rhexis::cli
