// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/scenario_run.hpp"

#include <filesystem>

#include "base/clock.hpp"
#include "session/prepared_state.hpp"
#include "session/settings.hpp"
#include "session/trial.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

json schema_json(const ObservationSchema& schema) {
    json list = json::array();
    for (const MeasureInfo& info : schema) {
        list.push_back({{"name", info.name}, {"unit", info.unit}});
    }
    return list;
}

json settings_json() {
    json settings = json::object();
    for (const SettingInfo& info : setting_table()) {
        settings[std::string(info.name)] = {{"minimum", info.minimum}, {"maximum", info.maximum}, {"live", info.live}};
    }
    return settings;
}

json landmarks_json(const Session& session) {
    json marks = json::object();
    for (const Landmark& mark : session.percept().landmarks) {
        if (mark.visible) {
            marks[mark.name] = {{"position", {mark.position.x(), mark.position.y(), mark.position.z()}}};
        }
    }
    return marks;
}

/// The values of a scenario belong to its line, not to a command line.
Error at_scenario(const ScenarioFile& file, const json& scenario, const Error& error) {
    const std::string what = error.where.empty() ? error.what : error.where + ": " + error.what;
    return {"scenario '" + scenario.at("name").get<std::string>() + "': " + what,
            file.path + ":" + std::to_string(scenario.at("line").get<int>()), error.allowed};
}

ExerciseOptions options_of(const ScenarioFile& file, const json& scenario, const std::string& root) {
    return {file.curriculum, "none", scenario.at("seed").get<std::uint64_t>(), settings_of(scenario), root};
}

/// The hand that a scenario leads. It sees what a test may know: measures and events.
class ScenarioHand final : public Operator {
public:
    /// which: "number" or "start" and its value.
    ScenarioHand(ExerciseHost& host, ScenarioScript& script, const char* which, json value)
        : host_(host), script_(script), which_(which), value_(std::move(value)) {}

    Status begin(Timeline& timeline) override {
        const Result<json> declared = host_.declared_events();
        const Result<json> requests = host_.declared_requests();
        if (!declared || !requests) {
            return declared ? requests.error() : declared.error();
        }
        declared_ = declared.value();
        return script_.start({{which_, value_},
                              {"schema", schema_json(timeline.schema())},
                              {"goals", host_.goals()},
                              {"events", declared_},
                              {"requests", requests.value()},
                              {"settings", settings_json()},
                              {"instruments", timeline.scene().instruments},
                              {"landmarks", landmarks_json(*timeline.session())},
                              {"step_s", timeline.scene().step_s}});
    }

    Result<OperatorStep> operate(Timeline& timeline) override {
        const Result<json> events = host_.events();
        return events ? script_.step(timeline.observation(), events.value()) : events.error();
    }

    /// What the kernel did not take fails the scenario.
    Status stepped(const Session& session, const StepOutcome& outcome) override {
        if (outcome.failure != StepFailure::none) {
            return script_.refused("the step could not be solved; nothing moved in it");
        }
        for (; logged_ < session.log().size(); ++logged_) {
            const std::string& text = session.log()[logged_].text;
            if (text.starts_with("sample refused") || text.starts_with("command refused")) {
                if (Status said = script_.refused(text); !said) {
                    return said;
                }
            }
        }
        return success();
    }

    [[nodiscard]] const json& declared() const { return declared_; }

private:
    ExerciseHost& host_;
    ScenarioScript& script_;
    const char* which_;
    json value_;
    json declared_;
    std::size_t logged_ = 0;
};

class Play {
public:
    Play(ExerciseHost host, Session session, ScenarioScript script, const char* which, json value)
        : host_(std::move(host)),
          session_(std::move(session)),
          script_(std::move(script)),
          hand_(host_, script_, which, std::move(value)) {}

    /// To its last line, whatever the exercise says.
    Status run() {
        LiveTimeline timeline(session_);
        return status_of(Trial(timeline, &host_, hand_, {}, {.beyond_the_exercise = true}).run());
    }

    /// What the exercise made of the scenario is part of what is expected of it.
    Status judge() {
        const Result<json> result = host_.result();
        return result ? script_.judged(result.value()) : Status(result.error());
    }

    void fill(ScenarioResult& result, const ScenarioFile& file, const Status& status) {
        result.declared = hand_.declared();
        result.simulated_s = session_.time_s();
        const Result<json> findings = host_.result();
        result.findings = findings ? findings.value() : json();
        const Result<json> outcome = script_.outcome();
        if (!status || !outcome) {
            const Error& error = status ? outcome.error() : status.error();
            // what failed outside the file failed for a line in it
            const bool outside = outcome && !error.where.starts_with(file.chunk + ":");
            const std::string at = outside ? place_in_file(file, outcome.value().at("at")) + ": " : "";
            result.error = at + Error{error.what, place_in_file(file, error.where), error.allowed}.text();
        }
        if (!outcome) {
            return;
        }
        result.covered = outcome.value().at("covered");
        for (const json& failure : outcome.value().at("failures")) {
            char time[48];
            std::snprintf(time, sizeof time, " (after %.2f s)", failure.at("time_s").get<double>());
            result.failures.push_back(
                {place_in_file(file, failure.at("where")), failure.at("message").get<std::string>() + time});
        }
    }

    /// The first failure, as an error.
    Status first_failure() {
        const Result<json> outcome = script_.outcome();
        if (!outcome || outcome.value().at("failures").empty()) {
            return outcome ? success() : Status(outcome.error());
        }
        const json& first = outcome.value().at("failures").front();
        return Error{first.at("message"), first.at("where"), ""};
    }

    [[nodiscard]] Session take_session() { return std::move(session_); }

private:
    ExerciseHost host_;
    Session session_;
    ScenarioScript script_;
    ScenarioHand hand_;
};

}  // namespace

StartRequest start_of(const ScenarioFile& file, const json& scenario, const std::string& root) {
    std::string start = scenario.value("start", "");
    const std::filesystem::path beside = std::filesystem::path(file.path).parent_path() / start;
    std::error_code ignored;
    if (!start.empty() && std::filesystem::is_regular_file(beside, ignored)) {
        start = std::filesystem::absolute(beside).string();
    }
    return {file.curriculum, start, settings_of(scenario), root, false};
}

Result<Session> play_start(ExerciseHost host, Session session, ScenarioScript script, const std::string& start) {
    Play play(std::move(host), std::move(session), std::move(script), "start", start);
    Status status = play.run();
    status = status ? play.first_failure() : status;
    if (!status) {
        return status.error();
    }
    return play.take_session();
}

std::map<std::string, std::string> settings_of(const json& scenario) {
    return scenario.at("set").get<std::map<std::string, std::string>>();
}

Status check_scenario(const ScenarioFile& file, const json& scenario, const std::string& root) {
    const Result<ExerciseHost> host = ExerciseHost::load(options_of(file, scenario, root));
    if (!host) {
        return at_scenario(file, scenario, host.error());
    }
    const Status start = check_start(start_of(file, scenario, root));
    return start ? success() : Status(at_scenario(file, scenario, start.error()));
}

ScenarioResult run_scenario(const ScenarioFile& file, std::size_t number, const Start& start, const std::string& root) {
    const json& scenario = file.scenarios.at(number);
    const double cpu_start = thread_cpu_seconds();
    ScenarioResult result;
    const auto failed = [&](const Error& error) {
        result.error = at_scenario(file, scenario, error).text();
        return result;
    };
    Result<ExerciseHost> host = ExerciseHost::load(options_of(file, scenario, root));
    if (!host) {
        return failed(host.error());
    }
    SceneDescription scene = host.value().scene();
    scene.opening = start.opening;
    Result<Session> session = create_session(scene, scenario.at("seed"), start.state);
    if (!session) {
        return failed(session.error());
    }
    Result<ScenarioScript> script = ScenarioScript::load(file.path, "scenarios", root);
    if (!script) {
        return failed(script.error());
    }
    Play play(std::move(host).value(), std::move(session).value(), std::move(script).value(), "number", number + 1);
    Status status = play.run();
    status = status ? play.judge() : status;
    play.fill(result, file, status);
    result.cpu_s = thread_cpu_seconds() - cpu_start;
    return result;
}

}  // namespace rhexis
