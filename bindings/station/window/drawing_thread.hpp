// SPDX-License-Identifier: GPL-3.0-or-later
// The thread that draws: devices are read on another, so that what hands do comes as it is done and not picture by
// picture. It steps back behind the simulation, and the threads that a graphics driver begins on it do so too.
#pragma once

#include <atomic>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "station/station.hpp"
#include "station/window/live_picture.hpp"
#include "station/window/mapping_file.hpp"
#include "station/window/prepared.hpp"

namespace rhexis::station {

class DrawingThread {
public:
    /// All of it outlives the drawing. notice: to be shown at first; may be empty.
    DrawingThread(Desk& desk, Window& window, Prepared& prepared, const StationOptions& options,
                  std::string notice = "");
    /// Closes the desk.
    ~DrawingThread();
    DrawingThread(const DrawingThread&) = delete;
    DrawingThread& operator=(const DrawingThread&) = delete;

    /// Waits until it can draw. Once; the error says what is missing.
    Status begun() { return begun_.get_future().get(); }
    /// After the trial has ended: whether what was to be kept of it is kept. Once.
    Status finish() { return finished_.get_future().get(); }

    /// From the window, on the thread that opened it: to the desk, or to a panel that waits for it.
    void take(const UserEvent& event);
    /// The cursor leads a hand: it is not to be seen.
    [[nodiscard]] bool takes_cursor() const { return takes_cursor_; }

private:
    void run();
    void draw_all(Panels& panels, LivePicture& picture);
    void draw_by_hand(Shown& shown, MappingFile& file, Panels& panels, LivePicture& picture);
    void hand_to_panel(Panels& panels);
    Status keep_picture(LivePicture& picture);

    Desk& desk_;
    Window& window_;
    Prepared& prepared_;
    const StationOptions& options_;
    std::string notice_;
    std::atomic<bool> takes_cursor_ = false;
    std::atomic<bool> panel_asks_ = false;
    std::mutex mutex_;
    std::vector<UserEvent> for_panel_;
    std::promise<Status> begun_;
    std::promise<Status> finished_;
    std::thread thread_;
};

}  // namespace rhexis::station
