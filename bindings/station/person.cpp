// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/person.hpp"

#include <utility>

#include "render/renderer.hpp"

namespace rhexis::station {
namespace {

constexpr std::size_t most_lines = 4;  ///< said to the trainee, that are still shown

}  // namespace

Camera zoomed(Camera camera, double zoom) {
    camera.field_mm /= zoom;
    camera.stop_mm /= zoom;
    return camera;
}

Surroundings surroundings_of(const Session& session, double zoom) {
    const WorldState& state = session.state();
    const WorldModel& world = session.world();
    const EyeAnatomy& anatomy = session.eye().anatomy;
    return {Sight(zoomed(microscope_camera(anatomy, world, state.microscope), zoom), &anatomy,
                  world.globe ? &*world.globe : nullptr, state.globe ? &*state.globe : nullptr),
            session.percept().landmarks,
            state.microscope ? std::optional<Vec3>(state.microscope->position) : std::nullopt};
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
    tray_ = std::make_shared<const Tray>(make_tray(*timeline.session(), requests.value()));
    hands_.emplace(options_.mapping, *tray_, *holds_);
    around_ = surroundings_of(*timeline.session(), hands_->state().zoom);
    return success();
}

/// What is said to the trainee.
Status Person::look(Moment& moment) {
    for (const Command& command : moment.commands) {
        if (command.kind == CommandKind::say) {
            said_.push_back(command.text);
        }
    }
    if (said_.size() > most_lines) {
        said_.erase(said_.begin(), said_.end() - most_lines);
    }
    return success();
}

/// False: nothing comes any more.
Result<bool> Person::take_events(const Session& session) {
    const Result<std::vector<UserEvent>> events =
        source_.take(session.step_count(), hands_->waits(), *hands_, *around_, session);
    if (!events) {
        return events.error();
    }
    for (const UserEvent& event : events.value()) {
        const Status kept = writer_ != nullptr ? writer_->add(session.step_count(), event) : success();
        if (!kept) {
            return kept.error();
        }
        hands_->take(event, *around_);
    }
    return !(events.value().empty() && hands_->waits() && source_.over());
}

void Person::show(const Session& session, bool waits) {
    desk_.show(std::make_shared<Shown>(Shown{session.frame(), hands_->state(), *around_, session.step_count(),
                                             source_.last_number(), source_.slowed(), waits, tray_, said_}));
    if (options_.wait_for_pictures && !waits) {
        desk_.wait_until_drawn(session.step_count());
    }
}

Result<OperatorStep> Person::operate(Timeline& timeline) {
    const Session& session = *timeline.session();
    around_ = surroundings_of(session, hands_->state().zoom);
    if (options_.wait_for_pictures ? session.step_count() % options_.show_every == 0 : desk_.wants_picture()) {
        show(session, hands_->waits());
    }
    do {
        const Result<bool> more = take_events(session);
        if (!more) {
            return more.error();
        }
        if (!more.value() || hands_->state().stop) {
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
    return OperatorStep{hands_->samples(*around_, dt), hands_->take_commands()};
}

}  // namespace rhexis::station
