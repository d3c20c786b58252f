// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/tracking_link.hpp"

#include <chrono>
#include <cstdio>
#include <thread>

#include "base/clock.hpp"
#include "cli/command.hpp"
#include "nlohmann/json.hpp"

namespace rhexis::cli {
namespace {

std::int64_t time_of_day_us() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::microseconds>(since).count();
}

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
    nlohmann::json line{{"device", report.device}, {"time_s", 1e-6 * static_cast<double>(report.time_us)}};
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

void tell_in_time(const std::vector<RecordedStep>& steps, double step_s, const Teller& teller) {
    const double begun_s = wall_seconds();
    std::size_t told = 0;
    while (told < steps.size()) {
        const double now_s = wall_seconds();
        for (; told < steps.size() && begun_s + step_s * static_cast<double>(told) <= now_s; ++told) {
            teller.tell(steps[told], now_s, time_of_day_us());
        }
        turn(teller);
    }
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
}

int serve(const ServeArguments& given, const Recording& recording, const Teller& teller) {
    std::printf("at %s:%d: ", given.address.c_str(), teller.port);
    for (const std::string& device : teller.devices) {
        std::printf("%s%s", device.c_str(), &device == &teller.devices.back() ? "\n" : ", ");
    }
    std::fflush(stdout);
    while (teller.peer_count() == 0) {
        turn(teller);
    }
    linger(teller);
    tell_in_time(recording.steps, recording.header.scene.step_s / given.speed, teller);
    linger(teller);
    std::printf("%zu steps told\n", recording.steps.size());
    return done;
}

}  // namespace rhexis::cli
