// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/tracked_link.hpp"

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/clock.hpp"
#include "trial/places.hpp"

namespace rhexis::station {
namespace {

constexpr std::string_view scheme = "vrpn://";
constexpr std::string_view tcp_scheme = "vrpn+tcp://";
constexpr std::size_t most_waiting = 200'000;  ///< reports; who does not ask for minutes loses the oldest
constexpr double unit_within = 0.01;           ///< of a quaternion's length: rounding
constexpr double farthest_mm = 10'000.0;
constexpr int looks_every_ms = 5;  ///< where nothing comes: at what is to be sent, and whether it ends

void pause_ms(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

std::int64_t time_of_day_us() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::microseconds>(since).count();
}

/// As many as the list has places.
Status read_numbers(const nlohmann::json& json, const char* field, std::span<double> list, const std::string& path) {
    const nlohmann::json given = json.is_object() ? json.value(field, nlohmann::json()) : nlohmann::json();
    bool fits = given.is_array() && given.size() == list.size();
    for (std::size_t i = 0; fits && i < list.size(); ++i) {
        fits = given[i].is_number() && std::abs(given[i].get<double>()) <= farthest_mm;
        list[i] = fits ? given[i].get<double>() : 0.0;
    }
    return fits ? success()
                : Status(Error{std::string(field) + " is " + (given.is_null() ? "missing" : given.dump()), path,
                               std::to_string(list.size()) + " numbers"});
}

}  // namespace

bool is_tracked(std::string_view input) { return input.starts_with(scheme) || input.starts_with(tcp_scheme); }

Result<vrpn::ServerPlace> tracking_place(std::string_view input) {
    std::string place(input);
    if (input.starts_with(tcp_scheme)) {
        place = "tcp://" + place.substr(tcp_scheme.size());
    } else if (input.starts_with(scheme)) {
        place = place.substr(scheme.size());
    }
    return vrpn::server_place(place);
}

Result<Pose> read_registration(const std::string& path) {
    const Result<std::string> text = read_whole_file(path);
    if (!text) {
        return text.error();
    }
    const nlohmann::json json = nlohmann::json::parse(text.value(), nullptr, false);
    Pose pose;
    Status read = read_numbers(json, "position_mm", {pose.position.data(), 3}, path);
    read = read ? read_numbers(json, "orientation_xyzw", {pose.orientation.coeffs().data(), 4}, path) : read;
    if (!read) {
        return read.error();
    }
    if (std::abs(pose.orientation.norm() - 1.0) > unit_within) {
        return Error{"orientation_xyzw has the length " + std::to_string(pose.orientation.norm()), path, "1"};
    }
    pose.orientation.normalize();
    return pose;
}

std::int64_t arrival_clock_us() { return static_cast<std::int64_t>(1e6 * wall_seconds()); }

TrackedLink::TrackedLink(vrpn::ServerPlace place, std::vector<std::string> devices,
                         const std::vector<std::string>& optional)
    : client_(std::move(place), std::move(devices), optional), thread_([this] { run(); }) {}

TrackedLink::~TrackedLink() {
    ends_ = true;
    thread_.join();
}

void TrackedLink::run() {
    std::vector<DeviceReport> reports;
    while (!ends_) {
        const double now_s = wall_seconds();
        client_.turn(now_s, time_of_day_us(), reports);
        {
            const std::lock_guard lock(mutex_);
            for (DeviceReport& report : reports) {
                news_.reports.push_back({std::move(report), arrival_clock_us()});
            }
            if (news_.reports.size() > most_waiting) {
                news_.reports.erase(news_.reports.begin(), news_.reports.end() - most_waiting / 2);
            }
            news_.connected = client_.is_connected();
            news_.trouble = client_.trouble(now_s);
        }
        reports.clear();
        client_.wait(looks_every_ms);
    }
}

TrackedLink::News TrackedLink::collect() {
    const std::lock_guard lock(mutex_);
    News news{std::exchange(news_.reports, {}), news_.connected, news_.trouble};
    return news;
}

bool TrackedLink::wait(double longest_s) {
    for (const double begun_s = wall_seconds(); wall_seconds() - begun_s < longest_s; pause_ms(5)) {
        const std::lock_guard lock(mutex_);
        if (news_.connected) {
            return true;
        }
    }
    return false;
}

}  // namespace rhexis::station
