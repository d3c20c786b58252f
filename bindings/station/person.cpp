// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/person.hpp"

#include <utility>

#include "render/renderer.hpp"

namespace rhexis::station {
namespace {

constexpr double slowed_below = 0.95;  ///< simulated seconds per second: slower is an aid
constexpr std::size_t most_lines = 3;  ///< said to the trainee, that are still shown
constexpr double shown_s = 10.0;       ///< each, unless it is the last [s]

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
        hands_->take(event, *around_);
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
        } else if (kept_step_ < session.step_count()) {
            back_ = kept_step_;
            aids_.push_back({CommandKind::aid, "rewound",
                             session.scene().step_s * static_cast<double>(session.step_count() - kept_step_), ""});
        }
    }
    if (exam_ && std::exchange(state.ghost, false)) {
        hands_->tell("an exam shows no ghost");
    }
    if (state.ghost && !options_.has_ghost) {
        state.ghost = false;
        hands_->tell("there is no expert's way: rhexis train --ghost RUN, of rhexis run");
    }
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
                                             marks ? marks.value() : std::vector<Vec3>{}}));
    if (options_.wait_for_pictures && !waits) {
        desk_.wait_until_drawn(session.step_count());
    }
}

Result<OperatorStep> Person::operate(Timeline& timeline) {
    const Session& session = *timeline.session();
    around_ = surroundings_of(session, hands_->state());
    if (options_.wait_for_pictures ? session.step_count() % options_.show_every == 0 : desk_.wants_picture()) {
        show(session, hands_->waits());
    }
    do {
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
    if (const Status moved = hands_->advance(*around_, dt); !moved) {
        return moved.error();
    }
    note_aids(dt);
    ++made_;
    OperatorStep step{hands_->samples(*around_, dt), hands_->take_commands()};
    step.commands.insert(step.commands.end(), aids_.begin(), aids_.end());
    aids_.clear();
    return step;
}

}  // namespace rhexis::station
