// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/person.hpp"

#include <algorithm>
#include <utility>

#include "base/clock.hpp"
#include "render/renderer.hpp"

namespace rhexis::station {
namespace {

constexpr double slowed_below = 0.95;  ///< simulated seconds per second: slower is an aid
constexpr std::size_t most_lines = 3;  ///< said to the trainee, that are still shown
constexpr double shown_s = 10.0;       ///< each, unless it is the last [s]
constexpr double theatre_every_s = 0.05;
constexpr double score_every_s = 1.0;

/// Pads and pedals as they come and go.
void note_device(const UserEvent& event, std::vector<DeviceHealth>& devices) {
    const bool of_window = event.kind == EventKind::focus && event.name.empty();
    if (event.kind != EventKind::device && !of_window) {
        return;
    }
    const std::string name = of_window ? "keyboard and mouse" : event.name;
    const auto found =
        std::find_if(devices.begin(), devices.end(), [&](const DeviceHealth& one) { return one.name == name; });
    if (found == devices.end()) {
        devices.push_back({name, event.value > 0.5});
    } else {
        found->there = event.value > 0.5;
    }
}

}  // namespace

Camera adjusted(Camera camera, const HandsState& hands) {
    camera.field_mm /= hands.zoom;
    camera.stop_mm /= hands.zoom;
    camera.light = hands.light;
    return camera;
}

Surroundings surroundings_of(const Session& session, const HandsState& hands) {
    const WorldState& state = session.state();
    const WorldModel& world = session.world();
    const EyeAnatomy& anatomy = session.eye().anatomy;
    return {Sight(adjusted(microscope_camera(anatomy, world, state.microscope), hands), &anatomy,
                  world.globe ? &*world.globe : nullptr, state.globe ? &*state.globe : nullptr),
            session.percept(), state.microscope ? std::optional<Vec3>(state.microscope->position) : std::nullopt};
}

Status Person::begin(Timeline& timeline) {
    Result<HoldScript> holds = HoldScript::load(options_.root);
    if (!holds) {
        return holds.error();
    }
    holds_.emplace(std::move(holds).value());
    const Result<nlohmann::json> requests = host_ != nullptr ? host_->declared_requests() : nlohmann::json::array();
    if (!requests) {
        return requests.error();
    }
    const Result<nlohmann::json> stands = host_ != nullptr ? host_->result() : nlohmann::json::object();
    if (!stands) {
        return stands.error();
    }
    exam_ = stands.value().value("mode", "") == "exam";
    stand_ = std::make_shared<const Stand>(make_stand(*timeline.session(), requests.value()));
    hands_.emplace(options_.mapping, *stand_, *holds_);
    if (options_.device == tracked_device) {
        hands_->track();
    }
    hands_->state().warns = options_.warns && !exam_;
    if (host_ != nullptr) {
        Result<Instructor> instructor = Instructor::create(*host_, timeline.session()->world().microscope.has_value());
        if (!instructor) {
            return instructor.error();
        }
        instructor_ = std::move(instructor).value();
    }
    panel_.emplace(timeline.schema(), timeline.scene().instruments);
    around_ = surroundings_of(*timeline.session(), hands_->state());
    return timeline.step_count() > 0 ? hands_->take_over(*timeline.session(), *around_) : success();
}

std::optional<Pace> Person::pace() const {
    std::optional<Pace> pace = source_.pace();
    if (pace) {
        pace->pictures_per_s = desk_.pictures_per_s();
    }
    return pace;
}

/// What is said to the trainee.
Status Person::look(Moment& moment) {
    for (const Command& command : moment.commands) {
        if (command.kind == CommandKind::say) {
            said_.push_back({moment.timeline.observation().time_s, command.text});
        }
    }
    const double now = moment.timeline.observation().time_s;
    while (said_.size() > most_lines || (said_.size() > 1 && said_.front().time_s + shown_s < now)) {
        said_.erase(said_.begin());
    }
    return success();
}

/// False: nothing comes any more.
Result<bool> Person::take_events(const Session& session) {
    const Result<std::vector<UserEvent>> events = source_.take(made_, hands_->waits(), *hands_, *around_, session);
    if (!events) {
        return events.error();
    }
    for (const UserEvent& event : events.value()) {
        const Status kept = writer_ != nullptr ? writer_->add(made_, event) : success();
        if (!kept) {
            return kept.error();
        }
        if (event.kind == EventKind::staff) {
            instructor_.heed(event, *hands_, *around_);
        } else {
            hands_->take(event, *around_);
        }
        note_device(event, moment_.devices);
    }
    return !(events.value().empty() && hands_->waits() && source_.over());
}

/// Moments to go back to. An attempt that went back says so, and an exam refuses.
void Person::heed_wishes(const Session& session) {
    HandsState& state = hands_->state();
    if (std::exchange(state.keep_moment, false)) {
        kept_step_ = session.step_count();
        hands_->tell("this moment is kept");
    }
    if (std::exchange(state.try_again, false)) {
        if (exam_) {
            hands_->tell("an exam has no second try");
        } else {
            go_back(session, kept_step_);
        }
    }
    if (const std::optional<double> rewind_s = instructor_.take_rewind()) {
        const auto steps = static_cast<std::uint64_t>(*rewind_s / session.scene().step_s);
        go_back(session, session.step_count() - std::min(steps, session.step_count()));
    }
    if (exam_ && std::exchange(state.warns, false)) {
        hands_->tell("an exam does not warn");
    }
    if (exam_ && std::exchange(state.ghost, false)) {
        hands_->tell("an exam shows no ghost");
    }
    if (state.ghost && !options_.has_ghost) {
        state.ghost = false;
        hands_->tell("there is no expert's way: rhexis train --ghost RUN, of rhexis run");
    }
}

void Person::go_back(const Session& session, std::uint64_t step) {
    if (step < session.step_count()) {
        back_ = step;
        aids_.push_back({CommandKind::aid, "rewound",
                         session.scene().step_s * static_cast<double>(session.step_count() - step), ""});
    }
}

/// Of what is about to go wrong, where that is wished for; each that is shown is an aid.
Status Person::warn() {
    std::vector<std::string> now;
    if (hands_->state().warns && host_ != nullptr) {
        const Result<nlohmann::json> raised = host_->warnings();
        if (!raised) {
            return raised.error();
        }
        for (const nlohmann::json& one : raised.value()) {
            const std::string title = one.at("title");
            now.push_back(title + ". " + one.at("advice").get<std::string>());
            if (std::find(warnings_.begin(), warnings_.end(), now.back()) == warnings_.end()) {
                aids_.push_back({CommandKind::aid, "warned", 0.0, title});
            }
        }
    }
    warnings_ = std::move(now);
    return success();
}

/// Simulated seconds that took more than a second of the clock, and those with a ghost.
void Person::note_aids(double dt) {
    guided_s_ += hands_->state().ghost ? dt : 0.0;
    if (guided_s_ >= 1.0) {
        aids_.push_back({CommandKind::aid, "guided", std::exchange(guided_s_, 0.0), ""});
    }
    slowed_s_ += source_.slowed() < slowed_below ? dt : 0.0;
    if (slowed_s_ >= 1.0) {
        aids_.push_back({CommandKind::aid, "slowed", std::exchange(slowed_s_, 0.0), ""});
    }
}

void Person::show(const Session& session, bool waits) {
    std::vector<std::string> lines;
    for (const Said& said : said_) {
        lines.push_back(said.text);
    }
    const Result<std::vector<Vec3>> marks = host_ != nullptr ? host_->marks() : std::vector<Vec3>{};
    desk_.show(std::make_shared<Shown>(Shown{session.frame(), hands_->state(), *around_, session.step_count(),
                                             source_.last_number(), source_.slowed(), waits, stand_, std::move(lines),
                                             marks ? marks.value() : std::vector<Vec3>{}, warnings_,
                                             panel_->forces(session)}));
    if (options_.wait_for_pictures && !waits) {
        desk_.wait_until_drawn(session.step_count());
    }
}

void Person::sound(const Session& session) {
    if (!options_.sounds) {
        return;
    }
    Heard heard{panel_->panel(session), 0.0, hands_->waits()};
    for (const HandForce& force : panel_->forces(session)) {
        heard.force_mN = std::max(heard.force_mN, force.mN);
    }
    desk_.hear(heard);
}

/// The monitor sees each moment whole; how many, the wall clock says.
Status Person::show_theatre(const Session& session, bool ended) {
    const double now = wall_seconds();
    if (theatre_ == nullptr || host_ == nullptr || (!ended && now < theatre_due_s_)) {
        return success();
    }
    theatre_due_s_ = now + theatre_every_s;
    const bool score = ended || now >= score_due_s_;
    score_due_s_ = score ? now + score_every_s : score_due_s_;
    if (const Status told = tell_exercise(*host_, score, moment_); !told) {
        return told;
    }
    moment_.exercise = options_.title;
    moment_.time_s = session.time_s();
    moment_.waits = hands_->waits();
    moment_.paused = hands_->state().paused;
    moment_.ended = ended;
    moment_.exam = exam_;
    moment_.warns = hands_->state().warns;
    moment_.slowed = source_.slowed();
    moment_.pictures_per_s = desk_.pictures_per_s();
    moment_.machine = panel_->panel(session);
    moment_.forces = panel_->forces(session);
    moment_.lines.clear();
    for (const Said& said : said_) {
        moment_.lines.push_back(said.text);
    }
    moment_.injections = instructor_.injections();
    moment_.levels = instructor_.levels();
    theatre_->show(moment_);
    return success();
}

Status Person::ended(Timeline& timeline) { return show_theatre(*timeline.session(), true); }

Result<OperatorStep> Person::operate(Timeline& timeline) {
    const Session& session = *timeline.session();
    around_ = surroundings_of(session, hands_->state());
    if (const Status warned = warn(); !warned) {
        return warned.error();
    }
    if (options_.wait_for_pictures ? session.step_count() % options_.show_every == 0 : desk_.wants_picture()) {
        show(session, hands_->waits());
    }
    do {
        sound(session);
        if (const Status shown = show_theatre(session, false); !shown) {
            return shown.error();
        }
        const Result<bool> more = take_events(session);
        if (!more) {
            return more.error();
        }
        heed_wishes(session);
        if (!more.value() || hands_->state().stop || back_ || desk_.closed()) {
            return OperatorStep{.done = true};
        }
        if (hands_->waits()) {
            show(session, true);
        }
    } while (hands_->waits());
    const double dt = session.scene().step_s;
    const std::vector<Command> staff = instructor_.advance(dt, session, *hands_);
    if (const Status moved = hands_->advance(*around_, dt); !moved) {
        return moved.error();
    }
    note_aids(dt);
    ++made_;
    OperatorStep step{hands_->samples(*around_, dt), hands_->take_commands()};
    instructor_.move_microscope(*around_, step.samples);
    step.commands.insert(step.commands.end(), staff.begin(), staff.end());
    step.commands.insert(step.commands.end(), aids_.begin(), aids_.end());
    aids_.clear();
    return step;
}

}  // namespace rhexis::station
