// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/vrpn_serve.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>
#include <vector>

#include "base/clock.hpp"
#include "base/numbers.hpp"
#include "cli/command.hpp"
#include "input/tracked_hands.hpp"
#include "net/vrpn_server.hpp"
#include "session/recording.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

std::int64_t now_us() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::microseconds>(since).count();
}

/// Of one step: a sample of each instrument, or none of one that is never used.
using Seen = std::vector<std::optional<DeviceSample>>;

/// What cameras would see of a recording. An instrument that is not used yet lies where it will be taken up, and one
/// that is used no more where it was put down.
std::vector<Seen> as_seen(const Recording& recording) {
    std::vector<DeviceSample> now(recording.header.scene.instruments.size());
    std::vector<Seen> seen;
    for (const RecordedStep& step : recording.steps) {
        for (const DeviceSample& sample : step.samples) {
            DeviceSample& one = now[static_cast<std::size_t>(sample.instrument)];
            const Pose lies = one.pose;
            one = sample;
            one.pose = sample.present ? sample.pose : lies;
        }
        seen.emplace_back(now.begin(), now.end());
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
        std::optional<Pose> taken_up;
        for (std::size_t step = seen.size(); step-- > 0;) {
            DeviceSample& sample = *seen[step][i];
            if (sample.present) {
                taken_up = sample.pose;
            } else if (taken_up) {
                sample.pose = *taken_up;
            }
        }
        if (!taken_up) {
            std::for_each(seen.begin(), seen.end(), [i](Seen& step) { step[i].reset(); });
        }
    }
    return seen;
}

void tell(vrpn::Server& server, const std::vector<std::string>& instruments, const Seen& seen, std::int64_t time_us) {
    double pedal = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (!seen[i]) {
            continue;
        }
        const DeviceSample& sample = *seen[i];
        server.keep(instruments[i], vrpn::buttons_type, vrpn::buttons_payload({sample.present}), time_us);
        server.keep(instruments[i], vrpn::analog_type, vrpn::analog_payload({sample.jaw}), time_us);
        server.tell(instruments[i], vrpn::pose_type,
                    vrpn::payload_of(vrpn::PoseReport{0, sample.pose.position, sample.pose.orientation}), time_us);
        pedal = sample.present ? std::max(pedal, sample.pedal) : pedal;
    }
    server.keep(pedal_device, vrpn::analog_type, vrpn::analog_payload({pedal}), time_us);
}

void turn(vrpn::Server& server) {
    server.turn(wall_seconds(), now_us());
    for (const std::string& note : server.take_notes()) {
        std::fprintf(stderr, "rhexis: a listener: %s\n", note.c_str());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Until listeners know what the numbers mean, or have the last of them.
void linger(vrpn::Server& server) {
    constexpr double enough_s = 0.2;
    for (const double begun_s = wall_seconds(); wall_seconds() - begun_s < enough_s;) {
        turn(server);
    }
}

void print_place(const ServeArguments& given, const vrpn::Server& server, const std::vector<std::string>& devices) {
    std::printf("at %s:%d: ", given.address.c_str(), server.port());
    for (const std::string& device : devices) {
        std::printf("%s%s", device.c_str(), &device == &devices.back() ? "\n" : ", ");
    }
    std::fflush(stdout);
}

}  // namespace

int serve_recording(const ServeArguments& given) {
    const Result<Recording> recording = read_recording(recording_path(given.recording));
    if (!recording) {
        return complain(recording.error());
    }
    const SceneDescription& scene = recording.value().header.scene;
    const std::vector<Seen> steps = as_seen(recording.value());
    const auto first = static_cast<std::size_t>(given.from_s / scene.step_s);
    if (const Status there = check_range("--from", given.from_s, 0.0, scene.step_s * static_cast<double>(steps.size()),
                                         given.recording, " s");
        !there) {
        return complain(there.error());
    }
    std::vector<std::string> devices = scene.instruments;
    devices.emplace_back(pedal_device);
    Result<vrpn::Server> opened = vrpn::Server::open({given.address, given.port}, devices);
    if (!opened) {
        return complain(opened.error());
    }
    vrpn::Server& server = opened.value();
    print_place(given, server, devices);
    while (server.peer_count() == 0) {
        turn(server);
    }
    linger(server);
    // stamped with the moment that each is of, not with when it is told
    const double step_s = scene.step_s / given.speed;
    const double begun_s = wall_seconds();
    const std::int64_t begun_us = now_us();
    std::size_t told = 0;
    while (first + told < steps.size()) {
        for (; first + told < steps.size() && step_s * static_cast<double>(told) <= wall_seconds() - begun_s; ++told) {
            const auto since_us = static_cast<std::int64_t>(1e6 * step_s * static_cast<double>(told));
            tell(server, scene.instruments, steps[first + told], begun_us + since_us);
        }
        turn(server);
    }
    linger(server);
    std::printf("%zu steps told\n", told);
    return done;
}

}  // namespace rhexis::cli
