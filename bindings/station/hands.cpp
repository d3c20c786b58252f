// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/hands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "station/asked.hpp"
#include "station/wound_way.hpp"

namespace rhexis::station {
namespace {

constexpr double fastest_tip = 200.0;  ///< of a tip that follows a cursor [mm/s]
constexpr double zoom_per_s = 0.7;
constexpr double light_per_s = 0.6;
constexpr double least_zoom = 0.6;
constexpr double most_zoom = 3.0;
constexpr double least_light = 0.1;
constexpr double most_light = 2.0;

constexpr double edge_of_field_mm = 6.6;  ///< a little within it, at rest
constexpr double just_outside_mm = 0.5;

constexpr double fully_pushed = 0.98;  ///< of a stick: it may be held there
constexpr double stuck_after_s = 2.0;  ///< [s]
constexpr double down = 0.5;           ///< from which a button or trigger is pressed

/// Where it can be seen, on the way from a wound to a place farther out: no farther than the edge of the field, or than
/// just outside the wound.
Vec3 in_view(const Vec3& wound, const Vec3& place) {
    const double begin = wound.head<2>().norm();
    const double end = place.head<2>().norm();
    const double farthest = std::max(edge_of_field_mm, begin + just_outside_mm);
    return end > farthest ? Vec3(wound + (farthest - begin) / (end - begin) * (place - wound)) : place;
}

/// What keys and buttons do in the place of a hand.
bool is_of_hands(ControlId id) {
    return id == ControlId::depth || id == ControlId::swap || id == ControlId::next_instrument ||
           id == ControlId::put_down || id == ControlId::meet || id == ControlId::take_instrument;
}

double step_towards(double value, double goal, double most) { return value + std::clamp(goal - value, -most, most); }

}  // namespace

double pedal_of(double share, const Tuning& tuning) {
    if (share < tuning.pedal_first) {
        return 0.0;
    }
    if (share < tuning.pedal_second) {
        return 1.0;
    }
    if (share < tuning.pedal_third) {
        return 1.0 + (share - tuning.pedal_second) / (tuning.pedal_third - tuning.pedal_second);
    }
    return 2.0 + std::min(1.0, (share - tuning.pedal_third) / (1.0 - tuning.pedal_third));
}

double rate_of_stick(double value, const Tuning& tuning) {
    const double size = std::clamp((std::abs(value) - tuning.dead_zone) / (1.0 - tuning.dead_zone), 0.0, 1.0);
    return std::copysign(size * size, value);
}

Hands::Hands(HandsState state, const Stand& stand, HoldScript& holds)
    : stand_(&stand), holds_(&holds), state_(std::move(state)) {
    for (const StandInstrument& instrument : stand.instruments) {
        const Result<std::string> wound = holds.wound_of(instrument.name);
        wounds_.push_back(wound ? wound.value() : "incision");
    }
}

Hands::Hands(const Mapping& mapping, const Stand& stand, HoldScript& holds) : Hands(HandsState{}, stand, holds) {
    state_.mapping = std::make_shared<const Mapping>(mapping);
    for (const Dial& dial : stand.dials) {
        state_.dials.push_back(dial.value);
    }
}

/// Of those that such an instrument may go through the one that is nearest to its tip.
void Hands::choose_wound(const Surroundings& around, HandState& hand) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::string& name : wounds_like(wounds_[static_cast<std::size_t>(hand.instrument)])) {
        const std::optional<Vec3> place = landmark(around, name);
        const double distance = place ? (*place - hand.tip).head<2>().norm() : nearest;
        if (distance < nearest) {
            nearest = distance;
            hand.wound = name;
        }
    }
}

bool Hands::met() const {
    if (state_.tracked) {
        return state_.tracked->runs;
    }
    const HandState& hand = state_.hands[static_cast<std::size_t>(state_.moving)];
    return hand.instrument < 0 || !state_.cursor_moves || state_.cursor.has_value();
}

void Hands::lose() {
    state_.cursor.reset();
    if (state_.tracked) {
        state_.tracked->runs = false;
    }
}

double Hands::level(ControlId id) const {
    double sum = 0.0;
    for (const auto& [source, value] : state_.held) {
        const Binding* binding = mapping().find(source);
        if (binding != nullptr && binding->control->id == id) {
            sum += binding->sign * value;
        }
    }
    return std::clamp(sum, control(id).kind == ControlKind::rate ? -1.0 : 0.0, 1.0);
}

double Hands::speed_share() const { return level(ControlId::fine) > down ? mapping().tuning().fine : 1.0; }

void Hands::take(const UserEvent& given, const Surroundings& around) {
    if (!std::isfinite(given.value) || !std::isfinite(given.x) || !std::isfinite(given.y)) {
        return;  // a device that is broken
    }
    UserEvent event = given;
    switch (event.kind) {
        case EventKind::quit:
            state_.stop = true;
            break;
        case EventKind::focus:
        case EventKind::device:
            take_device(event);
            break;
        case EventKind::bind:
            rebind(event);
            break;
        case EventKind::control:
            if (const Control* chosen = find_control(event.name)) {
                press(chosen->id, event.value, around);
            }
            break;
        case EventKind::tracking:
            take_tracking(event);
            break;
        case EventKind::tracked:
            take_tracked(event, around);
            break;
        case EventKind::asked:
            take_asked(event.name);
            break;
        case EventKind::staff:
            break;  // of the instructor, not of these hands
        case EventKind::axis:
            event.value = std::clamp(event.value, -1.0, 1.0);
            take_input(event, around);
            break;
        default:
            take_input(event, around);
            break;
    }
}

/// The foot comes up and the clock stands where a device, or the keyboard, is lost.
void Hands::take_device(const UserEvent& event) {
    if (event.value >= down) {
        return;
    }
    const std::string prefix = event.kind == EventKind::device ? event.name + "." : "";
    std::erase_if(state_.held, [&](const auto& one) { return one.first.starts_with(prefix); });
    state_.pedal = 0.0;
    state_.pedal_goal.reset();
    state_.paused = true;
    lose();
    if (event.kind == EventKind::focus && event.name == "away") {
        tell("the computer was away for a moment: the clock stands");
    }
}

void Hands::rebind(const UserEvent& event) {
    Mapping changed = mapping();
    if (const Status bound = changed.rebind(event); !bound) {
        tell(bound.error().text());
        return;
    }
    state_.held.erase(event.name);  // what is down works nothing until it is pressed again
    state_.mapping = std::make_shared<const Mapping>(std::move(changed));
}

void Hands::take_input(const UserEvent& event, const Surroundings& around) {
    const std::string source = source_of(event);
    const Binding* binding = mapping().find(source);
    if (binding == nullptr) {
        return;
    }
    switch (binding->control->kind) {
        case ControlKind::place:
            follow_cursor({event.x, event.y}, around);
            break;
        case ControlKind::notch:
            if (event.kind == EventKind::wheel || event.value > down) {
                press(binding->control->id, binding->sign * (event.kind == EventKind::wheel ? event.value : 1.0),
                      around);
            }
            break;
        case ControlKind::press: {
            double& before = state_.held[source];
            if (before <= down && event.value > down) {
                press(binding->control->id, 1.0, around);
            }
            before = event.value;
            break;
        }
        case ControlKind::rate:
        case ControlKind::level:
            hold(source, *binding, event);
            break;
        case ControlKind::choice:
            break;  // of panels
    }
}

void Hands::hold(const std::string& source, const Binding& binding, const UserEvent& event) {
    const Tuning& tuning = mapping().tuning();
    const bool stick = event.kind == EventKind::axis && binding.control->kind == ControlKind::rate;
    const double key = !stick && moves_tip(binding.control->id) ? tuning.key_share : 1.0;
    state_.held[source] = stick ? rate_of_stick(event.value, tuning) : key * event.value;
    if (stick && std::abs(event.value) < fully_pushed) {
        state_.unmoved_s[source] = 0.0;
    } else {
        state_.unmoved_s.erase(source);
    }
    if (binding.control->id == ControlId::pedal) {
        const double travel = (event.value - tuning.pedal_rest) / (tuning.pedal_full - tuning.pedal_rest);
        state_.pedal_goal = pedal_of(std::clamp(travel, 0.0, 1.0), tuning);
    }
}

/// No hand holds a stick half way without the least trembling: it is worn, or stuck.
void Hands::let_go_of_stuck_sticks(double dt) {
    for (auto& [source, unmoved_s] : state_.unmoved_s) {
        unmoved_s += dt;
        double& pushed = state_.held[source];
        if (unmoved_s > stuck_after_s && pushed != 0.0) {
            pushed = 0.0;
            tell("a stick is stuck: it counts as let go until it moves");
        }
    }
}

/// The cursor leads: the tip goes as far as it does, from where they met.
void Hands::follow_cursor(const Cursor& cursor, const Surroundings& around) {
    if (state_.tracked) {
        return;
    }
    HandState& hand = state_.hands[static_cast<std::size_t>(state_.moving)];
    state_.cursor_moves = true;
    state_.last_cursor = cursor;
    if (hand.instrument < 0 || state_.paused) {
        return;  // it chooses from panels
    }
    if (!state_.cursor) {
        const Vec3 place = around.sight.under(cursor, hand.tip.z(), hand.inside);
        if ((place - hand.tip).head<2>().norm() <= meets_within) {
            state_.cursor = cursor;
        }
        return;
    }
    const double share = speed_share();
    const Vec3 from = around.sight.under(*state_.cursor, hand.tip.z(), hand.inside);
    const Vec3 to = around.sight.under(cursor, hand.tip.z(), hand.inside);
    hand.wanted.head<2>() += share * (to - from).head<2>();
    state_.cursor = cursor;
}

void Hands::press(ControlId id, double notches, const Surroundings& around) {
    if (state_.tracked && is_of_hands(id)) {
        return;  // it is seen what they hold, and where
    }
    HandState& hand = state_.hands[static_cast<std::size_t>(state_.moving)];
    const int dials = static_cast<int>(stand_->dials.size());
    const int requests = static_cast<int>(stand_->requests.size());
    switch (id) {
        case ControlId::depth:
            hand.wanted.z() += state_.paused ? 0.0 : notches * speed_share() * mapping().tuning().notch_mm;
            break;
        case ControlId::swap:
            state_.moving = 1 - state_.moving;
            lose();
            break;
        case ControlId::next_instrument:
            next_instrument(around);
            break;
        case ControlId::put_down:
            put_down(state_.moving);
            break;
        case ControlId::meet:
            state_.cursor = state_.last_cursor;
            break;
        case ControlId::pedal_up:
        case ControlId::pedal_1:
        case ControlId::pedal_2:
        case ControlId::pedal_3:
            state_.pedal_goal = static_cast<double>(id) - static_cast<double>(ControlId::pedal_up);
            break;
        case ControlId::dial_next:
            state_.dial = dials > 0 ? (state_.dial + 1) % dials : 0;
            break;
        case ControlId::dial_turn:
            if (dials > 0) {
                turn_dial(state_.dial, notches);
            }
            break;
        case ControlId::request_next:
            state_.request = requests > 0 ? (state_.request + 1) % requests : 0;
            break;
        case ControlId::request:
            if (requests > 0) {
                state_.requests.push_back(state_.request);
            }
            break;
        case ControlId::pause:
            state_.paused = !state_.paused;
            lose();
            break;
        case ControlId::keep_moment:
            state_.keep_moment = true;
            break;
        case ControlId::try_again:
            state_.try_again = true;
            break;
        case ControlId::ghost:
            state_.ghost = !state_.ghost;
            break;
        case ControlId::warnings:
            state_.warns = !state_.warns;
            break;
        case ControlId::help:
            state_.help = !state_.help;
            break;
        case ControlId::stop:
            state_.stop = true;
            break;
        case ControlId::take_instrument:
        case ControlId::choose_dial:
        case ControlId::choose_request:
            choose(id, notches, around);
            break;
        default:
            break;
    }
}

/// Of a list, by its number; what is on none of them is not chosen.
void Hands::choose(ControlId id, double number, const Surroundings& around) {
    const std::size_t count = id == ControlId::take_instrument ? stand_->instruments.size()
                              : id == ControlId::choose_dial   ? stand_->dials.size()
                                                               : stand_->requests.size();
    if (!(number >= 0.0 && number < static_cast<double>(count))) {
        return;
    }
    const int chosen = static_cast<int>(number);
    if (id == ControlId::choose_dial) {
        state_.dial = chosen;
    } else if (id == ControlId::choose_request) {
        state_.request = chosen;
    } else {
        take_instrument(chosen, around);
    }
}

void Hands::shift(const Vec3& way) {
    for (HandState& hand : state_.hands) {
        hand.tip += way;
        hand.wanted += way;
    }
    if (state_.tracked) {
        state_.tracked->shift += way;
    }
}

void Hands::turned_to(const std::string& setting, double value) {
    for (std::size_t i = 0; i < stand_->dials.size(); ++i) {
        if (stand_->dials[i].setting == setting) {
            state_.dials[i] = value;
        }
    }
}

void Hands::turn_dial(int which, double notches) {
    const Dial& dial = stand_->dials[static_cast<std::size_t>(which)];
    double& value = state_.dials[static_cast<std::size_t>(which)];
    const double turned = std::round((value + notches * dial.notch) / dial.notch) * dial.notch;
    value = std::clamp(turned, dial.low, dial.high);
    note_turned(which);
}

void Hands::note_turned(int which) {
    if (std::find(state_.turned.begin(), state_.turned.end(), which) == state_.turned.end()) {
        state_.turned.push_back(which);
    }
}

/// Not by these hands, but as they would ask for it.
void Hands::take_asked(const std::string& text) {
    const Result<Asked> asked = what_is_asked(*stand_, text);
    if (!asked) {
        tell(asked.error().text());
    } else if (asked.value().request >= 0) {
        state_.requests.push_back(asked.value().request);
    } else {
        state_.dials[static_cast<std::size_t>(asked.value().dial)] = asked.value().value;
        note_turned(asked.value().dial);
    }
}

void Hands::take_up(int which, int instrument, const Surroundings& around) {
    HandState& hand = state_.hands[static_cast<std::size_t>(which)];
    hand = HandState{};
    hand.instrument = instrument;
    hand.wound = wounds_[static_cast<std::size_t>(instrument)];
    if (which == other && hand.wound == "incision" && landmark(around, "side_port")) {
        hand.wound = "side_port";
    }
    const Vec3 wound = landmark(around, hand.wound).value_or(Vec3(0.0, -6.0, 2.0));
    const Result<Vec3> place = holds_->outside(wound);
    hand.tip = hand.wanted = in_view(wound, place ? place.value() : Vec3(0.0, -8.0, 3.0));
    hand.jaw = stand_->instruments[static_cast<std::size_t>(instrument)].squeeze == Squeeze::closes ? 1.0 : 0.0;
    lose();
}

void Hands::put_down(int which) {
    HandState& hand = state_.hands[static_cast<std::size_t>(which)];
    if (hand.instrument >= 0 && hand.inside) {
        tell("first out of the eye, then put it down");
        return;
    }
    hand = HandState{};
}

/// False: it cannot be taken now.
bool Hands::take_instrument(int instrument, const Surroundings& around) {
    const HandState& hand = state_.hands[static_cast<std::size_t>(state_.moving)];
    if (hand.inside) {
        tell("first out of the eye, then another instrument");
        return false;
    }
    const bool elsewhere = state_.hands[static_cast<std::size_t>(1 - state_.moving)].instrument == instrument;
    if (elsewhere || !stand_->instruments[static_cast<std::size_t>(instrument)].hand_held) {
        return false;
    }
    take_up(state_.moving, instrument, around);
    return true;
}

void Hands::next_instrument(const Surroundings& around) {
    const HandState& hand = state_.hands[static_cast<std::size_t>(state_.moving)];
    const int now = hand.instrument;
    const int count = static_cast<int>(stand_->instruments.size());
    for (int i = 1; i <= count; ++i) {
        if (take_instrument((now + i + count) % count, around) || hand.inside) {
            return;
        }
    }
}

void Hands::squeeze(int which, double dt) {
    HandState& hand = state_.hands[static_cast<std::size_t>(which)];
    const StandInstrument& instrument = stand_->instruments[static_cast<std::size_t>(hand.instrument)];
    double pressed = level(which == leading ? ControlId::leading_squeeze : ControlId::other_squeeze);
    double drawn = 0.0;
    if (which == state_.moving) {
        pressed = std::max(pressed, level(ControlId::squeeze));
        drawn = level(ControlId::draw_back);
    }
    const double most = instrument.squeeze_per_s * speed_share() * dt;
    switch (instrument.squeeze) {
        case Squeeze::closes:
            hand.jaw = step_towards(hand.jaw, 1.0 - pressed, most);
            break;
        case Squeeze::presses:
            hand.jaw = step_towards(hand.jaw, pressed, most);
            break;
        case Squeeze::pushes:
            hand.jaw = std::clamp(hand.jaw + (pressed - drawn) * most, 0.0, 1.0);
            break;
        case Squeeze::nothing:
            break;
    }
}

Status Hands::move(int which, const Surroundings& around, double dt) {
    HandState& hand = state_.hands[static_cast<std::size_t>(which)];
    if (hand.instrument < 0 || state_.tracked) {
        return success();
    }
    const bool first = which == leading;
    const bool moves = which == state_.moving;
    const auto rate = [&](ControlId own, ControlId of_other, ControlId of_moving) {
        return std::clamp(level(first ? own : of_other) + (moves ? level(of_moving) : 0.0), -1.0, 1.0);
    };
    const double share = speed_share();
    const double way = share * mapping().tuning().tip_mm_s * dt;
    hand.wanted += way * Vec3(rate(ControlId::leading_x, ControlId::other_x, ControlId::hand_x),
                              rate(ControlId::leading_y, ControlId::other_y, ControlId::hand_y),
                              rate(ControlId::leading_z, ControlId::other_z, ControlId::hand_z));
    hand.roll += share * mapping().tuning().roll_deg_s * dt *
                 rate(ControlId::leading_roll, ControlId::other_roll, ControlId::hand_roll);
    squeeze(which, dt);
    if (!hand.inside) {
        choose_wound(around, hand);
    }
    const std::optional<Vec3> wound = landmark(around, hand.wound);
    if (wound && leads_inside(hand.wound)) {
        const Result<Vec3> way_out = holds_->way_out(*wound);
        if (!way_out) {
            return way_out.error();
        }
        keep_to_way(*wound, way_out.value(), dt, hand);
    }
    const Vec3 left = hand.wanted - hand.tip;
    const double longest = fastest_tip * dt;
    hand.tip += left.norm() > longest ? Vec3(longest * left.normalized()) : left;
    const Result<Quat> orientation = holds_->orientation(tool_name(hand.instrument), wound, hand.tip, hand.roll);
    if (!orientation) {
        return orientation.error();
    }
    hand.orientation = orientation.value();
    return success();
}

void Hands::press_pedal(double dt) {
    const double travel = level(ControlId::pedal_travel);
    if (travel != 0.0) {
        state_.pedal_goal.reset();
        state_.pedal += travel * speed_share() * mapping().tuning().pedal_per_s * dt;
    } else if (state_.pedal_goal) {
        state_.pedal = step_towards(state_.pedal, *state_.pedal_goal, foot_per_s * dt);
    }
    state_.pedal = std::clamp(state_.pedal, 0.0, 3.0);
}

void Hands::tell(const std::string& word) {
    constexpr double shown_s = 4.0;
    state_.word = word;
    state_.word_for_s = shown_s;
}

Status Hands::advance(const Surroundings& around, double dt) {
    state_.word_for_s -= dt;
    if (state_.word_for_s <= 0.0) {
        state_.word.clear();
    }
    let_go_of_stuck_sticks(dt);
    press_pedal(dt);
    state_.zoom =
        std::clamp(state_.zoom * std::exp(level(ControlId::microscope_zoom) * zoom_per_s * dt), least_zoom, most_zoom);
    state_.light =
        std::clamp(state_.light + level(ControlId::microscope_light) * light_per_s * dt, least_light, most_light);
    for (const int which : {leading, other}) {
        if (Status moved = move(which, around, dt); !moved) {
            return moved;
        }
    }
    return success();
}

}  // namespace rhexis::station
