// SPDX-License-Identifier: GPL-3.0-or-later
#include "track/hop.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include "base/clock.hpp"
#include "input/clock_offset.hpp"
#include "net/vrpn_client.hpp"
#include "net/vrpn_server.hpp"

namespace rhexis::tracking {
namespace {

constexpr const char* device = "phaco";
constexpr auto every = std::chrono::milliseconds(1);
constexpr double goal_ms = 0.3;
constexpr double patience_s = 5.0;  ///< with a connection, and after the last pose
constexpr int looks_every_ms = 5;

std::int64_t now_us() { return static_cast<std::int64_t>(1e6 * wall_seconds()); }

/// Serves until it is told to begin, tells, and serves until it is told to end.
void tell_all(vrpn::Server& server, int poses, const std::atomic<bool>& begins, const std::atomic<bool>& ends) {
    auto due = std::chrono::steady_clock::now();
    for (int told = 0; !ends;) {
        std::this_thread::sleep_until(due += every);
        if (begins && told < poses) {
            const PoseReport report{0, Vec3(0.001 * told, 0.0, 0.0), Quat::Identity()};
            server.tell(device, vrpn::pose_type, vrpn::payload_of(report), now_us());
            ++told;
        }
        server.turn(wall_seconds(), now_us());
    }
}

/// Turns the client until it is so, or nothing more is to be hoped for.
template <typename So>
void hear_until(vrpn::Client& client, std::vector<DeviceReport>& reports, So so) {
    for (double heard_s = wall_seconds(); !so() && wall_seconds() - heard_s < patience_s;) {
        client.wait(looks_every_ms);
        reports.clear();
        client.turn(wall_seconds(), now_us(), reports);
        heard_s = reports.empty() ? heard_s : wall_seconds();
    }
}

}  // namespace

Result<Hop> measure_hop(bool by_datagram, int poses) {
    Result<vrpn::Server> server = vrpn::Server::open({"127.0.0.1", 0}, {device});
    if (!server) {
        return server.error();
    }
    vrpn::Client client({{"127.0.0.1", server.value().port()}, by_datagram}, {device});
    std::atomic<bool> begins = false;
    std::atomic<bool> ends = false;
    std::thread teller([&] { tell_all(server.value(), poses, begins, ends); });
    std::vector<DeviceReport> reports;
    const double begun_s = wall_seconds();
    constexpr double settled_s = 0.2;
    hear_until(client, reports, [&] { return client.is_connected() && wall_seconds() - begun_s > settled_s; });
    begins = true;
    std::vector<double> took_s;
    ClockOffset clocks;
    Hop hop{by_datagram, poses};
    hear_until(client, reports, [&] {
        const std::int64_t arrival_us = now_us();
        for (const DeviceReport& report : reports) {
            if (std::holds_alternative<PoseReport>(report.what)) {
                took_s.push_back(1e-6 * static_cast<double>(arrival_us - report.time_us));
                clocks.take(report.time_us, arrival_us);
            }
        }
        return static_cast<int>(took_s.size()) >= poses;
    });
    ends = true;
    teller.join();
    hop.heard = static_cast<int>(took_s.size());
    if (took_s.empty()) {
        return Error{"no pose came: " + client.trouble(wall_seconds()), "the way over the network", ""};
    }
    std::sort(took_s.begin(), took_s.end());
    hop.median_s = took_s[took_s.size() / 2];
    hop.of_99_s = took_s[took_s.size() * 99 / 100];
    hop.worst_s = took_s.back();
    hop.clocks_apart_s = 1e-6 * static_cast<double>(clocks.offset_us());
    return hop;
}

Figure figure_of(const Hop& hop) {
    std::array<char, 200> from{};
    std::snprintf(from.data(), from.size(),
                  "loopback, 1000 a second; median %.3f, worst %.2f ms; %d lost; clocks found %.3f ms apart",
                  1e3 * hop.median_s, 1e3 * hop.worst_s, hop.told - hop.heard, 1e3 * hop.clocks_apart_s);
    Figure figure;
    figure.quantity = std::string("a pose over the network by ") + (hop.by_datagram ? "datagram" : "TCP") + ", 99 %";
    figure.unit = "ms";
    figure.value = figure.mean = figure.worst = 1e3 * hop.of_99_s;
    figure.goal = goal_ms;
    figure.samples = hop.heard;
    figure.from = from.data();
    return figure;
}

}  // namespace rhexis::tracking
