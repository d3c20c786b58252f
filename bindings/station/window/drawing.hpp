// SPDX-License-Identifier: GPL-3.0-or-later
// The thread that draws: devices are read on another, so that what hands do comes as it is done and not picture by
// picture.
#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "station/window/mapping_file.hpp"
#include "station/window/picture.hpp"

namespace rhexis::station {

class Drawing {
public:
    /// All of it outlives the drawing. by_hand: what devices and panels say counts.
    Drawing(Desk& desk, Window& window, Panels& panels, MappingFile& file, Picture& picture, bool by_hand);
    ~Drawing();
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    /// From the window, on the thread that opened it: to the desk, or to a panel that waits for it.
    void take(const UserEvent& event);
    /// The cursor leads a hand: it is not to be seen.
    [[nodiscard]] bool takes_cursor() const { return takes_cursor_; }

private:
    void run();
    void draw(Shown& shown);
    void hand_to_panel();

    Desk& desk_;
    Window& window_;
    Panels& panels_;
    MappingFile& file_;
    Picture& picture_;
    bool by_hand_;
    std::atomic<bool> takes_cursor_ = false;
    std::atomic<bool> panel_asks_ = false;
    std::mutex mutex_;
    std::vector<UserEvent> for_panel_;
    std::thread thread_;
};

}  // namespace rhexis::station
