// SPDX-License-Identifier: GPL-3.0-or-later
// A window for a person beside work that must not wait for it: pictures are made and drawn on a thread of their own,
// which steps back behind the work.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

#include "trial/picture_screen.hpp"

namespace rhexis::tracking {

class Onlooker {
public:
    /// Makes pictures as large as is wished, of what it was given to keep. Called on the onlooker's thread, again where
    /// another picture is wished.
    using Painter = std::function<void(const ScreenWish& wish, ScreenMoment& moment)>;

    /// Waits until the window is there; null where none is asked for. The error: there is no display.
    static Result<std::unique_ptr<Onlooker>> open(const ScreenOptions& options, OpenScreen* open_screen);
    /// Closes the window.
    ~Onlooker();
    Onlooker(const Onlooker&) = delete;
    Onlooker& operator=(const Onlooker&) = delete;

    /// Something new would be drawn: at most 25 times a second.
    [[nodiscard]] bool wants() const { return wants_; }
    /// Takes the place of what was not drawn yet. Waits for nobody: while the onlooker, who may be held up, is taking
    /// something it is left out.
    void show(Painter painter);
    /// A person closed it.
    [[nodiscard]] bool closed() const { return closed_; }
    /// Draws this last, or what was shown last where it is empty, keeps it where a screenshot was asked for, and closes
    /// the window. Once.
    Status finish(Painter last);

private:
    Onlooker(const ScreenOptions& options, OpenScreen& open_screen);
    void run(OpenScreen& open_screen);
    void draw_all(PictureScreen& screen);
    bool take(Painter& painter);

    ScreenOptions options_;
    std::atomic<bool> wants_ = false;
    std::atomic<bool> closed_ = false;
    std::mutex mutex_;
    std::condition_variable woken_;
    Painter next_;         ///< shown and not yet taken; guarded
    bool ending_ = false;  ///< guarded
    std::promise<Status> begun_;
    std::promise<Status> finished_;
    std::thread thread_;
};

}  // namespace rhexis::tracking
