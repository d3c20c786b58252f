// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/instructor.hpp"

#include <algorithm>

#include "base/near_names.hpp"
#include "base/numbers.hpp"

namespace rhexis::station {
namespace {

constexpr double close_mm = 1e-6;
constexpr std::size_t longest_note = 500;  ///< bytes

/// Whole letters of UTF-8 only.
std::string shortened(std::string text) {
    if (text.size() > longest_note) {
        std::size_t end = longest_note;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
            --end;
        }
        text.resize(end);
    }
    std::erase_if(text, [](char letter) { return static_cast<unsigned char>(letter) < 0x20U || letter == 0x7F; });
    return text;
}

void set_paused(bool paused, Hands& hands, const Surroundings& around) {
    if (hands.state().paused != paused) {
        hands.take({EventKind::control, control(ControlId::pause).name, 1.0}, around);
    }
}

}  // namespace

Result<Instructor> Instructor::create(ExerciseHost& host, bool has_microscope) {
    const Result<nlohmann::json> known = host.injections();
    if (!known) {
        return known.error();
    }
    Instructor instructor;
    instructor.host_ = &host;
    instructor.injector_ = Injector(injections_of(known.value(), has_microscope));
    instructor.levels_ = host.levels();
    return instructor;
}

void Instructor::heed(const UserEvent& event, Hands& hands, const Surroundings& around) {
    const std::string& what = event.name;
    if (what == "inject") {
        if (const Status begun = injector_.begin(event.control); !begun) {
            hands.tell(begun.error().text());
        }
    } else if (what == "put_right") {
        injector_.end(event.control);
    } else if (what == "level") {
        set_level(event.control, hands);
    } else if (what == "note") {
        commands_.push_back({CommandKind::note, "", 0.0, shortened(event.control)});
    } else if (what == "rewind") {
        rewind_s_ = std::max(0.0, event.value);
    } else if (what == "pause" || what == "go_on") {
        set_paused(what == "pause", hands, around);
    } else if (what == "warn") {
        hands.state().warns = event.value > 0.5;
    } else {
        hands.tell("the monitor asks for what this station does not know: " + shortened(what));
    }
}

/// What of it can change while the exercise runs; the rest begins with the next attempt.
void Instructor::set_level(const std::string& level, Hands& hands) {
    if (std::find(levels_.begin(), levels_.end(), level) == levels_.end()) {
        hands.tell("the exercise has no level " + shortened(level) + suggestion(level, levels_));
        return;
    }
    const Result<nlohmann::json> now = host_->level_now(level);
    if (!now) {
        hands.tell(now.error().text());
        return;
    }
    for (const auto& [name, value] : now.value().at("settings").items()) {
        commands_.push_back({CommandKind::inject, name, value.get<double>(), ""});
    }
    commands_.push_back({CommandKind::aid, "injected", 0.0, level});
    if (now.value().at("later") != 0) {
        hands.tell("some of this level begins with the next attempt only");
    }
}

std::vector<Command> Instructor::advance(double dt, const Session& session, Hands& hands) {
    const Vec3 before = injector_.head();
    std::vector<Command> commands = injector_.advance(dt, session.settings());
    head_way_ = injector_.head() - before;
    hands.shift(-head_way_);
    commands.insert(commands.end(), commands_.begin(), commands_.end());
    commands_.clear();
    for (const Command& command : commands) {
        if (command.kind == CommandKind::inject) {
            hands.turned_to(command.name, command.value);
        }
    }
    return commands;
}

void Instructor::move_microscope(const Surroundings& around, std::vector<DeviceSample>& samples) {
    if (const std::optional<Vec3> push = injector_.take_push(); push && around.microscope) {
        microscope_goal_ = *around.microscope + *push;
    }
    if (!around.microscope || samples.empty()) {
        return;
    }
    DeviceSample& sample = samples.back();
    if (microscope_goal_ && !sample.present) {  // it goes as fast as it can, unless its keys are held
        sample.pose.position = *microscope_goal_;
        sample.present = true;
        if ((*microscope_goal_ - *around.microscope).norm() < close_mm) {
            microscope_goal_.reset();
        }
    } else {
        microscope_goal_.reset();
    }
    if (!head_way_.isZero()) {
        sample.pose.position -= head_way_;
        sample.present = true;
    }
}

std::vector<TheatreInjection> Instructor::injections() const {
    std::vector<TheatreInjection> list;
    for (const Injection& one : injector_.known()) {
        list.push_back({one.id, one.title, injector_.runs(one.id)});
    }
    return list;
}

}  // namespace rhexis::station
