// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/fingers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace rhexis::station {
namespace {

constexpr double pad_range = 32767.0;
constexpr double same_mm = 1e-3;
constexpr double most_notches = 20.0;  ///< at once

/// Of a monotonic function on 0 to 1, the place where it has this value.
template <typename Function>
double inverse_of(const Function& function, double value) {
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (function(middle) < value ? low : high) = middle;
    }
    return high;
}

/// As fine as an axis is.
double grained(double value) { return std::round(value * pad_range) / pad_range; }

}  // namespace

/// One step's work: events, and the hands as they make them.
struct Fingers::Work {
    const Fingers& fingers;
    const Stand& stand;
    const Surroundings& around;
    double dt;
    double pedal_before;  ///< goal of the step before
    Hands hands;
    std::vector<UserEvent> events{};

    void emit(UserEvent event) {
        hands.take(event, around);
        events.push_back(std::move(event));
    }

    [[nodiscard]] const HandState& hand(int which) const {
        return hands.state().hands[static_cast<std::size_t>(which)];
    }

    /// An event of this source.
    static UserEvent event_of(const std::string& source, double value) {
        const std::size_t dot = source.find('.');
        const std::string device = source.substr(0, dot);
        const std::string name = source.substr(dot + 1);
        if (device == "key") {
            return {EventKind::key, name, value, 0.0, 0.0};
        }
        if (device == "mouse") {
            return {EventKind::button, name, value, 0.0, 0.0};
        }
        return {is_axis(source) ? EventKind::axis : EventKind::press, source, value, 0.0, 0.0};
    }

    static bool is_axis(const std::string& source) {
        constexpr std::array axes = {"pad.leftx",       "pad.lefty",        "pad.rightx", "pad.righty",
                                     "pad.lefttrigger", "pad.righttrigger", "pedal.0"};
        return std::find(axes.begin(), axes.end(), source) != axes.end();
    }

    /// What works a control in this direction, of the style's own devices first. Empty: nothing does.
    [[nodiscard]] std::string source_of(ControlId id, double sign, bool axes) const {
        std::string found;
        for (const auto& [source, binding] : hands.mapping().bindings()) {
            if (binding.control->id != id || source == "mouse.move" || source == "mouse.wheel" ||
                is_axis(source) != axes || (!axes && binding.sign * sign < 0.0)) {
                continue;
            }
            const bool of_style = (fingers.style_ == Style::pad) == source.starts_with("p");
            if (found.empty() || of_style) {
                found = source;
            }
        }
        return found;
    }

    void set(const std::string& source, double value) {
        const auto before = hands.state().held.find(source);
        const double was = before == hands.state().held.end() ? 0.0 : before->second;
        if (was != 0.0 || value != 0.0) {
            emit(event_of(source, value));
        }
    }

    void press(ControlId id) {
        const std::string source = source_of(id, 1.0, false);
        if (!source.empty()) {
            emit(event_of(source, 1.0));
            emit(event_of(source, 0.0));
        }
    }

    /// A rate, as a share of the fastest: by an axis as it is, by keys on or off.
    void rate(ControlId id, double share) {
        const Tuning& tuning = hands.mapping().tuning();
        const std::string axis = source_of(id, 1.0, true);
        if (fingers.style_ == Style::pad && !axis.empty()) {
            const double size = std::min(1.0, std::abs(share));
            const double push =
                size == 0.0 ? 0.0 : inverse_of([&](double v) { return rate_of_stick(v, tuning); }, size);
            const double sign = hands.mapping().find(axis)->sign;
            set(axis, grained(sign * std::copysign(push, share)));
            return;
        }
        const double step = moves_tip(id) ? tuning.key_share : 1.0;
        for (const double sign : {1.0, -1.0}) {
            const std::string key = source_of(id, sign, false);
            if (!key.empty()) {
                set(key, sign * share > 0.5 * step ? 1.0 : 0.0);
            }
        }
    }

    void level(ControlId id, double value) {
        const std::string axis = source_of(id, 1.0, true);
        if (fingers.style_ == Style::pad && !axis.empty()) {
            set(axis, grained(value));
        } else if (const std::string key = source_of(id, 1.0, false); !key.empty()) {
            set(key, value > 0.5 ? 1.0 : 0.0);
        }
    }

    void move_with(int which) {
        if (hands.state().moving != which) {
            press(ControlId::swap);
        }
    }

    void take_instrument(int which, int instrument) {
        move_with(which);
        for (std::size_t i = 0; i < stand.instruments.size() && hand(which).instrument != instrument; ++i) {
            press(ControlId::next_instrument);
        }
    }

    /// Which hand is to hold which of the instruments that are wanted.
    void exchange(const std::vector<DeviceSample>& samples) {
        for (const int which : {leading, other}) {
            const int now = hand(which).instrument;
            if (now >= 0 && !samples[static_cast<std::size_t>(now)].present) {
                move_with(which);
                press(ControlId::put_down);
            }
        }
        for (const DeviceSample& sample : samples) {
            const bool wanted =
                sample.present && stand.instruments[static_cast<std::size_t>(sample.instrument)].hand_held;
            if (!wanted || hand(leading).instrument == sample.instrument ||
                hand(other).instrument == sample.instrument) {
                continue;
            }
            const int first = hands.through_side_port(sample.instrument) ? other : leading;
            const int which = hand(first).instrument < 0 ? first : 1 - first;
            if (hand(which).instrument < 0) {
                take_instrument(which, sample.instrument);
            }
        }
    }

    /// The cursor's pixel nearest to a place.
    [[nodiscard]] Cursor grained_cursor(const Cursor& cursor) const {
        const double h = fingers.height_;
        const double w = fingers.width_;
        return {(std::round(cursor.x() * h + 0.5 * w - 0.5) + 0.5 - 0.5 * w) / h,
                (0.5 * h - std::round(0.5 * h - 0.5 - cursor.y() * h) - 0.5) / h};
    }

    void point(int which, const Vec3& goal) {
        move_with(which);
        if (!hands.state().cursor) {
            press(ControlId::meet);
        }
        point_coarsely(which, goal, 1.0);
        if (!fingers.finely_) {
            return;
        }
        level(ControlId::fine, 1.0);
        point_coarsely(which, goal, hands.mapping().tuning().fine);
        level(ControlId::fine, 0.0);
    }

    /// As near as a pixel and a notch get, of which each moves this share of its way.
    void point_coarsely(int which, const Vec3& goal, double share) {
        const HandState& now = hand(which);
        if (hands.state().cursor && (goal - now.wanted).head<2>().norm() > same_mm) {
            const Vec3 from = around.sight.under(*hands.state().cursor, now.tip.z(), now.inside);
            Vec3 to = from;
            to.head<2>() += (goal - now.wanted).head<2>() / share;
            const Cursor cursor = grained_cursor(around.sight.cursor_on(to, now.inside));
            emit({EventKind::pointer, "", 0.0, cursor.x(), cursor.y()});
        }
        const double notch = share * hands.mapping().tuning().notch_mm;
        const double notches = std::round((goal.z() - hand(which).wanted.z()) / notch);
        if (notches != 0.0) {
            emit({EventKind::wheel, "", std::clamp(notches, -most_notches, most_notches), 0.0, 0.0});
        }
    }

    void steer(int which, const Vec3& goal) {
        move_with(which);
        const Vec3 left = (goal - hand(which).wanted) / (hands.mapping().tuning().tip_mm_s * dt);
        rate(ControlId::hand_x, left.x());
        rate(ControlId::hand_y, left.y());
        rate(ControlId::hand_z, left.z());
    }

    /// With mouse and keys the other hand has keys of its own, and the leading one is moved last, so that buttons are
    /// its.
    [[nodiscard]] ControlId of_hand(int which, ControlId moving, ControlId of_other) const {
        return which == other && fingers.style_ == Style::mouse ? of_other : moving;
    }

    void let_go(int which) {
        level(of_hand(which, ControlId::squeeze, ControlId::other_squeeze), 0.0);
        rate(of_hand(which, ControlId::hand_roll, ControlId::other_roll), 0.0);
        if (which == leading) {
            level(ControlId::draw_back, 0.0);
        }
    }

    /// How much there is to do for a hand, of two of which sticks move one at a time [mm].
    [[nodiscard]] double need(int which, const DeviceSample& sample) const {
        constexpr double squeezing_mm = 0.5;
        const HandState& now = hand(which);
        const Squeeze how = stand.instruments[static_cast<std::size_t>(now.instrument)].squeeze;
        const double at_rest = how == Squeeze::closes ? 1.0 : how == Squeeze::presses ? 0.0 : now.jaw;
        return (sample.pose.position - now.wanted).norm() +
               (std::abs(sample.jaw - at_rest) > 0.01 ? squeezing_mm : 0.0);
    }

    void squeeze(int which, double jaw) {
        const ControlId presses = of_hand(which, ControlId::squeeze, ControlId::other_squeeze);
        const HandState& now = hand(which);
        const StandInstrument& instrument = stand.instruments[static_cast<std::size_t>(now.instrument)];
        const double error = jaw - now.jaw;
        const double step = instrument.squeeze_per_s * dt;
        switch (instrument.squeeze) {
            case Squeeze::closes:
            case Squeeze::presses: {
                const double wanted = instrument.squeeze == Squeeze::closes ? 1.0 - jaw : jaw;
                const double up = instrument.squeeze == Squeeze::closes ? -error : error;
                level(presses, fingers.style_ == Style::pad ? wanted : up > -0.5 * step && wanted > 0.0 ? 1.0 : 0.0);
                break;
            }
            case Squeeze::pushes:
                level(presses, std::clamp(error / step, 0.0, 1.0));
                level(ControlId::draw_back, std::clamp(-error / step, 0.0, 1.0));
                break;
            case Squeeze::nothing:
                break;
        }
    }

    void roll(int which, const DeviceSample& sample) {
        const HandState& now = hand(which);
        const Quat turn = now.orientation.conjugate() * sample.pose.orientation;
        const double degrees = 2.0 * std::atan2(turn.z(), turn.w()) * 180.0 / std::numbers::pi;
        const double wrapped = std::remainder(degrees, 360.0);
        rate(of_hand(which, ControlId::hand_roll, ControlId::other_roll),
             wrapped / (hands.mapping().tuning().roll_deg_s * dt));
    }

    void press_pedal(double goal) {
        const Tuning& tuning = hands.mapping().tuning();
        const std::string axis = source_of(ControlId::pedal, 1.0, true);
        if (fingers.style_ == Style::pad && !axis.empty()) {
            double share = 0.0;
            if (goal > 1.0) {
                share = inverse_of([&](double v) { return pedal_of(v, tuning); }, std::min(goal, 3.0));
            } else if (goal > 0.0) {
                share = 0.5 * (tuning.pedal_first + tuning.pedal_second);
            }
            const double value = grained(tuning.pedal_rest + share * (tuning.pedal_full - tuning.pedal_rest));
            if (!hands.state().pedal_goal || std::abs(*hands.state().pedal_goal - goal) > same_mm) {
                emit(event_of(axis, value));
            }
            return;
        }
        const double error = goal - hands.state().pedal;
        const double whole = error > 0.0 ? std::ceil(goal - 1e-9) : std::floor(goal + 1e-9);
        const bool at_detent = std::abs(goal - std::round(goal)) < 1e-9;
        const bool on_its_way = std::abs(goal - pedal_before) > 0.5 * foot_per_s * dt;
        if ((at_detent || on_its_way || std::abs(error) > 0.3) && std::abs(error) > 1e-9) {
            rate(ControlId::pedal_travel, 0.0);
            const auto id = static_cast<ControlId>(static_cast<int>(ControlId::pedal_up) + static_cast<int>(whole));
            if (hands.state().pedal_goal != whole) {
                press(id);
            }
            return;
        }
        if (hands.state().pedal_goal && *hands.state().pedal_goal == hands.state().pedal && std::abs(error) < 1e-9) {
            return;
        }
        rate(ControlId::pedal_travel, error / (tuning.pedal_per_s * dt));
    }

    void move_microscope(const DeviceSample& sample) {
        Vec3 way = Vec3::Zero();
        if (sample.present && around.microscope) {
            way = sample.pose.position - *around.microscope;
        }
        const auto share = [&](double mm) {
            return std::abs(mm) < 0.5 * microscope_mm_s * dt ? 0.0 : std::copysign(1.0, mm);
        };
        rate(ControlId::microscope_x, share(way.x()));
        rate(ControlId::microscope_y, share(way.y()));
        rate(ControlId::microscope_focus, share(way.z()));
    }

    void ask(const std::vector<Command>& commands) {
        for (const Command& command : commands) {
            const auto found = std::find_if(stand.requests.begin(), stand.requests.end(),
                                            [&](const Request& request) { return request.id == command.name; });
            if (command.kind != CommandKind::request || found == stand.requests.end()) {
                continue;
            }
            while (hands.state().request != found - stand.requests.begin()) {
                press(ControlId::request_next);
            }
            press(ControlId::request);
        }
    }
};

std::vector<UserEvent> Fingers::reach(const Hands& now, const Stand& stand, const std::vector<DeviceSample>& samples,
                                      const std::vector<Command>& commands, const Surroundings& around, double dt) {
    Work work{*this, stand, around, dt, pedal_before_, now};
    work.exchange(samples);
    work.ask(commands);
    double pedal = 0.0;
    std::vector<int> busy;
    for (const int which : {other, leading}) {
        const int instrument = work.hand(which).instrument;
        const bool works = instrument >= 0 && samples[static_cast<std::size_t>(instrument)].present;
        if (works) {
            busy.push_back(which);
            pedal = std::max(pedal, samples[static_cast<std::size_t>(instrument)].pedal);
        } else {
            work.let_go(which);
        }
    }
    const auto sample_of = [&](int which) -> const DeviceSample& {
        return samples[static_cast<std::size_t>(work.hand(which).instrument)];
    };
    // the sticks move one hand at a time; a cursor moves one after the other in no time
    if (style_ == Style::pad && busy.size() > 1) {
        const double difference = work.need(other, sample_of(other)) - work.need(leading, sample_of(leading));
        busy = {difference > 0.0 ? other : leading};
    }
    for (const int which : busy) {
        const DeviceSample& sample = sample_of(which);
        if (style_ == Style::mouse) {
            work.point(which, sample.pose.position);
        } else {
            work.steer(which, sample.pose.position);
        }
        work.squeeze(which, sample.jaw);
        work.roll(which, sample);
    }
    work.press_pedal(pedal);
    pedal_before_ = pedal;
    if (around.microscope) {
        work.move_microscope(samples.back());
    }
    if (work.hands.waits() && !work.hands.state().paused) {
        work.press(ControlId::meet);
    }
    return std::move(work.events);
}

}  // namespace rhexis::station
