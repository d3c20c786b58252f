// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/attempt.hpp"

#include <algorithm>
#include <filesystem>

#include "base/output_file.hpp"
#include "flow/microscope.hpp"
#include "session/prepared_state.hpp"
#include "session/replay.hpp"
#include "trial/accuracy_measure.hpp"
#include "trial/hot_reload.hpp"
#include "trial/html.hpp"
#include "trial/pictures.hpp"
#include "trial/places.hpp"
#include "trial/recorder.hpp"
#include "trial/report_json.hpp"
#include "trial/series.hpp"
#include "trial/timing.hpp"
#include "trial/told_errors.hpp"
#include "trial/trial_progress.hpp"
#include "trial/virtual_surgeon.hpp"

namespace rhexis {
namespace {

std::string who_operates(const AttemptOptions& options) {
    return options.guest != nullptr ? options.guest->name() : options.exercise.surgeon;
}

RecordingHeader header_of(const AttemptOptions& options, const ExerciseHost& host, const Session& session) {
    RecordingHeader header = rhexis::header_of(session);
    header.seed = options.exercise.seed;
    header.curriculum = options.exercise.curriculum;
    header.identity = host.identity().dump();
    header.surgeon = who_operates(options);
    if (options.guest != nullptr) {
        header.surgeon += " (" + options.guest->device() + ")";
    }
    header.set = options.exercise.set;
    return header;
}

/// Pictures of the moments that the exercise asks for, of the first and the last, and the film in between.
class PictureObserver final : public TrialObserver {
public:
    explicit PictureObserver(PictureBook& book) : book_(book) {}

    Status begun(Timeline& timeline) override {
        return book_.keep(timeline.session()->frame(), "start", "Before the first step.");
    }
    Status look(Moment& moment) override {
        for (const Command& command : moment.commands) {
            if (command.kind != CommandKind::picture) {
                continue;
            }
            end_pictured_ = end_pictured_ || command.name == "end";
            if (Status kept = book_.keep(moment.timeline.session()->frame(), command.name, command.text); !kept) {
                return kept;
            }
        }
        return success();
    }
    Status stepped(const TrialStep& step) override {
        return book_.wants_film(step.session.time_s()) ? book_.film(step.session.frame()) : success();
    }
    Status ended(Timeline& timeline) override {
        const Status kept = end_pictured_ ? success() : book_.keep(timeline.session()->frame(), "end", "At the end.");
        return kept ? book_.finish() : kept;
    }

private:
    PictureBook& book_;
    bool end_pictured_ = false;
};

/// What a trial and those who looked on leave for the report.
struct Seen {
    const TrialOutcome& outcome;
    const Series& series;
    const Timing& timing;
    const ToldErrors& told;
    const Recorder& recorder;
    const StateKeeper& keeper;
    const HotReload& reload;
    const PictureBook* book;
};

Log full_log(const AttemptOptions& options, const Session& session, TrialEnd end) {
    Log log = session.log();
    if (!options.start.opening_note.empty()) {
        log.insert(log.begin(),
                   {LogLevel::warning, 0.0,
                    "this part begins with a round opening, not with what was torn: " + options.start.opening_note});
    }
    if (end == TrialEnd::time_up) {
        log.push_back({LogLevel::warning, session.time_s(), "the run was ended at its limit of simulated time"});
    }
    return log;
}

AttemptFacts facts_of(const AttemptOptions& options, const ExerciseHost& host, const Session& session,
                      const Seen& seen) {
    AttemptFacts facts;
    facts.identity = host.identity();
    facts.surgeon = who_operates(options);
    facts.device = options.guest != nullptr ? options.guest->device() : "";
    facts.set = options.exercise.set;
    facts.seed = options.exercise.seed;
    facts.start = options.start.state;
    facts.begun_at = options.start.chosen;
    facts.opening = session.scene().opening;
    facts.opening_note = options.start.opening_note;
    facts.patient = session.scene().patient;
    facts.accuracy = session.scene().accuracy;
    facts.duration_s = session.time_s();
    facts.state_hash = session.state_hash();
    if (seen.book != nullptr) {
        facts.pictures = seen.book->pictures();
        facts.video = seen.book->has_video();
    }
    facts.log = full_log(options, session, seen.outcome.end);
    facts.simulated = simulated_parts(session);
    facts.performance = seen.timing.performance(session.time_s());
    facts.performance.checkpoints = seen.recorder.checkpoints();
    if (options.link != nullptr) {
        facts.link = options.link->figures();
    }
    facts.performance.live = options.guest != nullptr ? options.guest->pace() : std::nullopt;
    return facts;
}

/// What the exercise's script found, or why it found nothing.
void judge(ExerciseHost& host, const Seen& seen, AttemptResult& result) {
    AttemptFacts& facts = result.facts;
    const std::optional<Error>& failed = seen.outcome.error ? seen.outcome.error : seen.keeper.error();
    facts.script_error = failed ? failed->text() : "";
    Result<nlohmann::json> judged = host.result();
    if (!judged && facts.script_error.empty()) {
        facts.script_error = judged.error().text();
    }
    facts.findings = judged ? judged.value() : nlohmann::json::object();
    if (facts.findings.contains("operation")) {
        result.operation = std::move(facts.findings["operation"]);
        facts.findings.erase("operation");
    }
    if (!seen.reload.reloads().empty()) {
        facts.findings["reloads"] = seen.reload.reloads();
    }
    facts.completed = facts.script_error.empty() && facts.findings.value("completed", nlohmann::json()) == true;
    facts.score = score_in(facts.findings);
}

Result<AttemptResult> write_results(const AttemptOptions& options, ExerciseHost& host, const Session& session,
                                    const Seen& seen) {
    AttemptResult result;
    result.facts = facts_of(options, host, session, seen);
    judge(host, seen, result);
    result.comparison = options.comparison;
    result.recording = seen.recorder.file();
    result.saved = seen.keeper.kept();
    if (options.measure_accuracy) {
        Result<nlohmann::json> measured = measure_accuracy(result.recording, options, seen.told.largest());
        if (!measured) {
            return measured.error();
        }
        result.facts.measured = std::move(measured).value();
    }
    // the report last: where it stands, all that it speaks of is there
    Status status = write_file(options.folder + "/series.json", seen.series.json().dump() + "\n");
    if (status) {
        status = write_file(options.folder + "/report.json", report_of(result).dump(2) + "\n");
    }
    return status ? Result<AttemptResult>(std::move(result)) : status.error();
}

/// All observations but that of the moment from which it goes on.
void catch_up(const GoingOn& before, Series& series) {
    for (std::uint64_t step = 0; step < before.step; ++step) {
        series.add(step == 0 ? before.recording.start.observation : before.recording.steps[step - 1].observation);
    }
}

/// The trial itself: by the virtual surgeon of the exercise, or by nobody.
Result<AttemptResult> operate(const AttemptOptions& options, ExerciseHost& host, Session& session,
                              RecordingWriter writer, PictureBook* book, std::optional<std::uint64_t>& back) {
    Series series(session.schema());
    Timing timing;
    ToldErrors told;
    Recorder recorder(std::move(writer), options.start.state.empty(), options.going_on);
    if (options.going_on != nullptr) {
        catch_up(*options.going_on, series);
    }
    StateKeeper keeper(options.save, host, header_of(options, host, session));
    HotReload reload(host);
    TrialProgress progress(options.exercise.curriculum, options.quiet,
                           std::min(options.limit_s, host.identity().value("time_limit_s", options.limit_s)));
    std::optional<PictureObserver> pictures;
    std::vector<TrialObserver*> observers = {&timing, &told, &series, &recorder};
    if (options.watch) {
        observers.push_back(&reload);
    }
    if (book != nullptr) {
        observers.push_back(&pictures.emplace(*book));
    }
    if (!options.save.path.empty()) {
        observers.push_back(&keeper);
    }
    observers.push_back(&progress);
    if (options.guest != nullptr) {
        options.guest->meet(host);
        observers.push_back(options.guest);
    }
    LiveTimeline timeline(session);
    VirtualSurgeon surgeon(host);
    Operator& whoever = options.guest != nullptr ? static_cast<Operator&>(*options.guest) : surgeon;
    std::optional<LinkedOperator> linked;
    Operator& hands = options.link != nullptr ? linked.emplace(whoever, *options.link) : whoever;
    CaughtUp exercise(host, options.going_on);
    const Result<TrialOutcome> outcome =
        Trial(timeline, &exercise, hands, std::move(observers), {options.limit_s}).run();
    if (!outcome) {
        return outcome.error();
    }
    if (options.guest != nullptr && (back = options.guest->goes_back())) {
        AttemptResult unfinished;
        unfinished.recording = recorder.file();
        return unfinished;
    }
    return write_results(options, host, session,
                         {outcome.value(), series, timing, told, recorder, keeper, reload, book});
}

/// Where a person operates there is a microscope to look through, centred and in focus unless the exercise is about
/// that. It is centred on a pupil.
void add_microscope(SceneDescription& scene) {
    const bool has_pupil = std::find(scene.tissues.begin(), scene.tissues.end(), "iris") != scene.tissues.end();
    const bool has_one =
        std::find(scene.instruments.begin(), scene.instruments.end(), microscope_name) != scene.instruments.end();
    if (!has_pupil || has_one) {
        return;
    }
    scene.instruments.emplace_back(microscope_name);
    for (const char* setting : {"microscope.x_mm", "microscope.y_mm", "microscope.focus_mm"}) {
        scene.settings.emplace(setting, 0.0);
    }
}

/// The session that the exercise asks for, in the state that the attempt starts from.
Result<Session> make_session(const AttemptOptions& options, const ExerciseHost& host) {
    if (options.going_on != nullptr) {
        return session_at(options.going_on->recording, options.going_on->step);
    }
    SceneDescription scene = host.scene();
    scene.threads = options.threads;
    scene.instruction_set = options.instruction_set;
    scene.opening = options.start.opening;
    if (options.guest != nullptr) {
        add_microscope(scene);
    }
    return create_session(scene, options.exercise.seed, options.start.state);
}

Result<std::optional<PictureBook>> open_book(const AttemptOptions& options, std::string& note) {
    if (options.drawing == Drawing::none) {
        return std::optional<PictureBook>();
    }
    Result<PictureBook> book = PictureBook::create(options.folder, options.drawing == Drawing::video);
    if (book) {
        return std::optional<PictureBook>(std::move(book).value());
    }
    if (options.drawing == Drawing::video) {
        return book.error();
    }
    note = book.error().text();
    return std::optional<PictureBook>();
}

/// The page is for reading; a run without it is still a run.
void write_html(const AttemptOptions& options, AttemptResult& result) {
    const Result<std::string> html = report_page(options.exercise.root, options.folder);
    const Status written = html ? write_file(options.folder + "/report.html", html.value()) : html.error();
    result.html_error = written ? "" : written.error().text();
}

/// From its beginning, or from where it goes on, to its end, or until whoever operates goes back. back: to which step.
Result<AttemptResult> attempt_once(const AttemptOptions& options, std::optional<std::uint64_t>& back) {
    Result<ExerciseHost> host = ExerciseHost::load(options.exercise);
    if (!host) {
        return host.error();
    }
    Result<Session> session = make_session(options, host.value());
    if (!session) {
        return session.error();
    }
    if (options.link != nullptr) {
        const SceneDescription& scene = session.value().scene();
        if (const Status begun = options.link->begin(scene.instruments, scene.step_s); !begun) {
            return begun.error();
        }
    }
    const Status prepared = prepare_folder(options.folder);
    if (!prepared) {
        return prepared.error();
    }
    std::string drawing_note;
    Result<std::optional<PictureBook>> book = open_book(options, drawing_note);
    if (!book) {
        return book.error();
    }
    const RecordingHeader header = header_of(options, host.value(), session.value());
    Result<RecordingWriter> writer = RecordingWriter::create(options.folder + "/recording.rhx", header);
    if (!writer) {
        return writer.error();
    }
    PictureBook* pictures = book.value() ? &*book.value() : nullptr;
    if (pictures != nullptr && options.guest != nullptr) {
        pictures->draw_later();
    }
    Result<AttemptResult> result =
        operate(options, host.value(), session.value(), std::move(writer).value(), pictures, back);
    if (!result || back) {
        return result;
    }
    result.value().drawing_note = drawing_note;
    write_html(options, result.value());
    return result;
}

}  // namespace

nlohmann::json report_of(const AttemptResult& result) {
    nlohmann::json report = make_report(result.facts);
    report.update(result.comparison);
    return report;
}

Result<AttemptResult> attempt(const AttemptOptions& options) {
    AttemptOptions now = options;
    std::optional<GoingOn> before;
    for (;;) {
        std::optional<std::uint64_t> back;
        Result<AttemptResult> result = attempt_once(now, back);
        if (!result || !back) {
            return result;
        }
        // what is left behind stays in the folder
        const Result<std::string> aside = put_aside(result.value().recording);
        if (!aside) {
            return aside.error();
        }
        Result<Recording> recording = read_recording(aside.value());
        if (!recording) {
            return recording.error();
        }
        Result<GoingOn> from = going_on_from(std::move(recording).value(), *back);
        if (!from) {
            return from.error();
        }
        before = std::move(from).value();
        before->recording.header.scene.threads = options.threads;
        before->recording.header.scene.instruction_set = options.instruction_set;
        now.going_on = &*before;
    }
}

}  // namespace rhexis
