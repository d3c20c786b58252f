// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/operation.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "base/output_file.hpp"
#include "lua/curriculum_files.hpp"
#include "session/torn_opening.hpp"
#include "trial/html.hpp"
#include "trial/operation_report.hpp"
#include "trial/places.hpp"
#include "trial/starts.hpp"

namespace rhexis {
namespace {

using nlohmann::json;

/// What a part leaves beside its report, for the next one and for resuming.
constexpr const char* left_file = "/operation.json";
constexpr const char* end_state = "/end.rhxs";

std::vector<std::string> ids_of(const Operation& operation) {
    std::vector<std::string> ids;
    for (const OperationPart& part : operation.parts) {
        ids.push_back(part.id);
    }
    return ids;
}

Result<std::size_t> find_part(const Operation& operation, const std::string& id, const char* option) {
    const std::vector<std::string> ids = ids_of(operation);
    const auto found = std::find(ids.begin(), ids.end(), id);
    if (found == ids.end()) {
        return Error{std::string(option) + " " + id + ": the operation has no such part", "", suggestion(id, ids)};
    }
    return static_cast<std::size_t>(found - ids.begin());
}

/// The parts to do: first and last.
Result<std::pair<std::size_t, std::size_t>> range_of(const OperationOptions& options) {
    std::size_t first = 0;
    std::size_t last = options.operation.parts.size() - 1;
    if (!options.from.empty()) {
        const Result<std::size_t> found = find_part(options.operation, options.from, "--from");
        if (!found) {
            return found.error();
        }
        first = found.value();
    }
    if (!options.to.empty()) {
        const Result<std::size_t> found = find_part(options.operation, options.to, "--to");
        if (!found) {
            return found.error();
        }
        last = found.value();
    }
    if (first > last) {
        return Error{"--from " + options.from + " comes after --to " + options.to, "", "the other way round"};
    }
    return std::pair(first, last);
}

/// What is set for one part: what is for all, and what names it.
std::map<std::string, std::string> set_for(const OperationOptions& options, const OperationPart& wanted) {
    std::map<std::string, std::string> own;
    for (const auto& [name, value] : options.attempt.exercise.set) {
        const bool for_one =
            std::any_of(options.operation.parts.begin(), options.operation.parts.end(),
                        [&name = name](const OperationPart& part) { return name.starts_with(part.id + "."); });
        if (!for_one) {
            own[name] = value;
        }
    }
    const std::string prefix = wanted.id + ".";
    for (const auto& [name, value] : options.attempt.exercise.set) {
        if (name.starts_with(prefix)) {
            own[name.substr(prefix.size())] = value;
        }
    }
    return own;
}

class Operating {
public:
    explicit Operating(const OperationOptions& options) : options_(options) {}

    /// Whether every part can be loaded, so that a mistake in the last one shows before the first is done.
    [[nodiscard]] Status check() const {
        for (std::size_t i = 0; i < options_.operation.parts.size(); ++i) {
            const Result<ExerciseHost> host = ExerciseHost::load(exercise(i));
            if (!host) {
                return Error{"part " + part(i).id + ": " + host.error().text(), part(i).where, ""};
            }
        }
        return success();
    }

    Result<OperationResult> run(std::size_t first, std::size_t last) {
        if (first > 0) {
            before_ = {{"completed", false}};  // what came before was not done by whoever operates
        }
        for (std::size_t i = first; i <= last && result_.script_error.empty(); ++i) {
            const Status done = options_.resume && take_up(i) ? success() : do_part(i);
            if (!done) {
                return done.error();
            }
        }
        return finish();
    }

private:
    [[nodiscard]] const OperationPart& part(std::size_t index) const { return options_.operation.parts[index]; }

    [[nodiscard]] std::string folder(std::size_t index) const {
        const std::string number = std::to_string(index + 1);
        return options_.attempt.folder + "/parts/" + (number.size() < 2 ? "0" : "") + number + "_" + part(index).id;
    }

    [[nodiscard]] ExerciseOptions exercise(std::size_t index) const {
        ExerciseOptions own = options_.attempt.exercise;
        own.curriculum = part(index).exercise;
        own.set = set_for(options_, part(index));
        own.part = PartPlace{options_.operation.name, static_cast<int>(index) + 1, before_};
        return own;
    }

    /// A part that was done before in this folder.
    bool take_up(std::size_t index) {
        const Result<std::string> text = read_whole_file(folder(index) + left_file);
        const json left = text ? json::parse(text.value(), nullptr, false) : json();
        const bool same = left.is_object() && left.value("fingerprint", json()) == fingerprint(index);
        if (same) {
            keep(index, left);
        }
        return same;
    }

    /// What decides how a part goes: besides what was asked for, all scripts.
    [[nodiscard]] json fingerprint(std::size_t index) const {
        const Result<std::string> scripts = hash_of_scripts(options_.attempt.exercise.root + "/scripts");
        const ExerciseOptions& all = options_.attempt.exercise;
        return {{"operation", options_.operation.identity},
                {"part", part(index).id},
                {"surgeon", all.surgeon},
                {"seed", all.seed},
                {"exercise", hash_of_curriculum(part(index).exercise, all.root)},
                {"scripts", scripts ? scripts.value() : ""},
                {"set", set_for(options_, part(index))}};
    }

    void keep(std::size_t index, const json& left) {
        done_.push_back({part(index).id, part(index).title, folder(index), left});
        before_ = left.at("carried");
    }

    /// Where the part begins: in what was left, or in a state of its own.
    Result<Start> start_of(std::size_t index) {
        const OperationPart& wanted = part(index);
        const bool has_before = !done_.empty();
        if (wanted.continues && has_before) {
            return Start{done_.back().folder + end_state, {}, {}, {}};
        }
        const Result<ExerciseHost> host = ExerciseHost::load(exercise(index));
        if (!host) {
            return host.error();
        }
        StartRequest request;
        request.curriculum = wanted.exercise;
        request.start = wanted.start;
        request.root = options_.attempt.exercise.root;
        request.quiet = options_.attempt.quiet;
        request.set = as_set(host.value().scene());
        std::string note;
        const Result<std::string> opening = opening_of(wanted, note);
        if (!opening) {
            return opening.error();
        }
        request.opening = opening.value();
        Result<Start> start = find_start(request);
        if (start) {
            start.value().opening_note = note;
        }
        return start;
    }

    /// The folder of the part in which the bag was opened, where it was done: "" where a bag cannot have what was torn
    /// there. Then it has a round opening, as if a supervisor had seen to it, and `note` says why.
    [[nodiscard]] Result<std::string> opening_of(const OperationPart& wanted, std::string& note) const {
        const auto done = std::find_if(done_.begin(), done_.end(),
                                       [&wanted](const DonePart& part) { return part.id == wanted.opening; });
        if (done == done_.end()) {
            return std::string();
        }
        const Result<std::string> recording = recording_path(done->folder);
        const Result<TornOpening> torn = recording ? read_torn_opening(recording.value()) : recording.error();
        if (!torn) {
            return torn.error();
        }
        if (torn.value().unfit) {
            note = torn.value().unfit->what;
            return std::string();
        }
        return done->folder;
    }

    static std::map<std::string, std::string> as_set(const SceneDescription& scene) {
        std::map<std::string, std::string> set;
        set["patient.age"] = short_number(scene.patient.age);
        set["patient.nuclear_grade"] = short_number(scene.patient.nuclear_grade);
        set["patient.cortical_opacity"] = short_number(scene.patient.cortical_opacity);
        set["patient.pupil_mm"] = short_number(scene.patient.pupil_mm);
        set["patient.side"] = scene.patient.side;
        set["patient.tetrahedra"] = std::to_string(scene.patient.tetrahedra);
        for (const auto& [name, value] : scene.settings) {
            set[name] = short_number(value);
        }
        return set;
    }

    Status do_part(std::size_t index) {
        if (!options_.attempt.quiet && isatty(STDERR_FILENO) != 0) {
            std::fprintf(stderr, "part %zu of %zu: %s\n", index + 1, options_.operation.parts.size(),
                         part(index).title.c_str());
        }
        Result<Start> start = start_of(index);
        if (!start) {
            return Error{"part " + part(index).id + ": " + start.error().text(), part(index).where, ""};
        }
        AttemptOptions own = options_.attempt;
        own.exercise = exercise(index);
        own.folder = folder(index);
        own.comparison = json::object();  // it is of the whole
        own.start = std::move(start).value();
        const bool goes_on = index + 1 < options_.operation.parts.size() && part(index + 1).continues;
        own.save = {goes_on ? own.folder + end_state : "", -1.0, ""};
        const Result<AttemptResult> made = attempt(own);
        if (!made) {
            return Error{"part " + part(index).id + ": " + made.error().text(), part(index).where, ""};
        }
        return conclude(index, made.value());
    }

    Status conclude(std::size_t index, const AttemptResult& made) {
        const std::string& broke_off = made.facts.script_error;
        result_.script_error = broke_off.empty() ? "" : "part " + part(index).id + ": " + broke_off;
        result_.drawing_note = made.drawing_note;
        result_.recordings.push_back(made.recording);
        json left = made.operation;
        if (!left.is_object()) {
            return success();  // its script broke off before it could judge anything
        }
        left["fingerprint"] = fingerprint(index);
        keep(index, left);
        // the last file of a part: where it stands, the part is whole
        return broke_off.empty() ? write_file(folder(index) + left_file, left.dump() + "\n") : success();
    }

    Result<OperationResult> finish() {
        const Result<WholeReport> whole = report_of_parts(options_, done_, result_.script_error);
        if (!whole) {
            return whole.error();
        }
        result_.report = whole.value().report;
        result_.report.update(options_.attempt.comparison);
        const std::string& to = options_.attempt.folder;
        Status status = write_file(to + "/series.json", whole.value().series.dump() + "\n");
        if (status) {
            status = write_file(to + "/report.json", result_.report.dump(2) + "\n");
        }
        if (!status) {
            return status.error();
        }
        const Result<std::string> html = report_page(options_.attempt.exercise.root, to);
        const Status written = html ? write_file(to + "/report.html", html.value()) : html.error();
        result_.html_error = written ? "" : written.error().text();
        return result_;
    }

    const OperationOptions& options_;
    std::vector<DonePart> done_;
    json before_ = json::object();
    OperationResult result_;
};

}  // namespace

Result<OperationResult> operate(const OperationOptions& options) {
    const Result<std::pair<std::size_t, std::size_t>> range = range_of(options);
    if (!range) {
        return range.error();
    }
    const Status fit = Operating(options).check();
    if (!fit) {
        return fit.error();
    }
    const Status prepared = prepare_folder(options.attempt.folder + "/parts");
    if (!prepared) {
        return prepared.error();
    }
    return Operating(options).run(range.value().first, range.value().second);
}

}  // namespace rhexis
