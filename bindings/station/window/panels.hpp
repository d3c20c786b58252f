// SPDX-License-Identifier: GPL-3.0-or-later
// What is written and clicked over the picture.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "station/desk.hpp"
#include "station/ghost.hpp"
#include "station/guide.hpp"
#include "station/mapping.hpp"
#include "station/window/overlay.hpp"
#include "station/words.hpp"

namespace rhexis::station {

/// How pictures are drawn.
struct DrawingRate {
    double pictures_per_s = 0.0;
    double size = 1.0;  ///< of the window's, that they are drawn in
};

/// A mapping that can be had at a click.
struct MappingOffer {
    std::string title;  ///< English
    Mapping mapping;
};

class Panels {
public:
    /// own: file in which a person's own mapping is kept; empty: nowhere.
    Panels(Window& window, Words words, std::vector<MappingOffer> offers, std::string own);

    /// Over the picture that is drawn; what is clicked comes back as events. ghost: null, there is none.
    std::vector<UserEvent> draw(const Shown& shown, const Ghost* ghost, const DrawingRate& rate);

    /// While a control waits for its new key, what is pressed is bound to it and works nothing: the events that say so.
    /// None: the event is no panel's.
    std::optional<std::vector<UserEvent>> captured(const UserEvent& event);

    /// A control waits for its new key.
    [[nodiscard]] bool asks() const { return asked_.has_value(); }

    /// Shows a line for a while.
    void notice(const std::string& text);

    [[nodiscard]] const Words& words() const { return words_; }

private:
    void draw_state(const Shown& shown, const DrawingRate& rate) const;
    void draw_standstill(const Shown& shown) const;
    /// next: for hands to learn.
    void draw_lines(const Shown& shown, const std::optional<std::string>& next) const;
    void draw_break(const Shown& shown, std::vector<UserEvent>& clicked);
    void draw_instruments(const Shown& shown, std::vector<UserEvent>& clicked) const;
    void draw_dials(const Shown& shown, std::vector<UserEvent>& clicked) const;
    void draw_requests(const Shown& shown, std::vector<UserEvent>& clicked) const;
    void draw_keys(const Shown& shown, std::vector<UserEvent>& clicked);
    void draw_offers(const Mapping& now, std::vector<UserEvent>& clicked);
    void keep_as_own(const Mapping& mapping);
    [[nodiscard]] std::string held(const Shown& shown, int hand) const;

    Overlay overlay_;
    Words words_;
    std::vector<MappingOffer> offers_;
    std::string own_;
    Guide guide_;
    std::shared_ptr<const Mapping> mapping_;  ///< as shown last
    std::optional<ControlId> asked_;          ///< waits for its new key
    bool asked_turned_ = false;               ///< for the other way of it
    std::string notice_;
    double notice_until_s_ = 0.0;  ///< of the wall clock
};

}  // namespace rhexis::station
