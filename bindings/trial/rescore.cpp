// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/rescore.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/numbers.hpp"
#include "lua/curriculum_files.hpp"
#include "session/replay.hpp"
#include "trial/operation.hpp"
#include "trial/places.hpp"

namespace rhexis {
namespace {

/// The commands that change what is simulated; a text or a picture does not.
std::vector<Command> effective(std::span<const Command> commands) {
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

/// The exercise that was recorded is judged with the values that its run was given by --set; another knows none of
/// them.
bool same_exercise(const nlohmann::json& identity, const std::string& recorded) {
    const nlohmann::json other = nlohmann::json::parse(recorded, nullptr, false);
    return other.is_object() && other.value("id", nlohmann::json(nullptr)) == identity.value("id", nlohmann::json());
}

/// What was recorded, as long as the exercise sets what it set then; a session from the first step where it does not.
class RecordedTimeline final : public Timeline {
public:
    explicit RecordedTimeline(const Recording& recording) : recording_(recording) {}

    [[nodiscard]] const SceneDescription& scene() const override { return recording_.header.scene; }
    [[nodiscard]] const ObservationSchema& schema() const override { return recording_.header.schema; }
    [[nodiscard]] const Observation& observation() const override {
        if (session_) {
            return session_->observation();
        }
        return step_ == 0 ? recording_.start.observation : recording_.steps[step_ - 1].observation;
    }
    [[nodiscard]] std::uint64_t step_count() const override { return step_; }
    [[nodiscard]] Session* session() override { return session_ ? &*session_ : nullptr; }

    Result<StepOutcome> advance(std::span<const DeviceSample> samples, std::span<const Command> commands) override {
        if (const Status there = simulate_if_different(commands); !there) {
            return there.error();
        }
        ++step_;
        return session_ ? session_->step(samples, commands) : StepOutcome{};
    }

    /// First step that was simulated, from 1; 0: none.
    [[nodiscard]] std::uint64_t simulated() const { return simulated_; }
    /// Why.
    [[nodiscard]] const std::string& difference() const { return difference_; }

private:
    Status simulate_if_different(std::span<const Command> commands) {
        const std::vector<Command> wanted = effective(commands);
        const std::vector<Command> given = effective(recording_.steps[step_].commands);
        if (session_ || same(wanted, given)) {
            return success();
        }
        simulated_ = step_ + 1;
        difference_ = "the exercise now sets " + listed(wanted) + ", recorded was " + listed(given);
        Result<Session> session = session_at(recording_, step_);
        if (!session) {
            return session.error();
        }
        session_.emplace(std::move(session).value());
        return success();
    }

    const Recording& recording_;
    std::optional<Session> session_;
    std::uint64_t step_ = 0;
    std::uint64_t simulated_ = 0;
    std::string difference_;
};

Result<Rescore> judge(const Recording& recording, ExerciseHost& host) {
    RecordedTimeline timeline(recording);
    RecordedHand hand(recording, RecordedHand::Gives::input);
    const Result<TrialOutcome> outcome = Trial(timeline, &host, hand).run();
    if (!outcome) {
        return outcome.error();
    }
    Rescore rescored;
    rescored.identity = host.identity();
    rescored.judged = timeline.step_count();
    rescored.simulated = timeline.simulated();
    rescored.difference = timeline.difference();
    rescored.script_error = outcome.value().error ? outcome.value().error->text() : "";
    const Result<nlohmann::json> result = host.result();
    if (result) {
        rescored.result = result.value();
    } else if (rescored.script_error.empty()) {
        rescored.script_error = result.error().text();
    }
    return rescored;
}

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

Result<Rescore> rescore(const Recording& recording, const ExerciseOptions& given) {
    ExerciseOptions options = given;
    options.accuracy = recording.header.scene.accuracy;  // what new tables would choose is none of its business
    Result<ExerciseHost> host = ExerciseHost::load(options);
    if (!host) {
        return host.error();
    }
    ExerciseOptions as_recorded = options;
    as_recorded.set = recording.header.set;
    // habits of whoever operated then: nobody does now
    std::erase_if(as_recorded.set, [](const auto& entry) { return entry.first.starts_with("surgeon."); });
    if (as_recorded.set.empty() || !same_exercise(host.value().identity(), recording.header.identity)) {
        return judge(recording, host.value());
    }
    Result<ExerciseHost> same_goals = ExerciseHost::load(as_recorded);
    if (!same_goals) {
        return same_goals.error();
    }
    return judge(recording, same_goals.value());
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

}  // namespace rhexis
