// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis vrpn: what a VRPN server tells, for who sets up tracking; and a recording told as a tracking system would.
#include <charconv>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

#include "base/clock.hpp"
#include "cli/command.hpp"
#include "cli/vrpn_serve.hpp"
#include "net/vrpn_client.hpp"
#include "nlohmann/json.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* vrpn_help =
    "Each instrument is a device: its pose a tracker's (sensor 0), whether it is there button 0, its jaws analog 0.\n"
    "The foot is the device pedal, analog 0, from 0 to 3.\n"
    "\n"
    "  rhexis vrpn listen 192.168.1.7 phaco pedal          what these two do, a line each time\n"
    "  rhexis vrpn listen tcp://192.168.1.7 phaco --json   through a wall that lets TCP pass only\n"
    "  rhexis vrpn serve runs/groove-expert-1              a recording in the place of a tracking system, here only\n"
    "  rhexis vrpn serve runs/groove-expert-1 --address 192.168.1.9    for other computers too";

std::int64_t time_of_day_us() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::microseconds>(since).count();
}

void wait_a_little() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

struct ListenArguments {
    std::string server;
    std::vector<std::string> devices;
    double seconds = 0.0;
    bool json = false;
};

/// Kind and value of a report.
struct ReportLine {
    nlohmann::json& line;
    void operator()(const vrpn::PoseReport& pose) const {
        line["kind"] = "pose";
        line["sensor"] = pose.sensor;
        line["position_mm"] = {pose.position.x(), pose.position.y(), pose.position.z()};
        line["quaternion_xyzw"] = {pose.turned.x(), pose.turned.y(), pose.turned.z(), pose.turned.w()};
    }
    void operator()(const vrpn::VelocityReport& velocity) const {
        line["kind"] = "velocity";
        line["sensor"] = velocity.sensor;
        line["mm_per_s"] = {velocity.velocity.x(), velocity.velocity.y(), velocity.velocity.z()};
    }
    void operator()(const vrpn::ButtonReport& button) const {
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
    void operator()(const vrpn::TextReport& text) const {
        line["kind"] = "text";
        line["text"] = text.text;
    }
};

void print(const vrpn::Report& report, bool as_json) {
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

int listen(const ListenArguments& given) {
    Result<vrpn::ServerPlace> place = vrpn::server_place(given.server);
    if (!place) {
        return complain(place.error());
    }
    vrpn::Client client(std::move(place).value(), given.devices);
    const double begun_s = wall_seconds();
    std::vector<vrpn::Report> reports;
    std::string trouble;
    bool heard = false;
    for (double now_s = begun_s; given.seconds <= 0.0 || now_s - begun_s < given.seconds; now_s = wall_seconds()) {
        client.turn(now_s, time_of_day_us(), reports);
        for (const vrpn::Report& report : reports) {
            print(report, given.json);
        }
        heard = heard || !reports.empty();
        if (!reports.empty()) {
            std::fflush(stdout);
            reports.clear();
        }
        const std::string now = client.trouble(now_s);
        if (now != trouble && !now.empty() && now_s - begun_s > 1.0) {
            std::fprintf(stderr, "rhexis: %s: %s\n", given.server.c_str(), now.c_str());
        }
        trouble = now_s - begun_s > 1.0 ? now : "";
        wait_a_little();
    }
    return heard ? done : found_failures;
}

}  // namespace

void add_vrpn(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("vrpn", "Hear what a VRPN server tells, or tell a recording as one");
    command->footer(vrpn_help);
    command->require_subcommand(1);
    CLI::App* hear = command->add_subcommand("listen", "Print what devices do");
    auto heard = std::make_shared<ListenArguments>();
    hear->add_option("server", heard->server, "ADDRESS, ADDRESS:PORT or tcp://ADDRESS:PORT; the port is else 3883")
        ->required();
    hear->add_option("device", heard->devices, "Names of devices")->required();
    hear->add_option("--seconds", heard->seconds, "So long [until it is ended]")->check(CLI::Range(0.0, 1e6));
    hear->add_flag("--json", heard->json, "A line of JSON each time");
    hear->callback([heard, &context] { context.status = listen(*heard); });
    CLI::App* say = command->add_subcommand("serve", "Tell a recording, from when somebody listens");
    auto said = std::make_shared<ServeArguments>();
    say->add_option("recording", said->recording, "A recording (.rhx), or the folder of a run")->required();
    say->add_option("--address", said->address, "Of this computer, where it is heard")->capture_default_str();
    say->add_option("--port", said->port, "0: any that is free")->check(CLI::Range(0, 65535))->capture_default_str();
    say->add_option("--speed", said->speed, "Times as fast")->check(CLI::Range(0.01, 100.0))->capture_default_str();
    say->add_option("--from", said->from_s, "Begin at this second of it")
        ->check(CLI::Range(0.0, 7200.0))
        ->capture_default_str();
    say->callback([said, &context] { context.status = serve_recording(*said); });
}

}  // namespace rhexis::cli
