// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/accuracy_measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/numbers.hpp"
#include "input/pose_track.hpp"
#include "session/prepared_state.hpp"
#include "session/settings.hpp"
#include "trial/course_errors.hpp"
#include "trial/differing_grip.hpp"
#include "trial/progress.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

constexpr double least_step_s = 0.001;
constexpr const char* lens_mesh = "patient.tetrahedra";
constexpr double most_tetrahedra = 24000.0;

/// Meshes of a scene's models as they are.
std::map<std::string, double> meshes_of(const SceneDescription& scene) {
    std::map<std::string, double> meshes;
    for (const ModelAccuracy& model : scene.accuracy.models) {
        meshes.insert(model.mesh.begin(), model.mesh.end());
    }
    return meshes;
}

/// A place between two samples of an instrument; what is new in the scene is where it is.
DeviceSample between(const DeviceSample& from, const DeviceSample& to, double share) {
    DeviceSample sample = to;
    if (from.present && to.present) {
        sample.pose = between(from.pose, to.pose, share);
        sample.jaw = from.jaw + share * (to.jaw - from.jaw);
    }
    return sample;
}

std::vector<DeviceSample> between(const std::vector<DeviceSample>& from, const std::vector<DeviceSample>& to,
                                  double share) {
    std::vector<DeviceSample> samples;
    for (const DeviceSample& sample : to) {
        const auto before = std::find_if(from.begin(), from.end(), [&sample](const DeviceSample& other) {
            return other.instrument == sample.instrument;
        });
        samples.push_back(before == from.end() ? sample : between(*before, sample, share));
    }
    return samples;
}

json numbers_json(const std::map<std::string, double>& numbers) {
    return numbers.empty() ? json::object() : json(numbers);
}

json result_of(const Recording& recording, const SceneDescription& finer, const std::map<std::string, double>& errors,
               std::size_t compared, const std::optional<json>& differs) {
    json exceeded = json::array();
    for (const ModelAccuracy& model : recording.header.scene.accuracy.models) {
        for (const auto& [quantity, allowed] : model.budget) {
            const auto found = errors.find(quantity);
            if (found != errors.end() && found->second > allowed &&
                std::find(exceeded.begin(), exceeded.end(), quantity) == exceeded.end()) {
                exceeded.push_back(quantity);
            }
        }
    }
    const double step_s = recording.header.scene.step_s;
    return {{"mesh", numbers_json(meshes_of(finer))},
            {"step_s", finer.step_s},
            {"compared_s", static_cast<double>(compared) * step_s},
            {"of_s", static_cast<double>(recording.steps.size()) * step_s},
            {"differs", differs ? *differs : json(nullptr)},
            {"errors", numbers_json(errors)},
            {"exceeded", exceeded}};
}

/// The state that the finer one begins in.
Result<std::string> finer_start(const AttemptOptions& attempt, const SceneDescription& finer) {
    const std::string& chosen = attempt.start.chosen;
    const bool from_nothing = attempt.start.state.empty() && chosen.empty();
    if (from_nothing) {
        return std::string();
    }
    if (chosen.find_first_of("./") != std::string::npos) {
        return Error{"--accuracy measure: the attempt began in a state file, which cannot be made finer", chosen,
                     "a start of the exercise, or its beginning"};
    }
    std::map<std::string, std::string> set = attempt.exercise.set;
    std::erase_if(set, [](const auto& entry) { return entry.first.starts_with("accuracy."); });
    set["step_s"] = short_number(finer.step_s);
    for (const auto& [name, value] : meshes_of(finer)) {
        set[name] = short_number(value);
    }
    const Result<Start> start =
        find_start({attempt.exercise.curriculum, chosen, set, attempt.exercise.root, attempt.quiet, {}, false});
    return start ? Result<std::string>(start.value().state) : start.error();
}

/// One recorded step in as many as it takes: the mean of what they tell, or a failure.
std::optional<std::vector<double>> step_finely(Session& session, const std::vector<DeviceSample>& before,
                                               const RecordedStep& step, int parts) {
    std::vector<double> mean(session.schema().size(), 0.0);
    for (int part = 1; part <= parts; ++part) {
        const std::vector<DeviceSample> samples =
            between(before, step.samples, static_cast<double>(part) / static_cast<double>(parts));
        const std::vector<Command>& commands = part == 1 ? step.commands : std::vector<Command>();
        if (session.step(samples, commands).failure != StepFailure::none) {
            return std::nullopt;
        }
        for (std::size_t i = 0; i < mean.size(); ++i) {
            mean[i] += session.observation().values[i] / parts;
        }
    }
    return mean;
}

}  // namespace

SceneDescription at_twice_the_resolution(const SceneDescription& scene) {
    SceneDescription finer = scene;
    finer.step_s = std::max(least_step_s, 0.5 * scene.step_s);
    finer.accuracy.step_s = finer.step_s;
    for (ModelAccuracy& model : finer.accuracy.models) {
        for (auto& [name, value] : model.mesh) {
            if (name == lens_mesh) {
                value = std::min(most_tetrahedra, 8.0 * value);  // tetrahedra of half the edge
                finer.patient.tetrahedra = static_cast<int>(value);
                continue;
            }
            const SettingInfo* info = find_setting(name);
            value = std::min(info != nullptr ? info->maximum : value, 4.0 * value);  // triangles
            finer.settings[name] = value;
        }
    }
    return finer;
}

Result<json> measure_accuracy(const std::string& path, const AttemptOptions& attempt,
                              const std::map<std::string, double>& told) {
    const Result<Recording> read = read_recording(path);
    if (!read) {
        return read.error();
    }
    const Recording& recording = read.value();
    SceneDescription finer = at_twice_the_resolution(recording.header.scene);
    finer.threads = attempt.threads;
    finer.instruction_set = attempt.instruction_set;
    const Result<std::string> state = finer_start(attempt, finer);
    if (!state) {
        return state.error();
    }
    Result<Session> made = create_session(finer, recording.header.seed, state.value());
    if (!made) {
        return made.error();
    }
    Session& session = made.value();
    const int parts = static_cast<int>(std::lround(recording.header.scene.step_s / finer.step_s));
    Progress progress("at twice the resolution", attempt.quiet);
    CourseErrors courses(session.schema());
    DifferingGrip grips(session.schema(), recording.start.observation.values, session.observation().values);
    std::vector<DeviceSample> before;
    std::size_t compared = 0;
    std::optional<json> differs;
    for (const RecordedStep& step : recording.steps) {
        const std::optional<std::vector<double>> mean = step_finely(session, before, step, parts);
        before = step.samples;
        const double time_s = step.observation.time_s;
        if (!mean) {
            differs = json{{"time_s", time_s}, {"measure", ""}, {"attempt", nullptr}, {"finer", nullptr}};
            break;
        }
        const std::optional<GripDifference> difference =
            grips.look(time_s, step.observation.values, session.observation().values);
        if (difference) {
            differs = json{{"time_s", difference->time_s},
                           {"measure", difference->measure},
                           {"attempt", difference->first},
                           {"finer", difference->second}};
            break;
        }
        if (!grips.in_doubt()) {
            courses.add(time_s, step.observation.values, *mean);
            compared = static_cast<std::size_t>(step.step);
        }
        char note[48];
        std::snprintf(note, sizeof note, "%.1f s compared", time_s);
        progress.show(static_cast<double>(step.step) / static_cast<double>(recording.steps.size()), note);
    }
    std::map<std::string, double> errors = told;
    errors.merge(courses.errors());
    return result_of(recording, finer, errors, compared, differs);
}

}  // namespace rhexis
