// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/event_source.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "base/clock.hpp"
#include "trial/places.hpp"

namespace rhexis::station {
namespace {

constexpr double may_catch_up_s = 0.05;  ///< what runs later than that slows the clock
constexpr double away_s = 0.5;           ///< without running, after which the clock stands
constexpr double smoothing = 0.02;       ///< of the rate that is shown
constexpr double bears_steal = 0.01;     ///< share of a second, of one core
constexpr const char* version = "rhexis_events";

/// That other machines had this one's cores for; 0 where the system does not say.
double stolen_seconds() {
    std::ifstream stat("/proc/stat");
    std::string name;
    double value = 0.0;
    stat >> name;
    for (int i = 0; i < 8 && stat >> value; ++i) {
    }
    return stat ? value / static_cast<double>(::sysconf(_SC_CLK_TCK)) : 0.0;
}

}  // namespace

Result<std::vector<UserEvent>> WallClock::take(std::uint64_t, bool waits, const Hands&, const Surroundings&,
                                               const Session&) {
    const double now = wall_seconds();
    bool away = was_away(now);
    if (waits) {
        desk_.wait_for_event(now + looks_every_s_);
        now_s_ = wall_seconds();
        away = away || now_s_ - now > looks_every_s_ + away_s;
        due_s_ = 0.0;
    } else {
        const double begun = due_s_ == 0.0 || away ? now : due_s_;
        const double late = now - begun;
        if (late < 0.0) {
            std::this_thread::sleep_for(std::chrono::duration<double>(-late));
            away = wall_seconds() - begun > away_s;
        }
        const double lost = late > may_catch_up_s ? late - may_catch_up_s : 0.0;
        now_s_ = begun + lost;
        due_s_ = now_s_ + step_s_;
        note(std::max(0.0, late), lost);
        slowed_ += smoothing * (step_s_ / (step_s_ + lost) - slowed_);
    }
    std::vector<UserEvent> events;
    if (away) {
        events.push_back({EventKind::focus, "away"});
        due_s_ = 0.0;  // not caught up, and nobody's slow clock
    }
    for (PostedEvent& posted : desk_.take()) {
        number_ = posted.number;
        events.push_back(std::move(posted.event));
    }
    left_s_ = wall_seconds();
    left_cpu_s_ = process_cpu_seconds();
    return events;
}

/// A process that was suspended, or that others kept from running: a step that only takes long is not that.
bool WallClock::was_away(double now) const {
    return left_s_ > 0.0 && now - left_s_ - (process_cpu_seconds() - left_cpu_s_) > away_s;
}

void WallClock::note(double late_s, double lost_s) {
    this_second_.push_back(static_cast<float>(late_s / step_s_));
    lost_this_second_s_ += lost_s;
    const double now = wall_seconds();
    if (now - second_began_s_ < 1.0) {
        return;
    }
    const double stolen = stolen_seconds();
    if (second_began_s_ > 0.0 && stolen - stolen_before_s_ > bears_steal * (now - second_began_s_)) {
        ++steal_s_;
    } else {
        late_steps_.insert(late_steps_.end(), this_second_.begin(), this_second_.end());
        lost_s_ += lost_this_second_s_;
    }
    this_second_.clear();
    lost_this_second_s_ = 0.0;
    second_began_s_ = now;
    stolen_before_s_ = stolen;
}

std::optional<Pace> WallClock::pace() const {
    std::vector<float> sorted = late_steps_;
    std::sort(sorted.begin(), sorted.end());
    const double run_s = static_cast<double>(sorted.size()) * step_s_;
    const auto at = [&](double share) {
        return sorted.empty() ? 0.0F : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    };
    return Pace{at(0.999), run_s > 0.0 ? lost_s_ / (run_s + lost_s_) : 0.0, steal_s_, 0.0};
}

Result<EventFile> read_events(const std::string& path) {
    const Result<std::string> text = read_whole_file(path);
    if (!text) {
        return text.error();
    }
    EventFile file;
    std::uint64_t before = 0;
    int number = 0;
    std::size_t at = 0;
    while (at < text.value().size()) {
        const std::size_t end = std::min(text.value().find('\n', at), text.value().size());
        const std::string line = text.value().substr(at, end - at);
        at = end + 1;
        ++number;
        const std::string where = path + ":" + std::to_string(number);
        const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
        if (!json.is_object()) {
            return Error{"this line is no JSON object", where, "a file that rhexis train --events wrote"};
        }
        if (number == 1) {
            if (json.value(version, nlohmann::json()) != 1) {
                return Error{"these are no events, or of another version", where, R"({"rhexis_events":1, ...})"};
            }
            file.header = json;
            continue;
        }
        const nlohmann::json step = json.value("step", nlohmann::json());
        const Result<UserEvent> event = event_from(json);
        if (!event || !step.is_number_unsigned() || step.get<std::uint64_t>() < before) {
            Error error = event ? Error{"the step " + step.dump(), "", "a whole number, none below the line before"}
                                : event.error();
            error.where = where;
            return error;
        }
        before = step.get<std::uint64_t>();
        file.lines.push_back({before, event.value()});
    }
    if (number == 0) {
        return Error{"the file is empty", path, "a file that rhexis train --events wrote"};
    }
    return file;
}

Result<EventWriter> EventWriter::create(const std::string& path, const nlohmann::json& header) {
    Result<OutputFile> file = OutputFile::create(path);
    if (!file) {
        return file.error();
    }
    nlohmann::json first = header;
    first[version] = 1;
    EventWriter writer(std::move(file).value());
    const Status begun = writer.file_.write(first.dump() + "\n");
    return begun ? Result<EventWriter>(std::move(writer)) : begun.error();
}

Status EventWriter::add(std::uint64_t step, const UserEvent& event) {
    nlohmann::json line = to_json(event);
    line["step"] = step;
    return file_.write(line.dump() + "\n");
}

Result<std::vector<UserEvent>> Steps::take(std::uint64_t step, bool waits, const Hands&, const Surroundings&,
                                           const Session&) {
    std::vector<UserEvent> events;
    while (next_ < file_.lines.size() && file_.lines[next_].step <= step) {
        events.push_back(file_.lines[next_++].event);
    }
    if (events.empty() && waits) {
        next_ = file_.lines.size();  // nothing of this step will end the wait
    }
    return events;
}

}  // namespace rhexis::station
