// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/typist.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "base/clock.hpp"

namespace rhexis::station {
namespace {

constexpr double lost_after_s = 0.5;  ///< an event that has not come back
constexpr double same_place = 1e-3;   ///< heights of the picture: less than a pixel

/// What X calls keys that SDL calls otherwise.
std::string key_name(const std::string& name) {
    constexpr auto names = std::to_array<std::pair<std::string_view, std::string_view>>({{"Left Shift", "Shift_L"},
                                                                                         {"Left Alt", "Alt_L"},
                                                                                         {"Space", "space"},
                                                                                         {"PageUp", "Prior"},
                                                                                         {"PageDown", "Next"},
                                                                                         {"+", "plus"},
                                                                                         {"-", "minus"},
                                                                                         {"=", "equal"}});
    for (const auto& [sdl, x] : names) {
        if (name == sdl) {
            return std::string(x);
        }
    }
    return name.size() == 1 ? std::string(1, static_cast<char>(std::tolower(static_cast<unsigned char>(name[0]))))
                            : name;
}

int button_number(const std::string& name) { return name == "left" ? 1 : name == "middle" ? 2 : 3; }

bool is_same(const UserEvent& sent, const UserEvent& back) {
    if (sent.kind != back.kind) {
        return false;
    }
    return sent.kind == EventKind::pointer
               ? std::abs(sent.x - back.x) < same_place && std::abs(sent.y - back.y) < same_place
               : sent.name == back.name && sent.value == back.value;
}

}  // namespace

Result<std::unique_ptr<Typist>> Typist::create(unsigned long window, int width, int height) {
    std::FILE* pipe = std::system("command -v xdotool >/dev/null") == 0 ? ::popen("xdotool -", "w") : nullptr;
    if (pipe == nullptr) {
        return Error{"xdotool cannot be started", "", "the package xdotool, and a window of an X server"};
    }
    std::fprintf(pipe, "windowfocus %lu\nmousemove --window %lu %d %d\n", window, window, width / 2, height / 2);
    std::fflush(pipe);
    return std::unique_ptr<Typist>(new Typist(pipe, height));
}

Status Typist::send(const std::vector<UserEvent>& events) {
    std::FILE* to = pipe_.get();
    for (const UserEvent& event : events) {
        switch (event.kind) {
            case EventKind::key:
                std::fprintf(to, "%s --delay 0 %s\n", event.value > 0.5 ? "keydown" : "keyup",
                             key_name(event.name).c_str());
                break;
            case EventKind::button:
                std::fprintf(to, "%s %d\n", event.value > 0.5 ? "mousedown" : "mouseup", button_number(event.name));
                break;
            case EventKind::pointer:
                std::fprintf(to, "mousemove_relative -- %ld %ld\n", std::lround((event.x - at_.x()) * height_),
                             std::lround((at_.y() - event.y) * height_));
                at_ = Cursor(event.x, event.y);
                break;
            case EventKind::wheel:  // a notch is a click, and comes back as one event
                for (int i = 0; i < static_cast<int>(std::abs(event.value)); ++i) {
                    const int button = event.value > 0.0 ? 4 : 5;  // its own click takes its time
                    std::fprintf(to, "mousedown %d\nmouseup %d\n", button, button);
                    on_the_way_.push_back({EventKind::wheel, "", event.value > 0.0 ? 1.0 : -1.0});
                }
                continue;
            default:
                return Error{"this goes through no X server: " + to_json(event).dump(), "", "mouse and keys"};
        }
        on_the_way_.push_back(event);
    }
    sent_s_ = events.empty() ? sent_s_ : wall_seconds();
    return std::fflush(to) == 0 ? success() : Status(Error{"xdotool has ended", "", ""});
}

/// A server may leave out all but the last of several moves.
void Typist::heed(const std::vector<UserEvent>& events) {
    for (const UserEvent& event : events) {
        const auto sent = std::find_if(on_the_way_.begin(), on_the_way_.end(),
                                       [&](const UserEvent& one) { return is_same(one, event); });
        if (sent != on_the_way_.end()) {
            on_the_way_.erase(on_the_way_.begin(), sent + 1);
        }
    }
}

bool Typist::rests() {
    if (wall_seconds() - sent_s_ > lost_after_s) {
        on_the_way_.clear();
    }
    return on_the_way_.empty();
}

Hands Typist::ahead(const Hands& now, const Surroundings& around) const {
    Hands hands = now;
    for (const UserEvent& event : on_the_way_) {
        hands.take(event, around);
    }
    return hands;
}

}  // namespace rhexis::station
