// SPDX-License-Identifier: GPL-3.0-or-later
// What stands around the picture in a debriefing, and what is wished for there.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/view.hpp"
#include "station/ghost.hpp"
#include "station/window/overlay.hpp"
#include "station/words.hpp"
#include "theatre/debriefing/player.hpp"
#include "theatre/debriefing/story.hpp"

namespace rhexis::station {

// What the lists on the right and the time line below take of the window [pixels].
inline constexpr int side_width = 330;
inline constexpr int line_height = 92;

/// As the debriefing stands.
struct DebriefingState {
    double end_s = 0.0;
    double time_s = 0.0;  ///< that is wanted
    bool plays = false;
    double speed = 1.0;
    bool shows_ghost = true;
    bool free_camera = false;
};

/// What is wished for in one picture.
struct DebriefingWish {
    std::optional<double> time_s{};
    std::optional<bool> plays{};
    std::optional<double> speed{};
    bool resets_camera = false;
    bool toggles_ghost = false;
};

class DebriefingPanels {
public:
    DebriefingPanels(Window& window, Words words, Story story, std::vector<std::string> instruments)
        : overlay_(window), words_(std::move(words)), story_(std::move(story)), instruments_(std::move(instruments)) {}

    /// view: of the picture, which fills what lists and line leave. own: the way of the recording; expert: null, there
    /// is none. moment: null, nothing to see yet.
    DebriefingWish draw(const DebriefingState& state, const PlayedMoment* moment, const View& view, const Ghost& own,
                        const Ghost* expert, const std::string& notice);
    /// The cursor is over a panel, which takes it.
    [[nodiscard]] bool holds_cursor() const;

    [[nodiscard]] const Story& story() const { return story_; }

private:
    void draw_ways(const PlayedMoment& moment, const View& view, const Ghost& own, const Ghost* expert) const;
    void draw_line(const DebriefingState& state, DebriefingWish& wish) const;
    void draw_marks(const DebriefingState& state, DebriefingWish& wish) const;
    void draw_items() const;
    void draw_state(const DebriefingState& state, const PlayedMoment* moment, bool has_expert,
                    const std::string& notice, DebriefingWish& wish) const;

    Overlay overlay_;
    Words words_;
    Story story_;
    std::vector<std::string> instruments_;
};

}  // namespace rhexis::station
