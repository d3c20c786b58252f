// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/user_event.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "input/tracked_hands.hpp"

namespace rhexis::station {
namespace {

constexpr std::array kind_names = {"key",   "pointer", "button", "wheel", "axis",     "press",   "control", "bind",
                                   "focus", "device",  "staff",  "quit",  "tracking", "tracked", "asked"};
constexpr double farthest = 1000.0;  ///< of a number beyond is no device's and no tuning's

Result<double> number_in(const nlohmann::json& json, const char* field) {
    if (!json.contains(field)) {
        return 0.0;
    }
    const nlohmann::json& value = json.at(field);
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!(std::abs(number) <= farthest)) {
        return Error{std::string("the event's ") + field + " is " + value.dump(), "",
                     "a number, -" + short_number(farthest) + " to " + short_number(farthest)};
    }
    return number;
}

/// As many numbers as the list has places; left out: they stay.
Status read_numbers(const nlohmann::json& json, const char* field, std::span<double> list) {
    if (!json.contains(field)) {
        return success();
    }
    const nlohmann::json& given = json.at(field);
    bool fits = given.is_array() && given.size() == list.size();
    for (std::size_t i = 0; fits && i < list.size(); ++i) {
        fits = given[i].is_number() && std::abs(given[i].get<double>()) <= farthest;
    }
    if (!fits) {
        return Error{
            std::string("the event's ") + field + " is " + given.dump(), "",
            std::to_string(list.size()) + " numbers, -" + short_number(farthest) + " to " + short_number(farthest)};
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i] = given[i].get<double>();
    }
    return success();
}

Status read_sample(const nlohmann::json& json, DeviceSample& sample) {
    Pose& pose = sample.pose;
    Status read = read_numbers(json, "position_mm", {pose.position.data(), 3});
    read = read ? read_numbers(json, "orientation_xyzw", {pose.orientation.coeffs().data(), 4}) : read;
    const Result<double> jaw = number_in(json, "jaw");
    sample.jaw = jaw ? jaw.value() : 0.0;
    return read && !jaw ? Status(jaw.error()) : read;
}

nlohmann::json sample_json(const DeviceSample& sample) {
    const Vec3& at = sample.pose.position;
    const Quat& turned = sample.pose.orientation;
    return {{"position_mm", {at.x(), at.y(), at.z()}},
            {"orientation_xyzw", {turned.x(), turned.y(), turned.z(), turned.w()}},
            {"jaw", sample.jaw}};
}

}  // namespace

nlohmann::json to_json(const UserEvent& event) {
    nlohmann::json json = {{"event", kind_names[static_cast<std::size_t>(event.kind)]}};
    if (!event.name.empty()) {
        json["name"] = event.name;
    }
    if (event.kind == EventKind::pointer) {
        json["x"] = event.x;
        json["y"] = event.y;
    } else if (event.kind != EventKind::quit) {
        json["value"] = event.value;
    }
    if (event.kind == EventKind::bind || event.kind == EventKind::staff || event.kind == EventKind::tracking) {
        json["control"] = event.control;
    }
    if (event.kind == EventKind::tracked && event.name != pedal_device) {
        json.update(sample_json(event.sample));
    }
    return json;
}

Result<UserEvent> event_from(const nlohmann::json& json) {
    const nlohmann::json given = json.is_object() ? json.value("event", nlohmann::json("")) : nlohmann::json("");
    const std::string kind = given.is_string() ? given.get<std::string>() : given.dump();
    const auto found = std::find(kind_names.begin(), kind_names.end(), kind);
    if (found == kind_names.end()) {
        return Error{"there is no event " + kind, "",
                     suggestion(kind, std::vector<std::string>(kind_names.begin(), kind_names.end()))};
    }
    UserEvent event;
    event.kind = static_cast<EventKind>(found - kind_names.begin());
    for (const auto& [field, to] : {std::pair("name", &event.name), {"control", &event.control}}) {
        const nlohmann::json text = json.value(field, nlohmann::json(""));
        if (!text.is_string()) {
            return Error{std::string("the event's ") + field + " is " + text.dump(), "", "a text"};
        }
        *to = text.get<std::string>();
    }
    for (const auto& [field, to] : {std::pair("value", &event.value), {"x", &event.x}, {"y", &event.y}}) {
        const Result<double> number = number_in(json, field);
        if (!number) {
            return number.error();
        }
        *to = number.value();
    }
    if (event.kind == EventKind::tracked) {
        if (const Status read = read_sample(json, event.sample); !read) {
            return read.error();
        }
    }
    return event;
}

}  // namespace rhexis::station
