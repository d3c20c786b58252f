// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/tracking_link.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "base/clock.hpp"
#include "base/numbers.hpp"
#include "cli/command.hpp"
#include "input/pose_track.hpp"
#include "nlohmann/json.hpp"
#include "station/asked.hpp"

namespace rhexis::cli {
namespace {

std::int64_t time_of_day_us() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::microseconds>(since).count();
}

constexpr double longest_step_mm = 2.0;      ///< of a hand between two steps of a recording
constexpr std::size_t longest_words = 1000;  ///< that are asked: a recording may be anybody's

void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

/// Kind and value of a report.
struct ReportLine {
    nlohmann::json& line;
    void operator()(const PoseReport& pose) const {
        line["kind"] = "pose";
        line["sensor"] = pose.sensor;
        line["position_mm"] = {pose.position.x(), pose.position.y(), pose.position.z()};
        line["quaternion_xyzw"] = {pose.turned.x(), pose.turned.y(), pose.turned.z(), pose.turned.w()};
    }
    void operator()(const VelocityReport& velocity) const {
        line["kind"] = "velocity";
        line["sensor"] = velocity.sensor;
        line["mm_per_s"] = {velocity.velocity.x(), velocity.velocity.y(), velocity.velocity.z()};
    }
    void operator()(const ButtonReport& button) const {
        line["kind"] = "button";
        line["button"] = button.button;
        line["down"] = button.down;
    }
    void operator()(const std::vector<bool>& buttons) const {
        line["kind"] = "buttons";
        line["down"] = buttons;
    }
    void operator()(const std::vector<double>& channels) const {
        line["kind"] = "analog";
        line["channels"] = channels;
    }
    void operator()(const TextReport& text) const {
        line["kind"] = "text";
        line["text"] = text.text;
    }
};

void print(const DeviceReport& report, bool as_json) {
    nlohmann::json line{{"device", report.device},
                        {"time_s", 1e-6 * static_cast<double>(report.time_us)},
                        {"by", report.by_datagram ? "udp" : "tcp"}};
    std::visit(ReportLine{line}, report.what);
    if (as_json) {
        std::printf("%s\n", line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
        return;
    }
    std::printf("%.3f %s %s", line["time_s"].get<double>(), report.device.c_str(),
                line["kind"].get<std::string>().c_str());
    for (const auto& [name, value] : line.items()) {
        if (name != "time_s" && name != "device" && name != "kind") {
            std::printf(" %s=%s", name.c_str(),
                        value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
        }
    }
    std::printf("\n");
}

void turn(const Teller& teller) {
    teller.turn(wall_seconds(), time_of_day_us());
    for (const std::string& note : teller.take_notes()) {
        std::fprintf(stderr, "rhexis: a listener: %s\n", note.c_str());
    }
    wait_a_little();
}

/// Until listeners know what the numbers mean, or have the last of them.
void linger(const Teller& teller) {
    constexpr double enough_s = 0.2;
    for (const double begun_s = wall_seconds(); wall_seconds() - begun_s < enough_s;) {
        turn(teller);
    }
}

/// A virtual surgeon may be elsewhere from one step to the next, outside the eye; a hand is on its way for that. Fills
/// the steps before such a leap with the way there.
void without_leaps(std::size_t instrument, std::vector<SeenStep>& seen) {
    const auto at = [&](std::size_t step) -> DeviceSample& { return *seen[step].instruments[instrument]; };
    for (std::size_t step = 1; step < seen.size(); ++step) {
        const double way_mm = (at(step).pose.position - at(step - 1).pose.position).norm();
        const auto steps = std::min(step, static_cast<std::size_t>(std::ceil(way_mm / longest_step_mm)));
        if (!at(step - 1).present || !at(step).present || steps < 2) {
            continue;
        }
        const Pose from = at(step - steps).pose;
        for (std::size_t i = 1; i < steps; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(steps);
            at(step - steps + i).pose = between(from, at(step).pose, share);
        }
    }
}

/// What cameras would see of a recording. An instrument that is not used yet lies where it will be taken up, and one
/// that is used no more where it was put down.
std::vector<SeenStep> as_seen(const Recording& recording) {
    std::vector<DeviceSample> now(recording.header.scene.instruments.size());
    std::vector<SeenStep> seen;
    for (const RecordedStep& step : recording.steps) {
        for (const DeviceSample& sample : step.samples) {
            DeviceSample& one = now[static_cast<std::size_t>(sample.instrument)];
            const Pose lies = one.pose;
            one = sample;
            one.pose = sample.present ? sample.pose : lies;
        }
        seen.push_back({{now.begin(), now.end()}});
        for (const Command& command : step.commands) {
            if (const std::string words = station::words_of(command); !words.empty()) {
                seen.back().asked.push_back(words.substr(0, longest_words));
            }
        }
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
        std::optional<Pose> taken_up;
        for (std::size_t step = seen.size(); step-- > 0;) {
            DeviceSample& sample = *seen[step].instruments[i];
            if (sample.present) {
                taken_up = sample.pose;
            } else if (taken_up) {
                sample.pose = *taken_up;
            }
        }
        if (!taken_up) {
            std::for_each(seen.begin(), seen.end(), [i](SeenStep& step) { step.instruments[i].reset(); });
        } else {
            without_leaps(i, seen);
        }
    }
    return seen;
}

/// Hands rest in the end where they are, for who is a little late. How many steps that is.
std::size_t rest_in_the_end(std::vector<SeenStep>& steps, double step_s) {
    constexpr double rests_s = 1.0;
    if (steps.empty()) {
        return 0;
    }
    SeenStep last = steps.back();
    last.asked.clear();
    const auto count = static_cast<std::size_t>(std::lround(rests_s / step_s));
    steps.insert(steps.end(), count, last);
    return count;
}

/// How many were told.
std::size_t tell_in_time(const std::vector<SeenStep>& steps, std::size_t first, double step_s, const Teller& teller) {
    const double begun_s = wall_seconds();
    const std::int64_t begun_us = time_of_day_us();
    std::size_t told = 0;
    while (first + told < steps.size()) {
        const double now_s = wall_seconds();
        for (; first + told < steps.size() && begun_s + step_s * static_cast<double>(told) <= now_s; ++told) {
            const auto since_us = static_cast<std::int64_t>(1e6 * step_s * static_cast<double>(told));
            teller.tell(steps[first + told], now_s, begun_us + since_us);
        }
        turn(teller);
    }
    return told;
}

}  // namespace

void add_listen_options(CLI::App& command, ListenArguments& given) {
    command.add_option("--seconds", given.seconds, "So long [until it is ended]")->check(CLI::Range(0.0, 1e6));
    command.add_flag("--json", given.json, "A line of JSON each time");
}

int listen(const ListenArguments& given, const Listener& listener) {
    const double begun_s = wall_seconds();
    std::vector<DeviceReport> reports;
    std::string trouble;
    bool heard = false;
    for (double now_s = begun_s; given.seconds <= 0.0 || now_s - begun_s < given.seconds; now_s = wall_seconds()) {
        listener.turn(now_s, time_of_day_us(), reports);
        for (const DeviceReport& report : reports) {
            print(report, given.json);
        }
        heard = heard || !reports.empty();
        if (!reports.empty()) {
            std::fflush(stdout);
            reports.clear();
        }
        const std::string now = listener.trouble(now_s);
        if (now != trouble && !now.empty() && now_s - begun_s > 1.0) {
            std::fprintf(stderr, "rhexis: %s: %s\n", given.server.c_str(), now.c_str());
        }
        trouble = now_s - begun_s > 1.0 ? now : "";
        wait_a_little();
    }
    return heard ? done : found_failures;
}

void add_serve_options(CLI::App& command, ServeArguments& given) {
    command.add_option("recording", given.recording, "A recording (.rhx), or the folder of a run")->required();
    command.add_option("--address", given.address, "Of this computer, where it is heard")->capture_default_str();
    command.add_option("--port", given.port, "0: any that is free")->check(CLI::Range(0, 65535))->capture_default_str();
    command.add_option("--speed", given.speed, "Times as fast")->check(CLI::Range(0.01, 100.0))->capture_default_str();
    command.add_option("--from", given.from_s, "Begin at this second of it")
        ->check(CLI::Range(0.0, 7200.0))
        ->capture_default_str();
}

int serve(const ServeArguments& given, const Recording& recording, const Teller& teller) {
    const double recorded_s = recording.header.scene.step_s;
    std::vector<SeenStep> steps = as_seen(recording);
    if (const Status there = check_range("--from", given.from_s, 0.0, recorded_s * static_cast<double>(steps.size()),
                                         given.recording, " s");
        !there) {
        return complain(there.error());
    }
    std::printf("at %s:%d: ", given.address.c_str(), teller.port);
    for (const std::string& device : teller.devices) {
        std::printf("%s%s", device.c_str(), &device == &teller.devices.back() ? "\n" : ", ");
    }
    std::fflush(stdout);
    while (teller.peer_count() == 0) {
        turn(teller);
    }
    linger(teller);
    const std::size_t resting = rest_in_the_end(steps, recorded_s / given.speed);
    const std::size_t told =
        tell_in_time(steps, static_cast<std::size_t>(given.from_s / recorded_s), recorded_s / given.speed, teller);
    linger(teller);
    std::printf("%zu steps told\n", told - resting);
    return done;
}

}  // namespace rhexis::cli
