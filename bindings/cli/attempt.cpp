// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/attempt.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/output_file.hpp"
#include "cli/html.hpp"
#include "cli/pictures.hpp"
#include "cli/places.hpp"
#include "cli/progress.hpp"
#include "cli/report_json.hpp"
#include "cli/series.hpp"
#include "cli/timing.hpp"
#include "session/prepared_state.hpp"

namespace rhexis::cli {
namespace {

RecordingHeader header_of(const AttemptOptions& options, const ExerciseHost& host, const Session& session) {
    RecordingHeader header = rhexis::header_of(session);
    header.seed = options.exercise.seed;
    header.curriculum = options.exercise.curriculum;
    header.identity = host.identity().dump();
    header.surgeon = options.exercise.surgeon;
    header.set = options.exercise.set;
    return header;
}

/// One attempt while it runs.
class Attempt {
public:
    Attempt(const AttemptOptions& options, ExerciseHost host, Session session, RecordingWriter writer)
        : options_(options),
          host_(std::move(host)),
          session_(std::move(session)),
          writer_(std::move(writer)),
          series_(session_.schema()),
          progress_(options.exercise.curriculum, options.quiet),
          checkpoint_steps_(std::lround(checkpoint_interval_s / session_.scene().step_s)) {}

    void draw_with(PictureBook book) { book_.emplace(std::move(book)); }

    Status run() {
        Status status = begin();
        while (status && think()) {
            status = take_pictures();
            const bool last = over();
            if (status && wants_save(last)) {
                status = save();
            }
            if (!status || last) {
                break;
            }
            status = advance();
        }
        return status ? end() : status;
    }

    Result<AttemptResult> write_results();

private:
    Status begin() {
        series_.add(session_.observation());
        Status started = host_.start(session_.schema(), session_.scene().instruments);
        if (started && !options_.save.when.empty()) {
            started = host_.watch(options_.save.when, "--save-state");
        }
        if (!started) {
            script_error_ = started.error().text();
        }
        if (book_) {
            Status kept = book_->keep(session_.frame(), "start", "Before the first step.");
            if (!kept) {
                return kept;
            }
        }
        Status status = options_.start.state.empty() ? success() : writer_.add(session_.copy_state());
        return status ? writer_.add(RecordedStart{session_.observation(), session_.state_hash()}) : status;
    }

    /// The exercise sees what happened, then the surgeon. False when a script failed.
    bool think() {
        if (!script_error_.empty()) {
            return false;
        }
        Result<std::vector<Command>> commands = host_.observe(session_.observation(), commands_);
        commands_.clear();
        samples_.clear();
        if (!commands) {
            script_error_ = commands.error().text();
            return false;
        }
        commands_ = std::move(commands).value();
        if (options_.watch) {
            look_for_changes();
        }
        if (!host_.has_surgeon() || host_.finished()) {
            return true;
        }
        Result<SurgeonStep> done = host_.operate(session_.percept());
        if (!done) {
            script_error_ = done.error().text();
            return false;
        }
        samples_ = std::move(done.value().samples);
        commands_.insert(commands_.end(), done.value().requests.begin(), done.value().requests.end());
        return true;
    }

    /// Between two steps of the exercise: takes up its changed files, or says why not and goes on with what there is.
    void look_for_changes() {
        const Result<bool> boundary = host_.at_boundary();
        if (!boundary || !boundary.value() || session_.time_s() <= 0.0) {
            return;
        }
        const Result<std::optional<std::vector<Command>>> changes = host_.reload();
        if (changes && !changes.value()) {
            return;
        }
        nlohmann::json note = {{"time_s", session_.time_s()}, {"sha256", host_.identity().at("sha256")}};
        if (changes) {
            commands_.insert(commands_.end(), changes.value()->begin(), changes.value()->end());
        } else {
            note["refused"] = changes.error().text();
        }
        const std::string said =
            changes ? "the changed exercise is taken up" : changes.error().text() + "; the run goes on unchanged";
        std::fprintf(stderr, "rhexis: after %.2f s: %s\n", session_.time_s(), said.c_str());
        reloads_.push_back(std::move(note));
    }

    bool wants_save(bool last) {
        if (options_.save.path.empty() || saved_ || !script_error_.empty()) {
            return false;
        }
        if (options_.save.at_s >= 0.0) {
            return session_.time_s() + 1e-9 >= options_.save.at_s;
        }
        if (options_.save.when.empty()) {
            return last;
        }
        const Result<bool> reached = host_.reached();
        script_error_ = reached ? "" : reached.error().text();
        return reached && reached.value();
    }

    /// The run goes on as if nothing had been kept.
    Status save() {
        saved_ = true;
        return write_state(options_.save.path, {header_of(options_, host_, session_), session_.copy_state()});
    }

    bool over() {
        const bool asked = std::any_of(commands_.begin(), commands_.end(),
                                       [](const Command& command) { return command.kind == CommandKind::finish; });
        cut_off_ = !asked && !host_.finished() && session_.time_s() + 1e-9 >= options_.limit_s;
        return asked || cut_off_ || host_.finished();
    }

    Status advance() {
        timing_.step(session_, samples_, commands_);
        series_.add(session_.observation());
        Status status = writer_.add(
            RecordedStep{session_.step_count(), samples_, commands_, session_.observation(), session_.state_hash()});
        if (status && session_.step_count() % checkpoint_steps_ == 0) {
            status = writer_.add(session_.snapshot());
        }
        if (status && book_ && book_->wants_film(session_.time_s())) {
            status = book_->film(session_.frame());
        }
        show_progress();
        return status;
    }

    /// Pictures that the exercise asks for show the moment at which it asks.
    Status take_pictures() {
        for (const Command& command : commands_) {
            if (command.kind == CommandKind::picture && book_) {
                end_pictured_ = end_pictured_ || command.name == "end";
                Status status = book_->keep(session_.frame(), command.name, command.text);
                if (!status) {
                    return status;
                }
            }
        }
        return success();
    }

    Status end() {
        if (book_) {
            Status status = end_pictured_ ? success() : book_->keep(session_.frame(), "end", "At the end.");
            status = status ? book_->finish() : status;
            if (!status) {
                return status;
            }
        }
        return writer_.finish();
    }

    void show_progress() {
        char note[64];
        std::snprintf(note, sizeof note, "%.1f s simulated", session_.time_s());
        progress_.show(session_.time_s() / time_limit(), note);
    }

    [[nodiscard]] double time_limit() const {
        return std::min(options_.limit_s, host_.identity().value("time_limit_s", options_.limit_s));
    }

    [[nodiscard]] Log full_log() const {
        Log log = session_.log();
        if (!options_.start.opening_note.empty()) {
            log.insert(log.begin(), {LogLevel::warning, 0.0,
                                     "this part begins with a round opening, not with what was torn: " +
                                         options_.start.opening_note});
        }
        if (cut_off_) {
            log.push_back({LogLevel::warning, session_.time_s(), "the run was ended at its limit of simulated time"});
        }
        return log;
    }

    AttemptOptions options_;
    ExerciseHost host_;
    Session session_;
    RecordingWriter writer_;
    std::optional<PictureBook> book_;
    Series series_;
    Timing timing_;
    Progress progress_;
    std::uint64_t checkpoint_steps_;
    std::vector<Command> commands_;
    std::vector<DeviceSample> samples_;
    std::string script_error_;
    nlohmann::json reloads_ = nlohmann::json::array();
    bool end_pictured_ = false;
    bool cut_off_ = false;
    bool saved_ = false;
};

Result<AttemptResult> Attempt::write_results() {
    AttemptResult result;
    Result<nlohmann::json> judged = host_.result();
    if (!judged && script_error_.empty()) {
        script_error_ = judged.error().text();
    }
    ReportInput input;
    input.identity = host_.identity();
    input.surgeon = options_.exercise.surgeon;
    input.set = options_.exercise.set;
    input.seed = options_.exercise.seed;
    input.start = options_.start.state;
    input.begun_at = options_.start.chosen;
    input.opening = session_.scene().opening;
    input.opening_note = options_.start.opening_note;
    input.patient = session_.scene().patient;
    input.duration_s = session_.time_s();
    input.state_hash = session_.state_hash();
    input.result = judged ? judged.value() : nlohmann::json::object();
    if (input.result.contains("operation")) {
        result.operation = std::move(input.result["operation"]);
        input.result.erase("operation");
    }
    if (!reloads_.empty()) {
        input.result["reloads"] = reloads_;
    }
    input.script_error = script_error_;
    if (book_) {
        input.pictures = book_->pictures();
        input.video = book_->has_video();
    }
    input.log = full_log();
    input.simulated = simulated_parts(session_);
    input.performance = timing_.performance(session_.time_s());
    result.report = make_report(input);
    result.report.update(options_.comparison);
    result.script_error = script_error_;
    result.recording = writer_.file();
    result.saved = saved_;
    // the report last: where it stands, all that it speaks of is there
    Status status = write_file(options_.folder + "/series.json", series_.json().dump() + "\n");
    if (status) {
        status = write_file(options_.folder + "/report.json", result.report.dump(2) + "\n");
    }
    if (!status) {
        return status.error();
    }
    return result;
}

/// The session that the exercise asks for, in the state that the attempt starts from.
Result<Session> make_session(const AttemptOptions& options, const ExerciseHost& host) {
    SceneDescription scene = host.scene();
    scene.threads = options.threads;
    scene.instruction_set = options.instruction_set;
    scene.opening = options.start.opening;
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

}  // namespace

Result<AttemptResult> attempt(const AttemptOptions& options) {
    Result<ExerciseHost> host = ExerciseHost::load(options.exercise);
    if (!host) {
        return host.error();
    }
    Result<Session> session = make_session(options, host.value());
    if (!session) {
        return session.error();
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
    Attempt running(options, std::move(host).value(), std::move(session).value(), std::move(writer).value());
    if (book.value()) {
        running.draw_with(std::move(*book.value()));
    }
    const Status ran = running.run();
    if (!ran) {
        return ran.error();
    }
    Result<AttemptResult> result = running.write_results();
    if (!result) {
        return result;
    }
    result.value().drawing_note = drawing_note;
    write_html(options, result.value());
    return result;
}

}  // namespace rhexis::cli
