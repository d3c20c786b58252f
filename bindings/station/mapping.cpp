// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/mapping.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "base/output_file.hpp"
#include "trial/places.hpp"

namespace rhexis::station {
namespace {

struct TuningField {
    const char* name;
    double Tuning::*value;
    double low;
    double high;
};

constexpr auto tuning_fields = std::to_array<TuningField>({
    {"tip_mm_s", &Tuning::tip_mm_s, 0.1, 50.0},
    {"key_share", &Tuning::key_share, 0.01, 1.0},
    {"notch_mm", &Tuning::notch_mm, 0.005, 1.0},
    {"roll_deg_s", &Tuning::roll_deg_s, 1.0, 720.0},
    {"fine", &Tuning::fine, 0.02, 1.0},
    {"pedal_per_s", &Tuning::pedal_per_s, 0.2, 20.0},
    {"dead_zone", &Tuning::dead_zone, 0.0, 0.5},
    {"pedal_rest", &Tuning::pedal_rest, -1.0, 1.0},
    {"pedal_full", &Tuning::pedal_full, -1.0, 1.0},
    {"pedal_first", &Tuning::pedal_first, 0.01, 0.9},
    {"pedal_second", &Tuning::pedal_second, 0.02, 0.95},
    {"pedal_third", &Tuning::pedal_third, 0.03, 0.99},
});

constexpr std::array devices = {"key", "mouse", "pad", "pedal"};
const std::vector<std::string> of_the_mouse = {"move", "wheel", "left", "middle", "right", "back", "forward"};

/// Of those that an input can work.
std::vector<std::string> control_names() {
    std::vector<std::string> names;
    for (const Control& one : control_table()) {
        if (one.kind != ControlKind::choice) {
            names.emplace_back(one.name);
        }
    }
    return names;
}

/// As a file says it: "swap", "-hand.y".
std::string said(const Binding& binding) { return std::string(binding.sign < 0.0 ? "-" : "") + binding.control->name; }

/// What a device can give to a control: a cursor is no button.
bool suits(const std::string& source, ControlKind kind) {
    const bool cursor = source == "mouse.move";
    const bool wheel = source == "mouse.wheel";
    return cursor == (kind == ControlKind::place) && (!wheel || kind == ControlKind::notch);
}

Result<Binding> binding_of(const std::string& source, const nlohmann::json& given) {
    std::string name = given.is_string() ? given.get<std::string>() : given.dump();
    Binding binding;
    if (name.starts_with('-')) {
        binding.sign = -1.0;
        name.erase(0, 1);
    }
    binding.control = find_control(name);
    if (binding.control == nullptr || binding.control->kind == ControlKind::choice) {
        return Error{"there is no control " + name, source, suggestion(name, control_names())};
    }
    if (!suits(source, binding.control->kind)) {
        return Error{source + " cannot work " + name, "",
                     "mouse.move for tip; mouse.wheel for depth or dial.turn; keys, buttons and axes for the others"};
    }
    return binding;
}

Status read_tuning(const nlohmann::json& json, Tuning& tuning) {
    std::vector<std::string> names;
    for (const TuningField& field : tuning_fields) {
        names.emplace_back(field.name);
    }
    for (const auto& [name, value] : json.items()) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            return Error{"nothing is called " + name, "tuning", suggestion(name, names)};
        }
        const TuningField& field = tuning_fields[static_cast<std::size_t>(found - names.begin())];
        const double number = value.is_number() ? value.get<double>() : std::nan("");
        if (!(number >= field.low && number <= field.high)) {
            return Error{name + " is " + value.dump(), "tuning",
                         short_number(field.low) + " to " + short_number(field.high)};
        }
        tuning.*field.value = number;
    }
    if (!(tuning.pedal_first < tuning.pedal_second && tuning.pedal_second < tuning.pedal_third) ||
        tuning.pedal_rest == tuning.pedal_full) {
        return Error{"the positions of the pedal do not follow each other", "tuning",
                     "pedal_first below pedal_second below pedal_third, and pedal_rest other than pedal_full"};
    }
    return success();
}

std::string file_name(bool pad, bool left) {
    return std::string(pad ? "gamepad" : "mouse") + (left ? "-left" : "") + ".json";
}

}  // namespace

Result<Mapping> Mapping::from(const nlohmann::json& json) {
    if (!json.is_object()) {
        return Error{"a mapping is no list and no number", "", R"({"key": {"Tab": "swap"}})"};
    }
    Mapping mapping;
    for (const auto& [device, inputs] : json.items()) {
        std::vector<std::string> known(devices.begin(), devices.end());
        known.emplace_back("tuning");
        if (std::find(known.begin(), known.end(), device) == known.end()) {
            return Error{"there is no device " + device, "", suggestion(device, known)};
        }
        if (!inputs.is_object()) {
            return Error{device + " is " + inputs.dump(), "", R"(pairs, as in {"Tab": "swap"})"};
        }
        if (device == "tuning") {
            if (const Status read = read_tuning(inputs, mapping.tuning_); !read) {
                return read.error();
            }
            continue;
        }
        for (const auto& [input, control] : inputs.items()) {
            if (device == "mouse" && std::find(of_the_mouse.begin(), of_the_mouse.end(), input) == of_the_mouse.end()) {
                return Error{"a mouse has no " + input, "", suggestion(input, of_the_mouse)};
            }
            const std::string source = device + "." + input;
            const Result<Binding> binding = binding_of(source, control);
            if (!binding) {
                return binding.error();
            }
            mapping.bindings_[source] = binding.value();
        }
    }
    return mapping;
}

Result<Mapping> Mapping::read(const std::string& path) {
    const Result<nlohmann::json> json = read_json_file(path);
    if (!json) {
        return json.error();
    }
    Result<Mapping> mapping = from(json.value());
    if (!mapping) {
        Error error = mapping.error();
        error.where = error.where.empty() ? path : path + ", " + error.where;
        return error;
    }
    return mapping;
}

Status Mapping::rebind(const UserEvent& event) {
    const std::size_t dot = event.name.find('.');
    const std::string device = event.name.substr(0, dot);
    const std::string input = dot == std::string::npos ? "" : event.name.substr(dot + 1);
    nlohmann::json changed = to_json();
    if (device == "tuning") {
        changed[device][input] = event.value;
    } else if (event.control.empty()) {
        bindings_.erase(event.name);
        return success();
    } else {
        changed[device][input] = event.control;
    }
    Result<Mapping> mapping = from(changed);
    if (!mapping) {
        return mapping.error();
    }
    *this = std::move(mapping).value();
    return success();
}

std::vector<UserEvent> Mapping::changes_to(const Mapping& that) const {
    std::vector<UserEvent> events;
    for (const auto& [source, binding] : bindings_) {
        if (that.find(source) == nullptr) {
            events.push_back({EventKind::bind, source, 0.0, 0.0, 0.0, ""});
        }
    }
    for (const auto& [source, binding] : that.bindings_) {
        const Binding* now = find(source);
        if (now == nullptr || now->control != binding.control || now->sign != binding.sign) {
            events.push_back({EventKind::bind, source, 0.0, 0.0, 0.0, said(binding)});
        }
    }
    for (const TuningField& field : tuning_fields) {
        if (tuning_.*field.value != that.tuning_.*field.value) {
            events.push_back({EventKind::bind, std::string("tuning.") + field.name, that.tuning_.*field.value});
        }
    }
    return events;
}

const Binding* Mapping::find(const std::string& source) const {
    const auto found = bindings_.find(source);
    return found == bindings_.end() ? nullptr : &found->second;
}

nlohmann::json Mapping::to_json() const {
    nlohmann::json json = nlohmann::json::object();
    for (const auto& [source, binding] : bindings_) {
        const std::size_t dot = source.find('.');
        json[source.substr(0, dot)][source.substr(dot + 1)] = said(binding);
    }
    for (const TuningField& field : tuning_fields) {
        json["tuning"][field.name] = tuning_.*field.value;
    }
    return json;
}

std::string Mapping::inputs_of(ControlId id, double way) const { return list(id, way, false); }
std::string Mapping::inputs_at_hand(ControlId id) const { return list(id, 0.0, true); }

std::string Mapping::list(ControlId id, double way, bool at_hand) const {
    const bool pads = !at_hand || !by_cursor();
    std::string text;
    for (const auto& [source, binding] : bindings_) {
        const bool is_pad = source.starts_with("pad.") || source.starts_with("pedal.");
        if (binding.control->id == id && (way == 0.0 || binding.sign == way) && (pads || !is_pad)) {
            const std::string shown = source.starts_with("key.") ? source.substr(4) : source;
            text += (text.empty() ? "" : ", ") + shown + (way == 0.0 && binding.sign < 0.0 ? " (-)" : "");
        }
    }
    return text;
}

Status write_mapping(const Mapping& mapping, const std::string& path) {
    std::error_code ignored;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
    return write_file(path, mapping.to_json().dump(2) + "\n");
}

std::string source_of(const UserEvent& event) {
    switch (event.kind) {
        case EventKind::key:
            return "key." + event.name;
        case EventKind::pointer:
            return "mouse.move";
        case EventKind::button:
            return "mouse." + event.name;
        case EventKind::wheel:
            return "mouse.wheel";
        case EventKind::axis:
        case EventKind::press:
            return event.name;
        default:
            return "";
    }
}

std::string standard_mapping(const std::string& root, bool pad, bool left) {
    return root + "/assets/station/" + file_name(pad, left);
}

std::string own_mapping(bool pad, bool left) {
    const char* settings = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    if (settings != nullptr && *settings == '/') {
        return std::string(settings) + "/rhexis/" + file_name(pad, left);
    }
    return home != nullptr && *home == '/' ? std::string(home) + "/.config/rhexis/" + file_name(pad, left) : "";
}

}  // namespace rhexis::station
