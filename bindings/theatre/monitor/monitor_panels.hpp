// SPDX-License-Identifier: GPL-3.0-or-later
// What the theatre's monitor shows, and what is asked for at it.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "station/theatre_moment.hpp"
#include "station/user_event.hpp"
#include "station/window/overlay.hpp"
#include "station/words.hpp"
#include "theatre/monitor/traces.hpp"

namespace rhexis::station {

/// Whether there is anything to show.
enum class News {
    none,     ///< no station yet
    fresh,    ///<
    stalled,  ///< none for a while
    strange   ///< a station of another version speaks
};

class MonitorPanels {
public:
    MonitorPanels(Window& window, Words words) : overlay_(window), words_(std::move(words)) {}

    /// A moment has come.
    void take(const TheatreMoment& moment);
    /// One picture of it. What is asked for comes back.
    std::vector<UserEvent> draw(News news, double silent_s, const std::string& address);
    /// Shows a line for a while.
    void notice(const std::string& text);

private:
    void draw_head(News news, double silent_s, const std::string& address) const;
    void draw_vitals() const;
    void draw_machine() const;
    void draw_steps() const;
    void draw_events() const;
    void draw_score() const;
    void draw_forces() const;
    void draw_health() const;
    void draw_instructor(std::vector<UserEvent>& asked);

    Overlay overlay_;
    Words words_;
    std::optional<TheatreMoment> moment_;
    Traces traces_;
    std::map<std::string, std::vector<float>> forces_;  ///< of the last seconds, by instrument and meaning
    std::array<char, 400> note_{};
    std::string notice_;
    double notice_until_s_ = 0.0;
};

}  // namespace rhexis::station
