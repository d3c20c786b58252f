// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/injector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/near_names.hpp"

namespace rhexis::station {
namespace {

constexpr double head_back_mm_s = 2.0;  ///< of a head that comes back

Vec3 vector_in(const nlohmann::json& json) {
    return json.size() == 3 ? Vec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>()) : Vec3::Zero();
}

/// Between two places as a sine goes, so that it neither starts nor stops at once.
Vec3 place_at(const std::vector<Injection::HeadPlace>& way, double time_s) {
    if (time_s >= way.back().time_s) {
        return way.back().shift;
    }
    const auto next =
        std::find_if(way.begin(), way.end(), [&](const Injection::HeadPlace& one) { return one.time_s > time_s; });
    if (next == way.begin()) {
        return next->shift;
    }
    const Injection::HeadPlace& before = *(next - 1);
    const double share = (time_s - before.time_s) / (next->time_s - before.time_s);
    return before.shift + 0.5 * (1.0 - std::cos(std::numbers::pi * share)) * (next->shift - before.shift);
}

}  // namespace

std::vector<Injection> injections_of(const nlohmann::json& listing, bool has_microscope) {
    std::vector<Injection> list;
    for (const nlohmann::json& one : listing) {
        Injection injection{one.at("id"), one.at("title"), {}, {}, vector_in(one.at("microscope"))};
        for (const nlohmann::json& setting : one.at("settings")) {
            injection.settings.push_back({setting.at("name"), setting.at("to"), setting.at("over_s")});
        }
        for (const nlohmann::json& place : one.at("head")) {
            injection.head.push_back({place[0], Vec3(place[1], place[2], place[3])});
        }
        if (has_microscope || injection.microscope.isZero()) {
            list.push_back(std::move(injection));
        }
    }
    return list;
}

Status Injector::begin(const std::string& id) {
    const auto found = std::find_if(known_.begin(), known_.end(), [&](const Injection& one) { return one.id == id; });
    if (found == known_.end()) {
        std::vector<std::string> names;
        for (const Injection& one : known_) {
            names.push_back(one.id);
        }
        return Error{"this scene knows no injection " + id, "", suggestion(id, names)};
    }
    if (running_.emplace(id, Running{}).second) {
        next_.push_back({CommandKind::aid, "injected", 0.0, found->title});
        push_ = found->microscope.isZero() ? push_ : std::optional<Vec3>(found->microscope);
    }
    return success();
}

void Injector::end(const std::string& id) {
    const auto found = running_.find(id);
    if (found == running_.end()) {
        return;
    }
    for (const auto& [name, value] : found->second.before) {
        next_.push_back({CommandKind::inject, name, value, ""});
    }
    running_.erase(found);
}

/// Its settings on their way, one after the other. What has come there is whoever operates' to change: a line that is
/// opened again stays open.
void Injector::run(const Injection& injection, const std::map<std::string, double>& settings, Running& running,
                   std::vector<Command>& commands) {
    while (running.at < injection.settings.size()) {
        const Injection::Setting& setting = injection.settings[running.at];
        const double share =
            setting.over_s > 0.0 ? std::min((running.time_s - running.begun_s) / setting.over_s, 1.0) : 1.0;
        const double before = running.before.emplace(setting.name, settings.at(setting.name)).first->second;
        commands.push_back({CommandKind::inject, setting.name, before + share * (setting.to - before), ""});
        if (share < 1.0) {
            return;
        }
        ++running.at;
        running.begun_s = running.time_s;
    }
}

std::vector<Command> Injector::advance(double dt, const std::map<std::string, double>& settings) {
    std::vector<Command> commands = std::exchange(next_, {});
    Vec3 head = Vec3::Zero();
    bool moved = false;
    for (const Injection& injection : known_) {
        const auto found = running_.find(injection.id);
        if (found == running_.end()) {
            continue;
        }
        Running& running = found->second;
        run(injection, settings, running, commands);
        if (!injection.head.empty()) {
            head += place_at(injection.head, running.time_s);
            moved = true;
        }
        running.time_s += dt;
        const bool passes = !injection.head.empty() && injection.head.back().shift.isZero() &&
                            injection.settings.empty() && running.time_s > injection.head.back().time_s;
        const bool pushed = injection.settings.empty() && injection.head.empty();
        if (passes || pushed) {
            running_.erase(found);  // it is over by itself, and can come again
        }
    }
    if (moved) {
        head_ = head;
    } else {
        const double left = head_.norm();
        head_ *= left > head_back_mm_s * dt ? 1.0 - head_back_mm_s * dt / left : 0.0;
    }
    return commands;
}

}  // namespace rhexis::station
