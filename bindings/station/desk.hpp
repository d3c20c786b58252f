// SPDX-License-Identifier: GPL-3.0-or-later
// The two places where the window's thread and the simulation's meet: events in, pictures out.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "flow/frame.hpp"
#include "station/hands.hpp"
#include "station/theatre_moment.hpp"
#include "station/user_event.hpp"

namespace rhexis::station {

struct PostedEvent {
    UserEvent event;
    std::uint64_t number = 0;  ///< from 1
};

/// What is to be drawn. Once it is on the desk it is the window's alone.
struct Shown {
    Frame frame;
    HandsState hands;
    Surroundings around;
    std::uint64_t step = 0;
    std::uint64_t events = 0;  ///< number of the last one that is in it
    double slowed = 1.0;       ///< simulated seconds per second of the clock
    bool waits = false;        ///< the clock stands until the hand meets its instrument, or pause ends
    std::shared_ptr<const Stand> stand;
    std::vector<std::string> lines;       ///< what was said to the trainee of late, the last one last
    std::vector<Vec3> marks;              ///< where the tip is to be: one place, or a way through several
    std::vector<std::string> warnings{};  ///< of what is about to go wrong
    std::vector<HandForce> forces{};      ///< of the instruments
};

/// What a loudspeaker makes of a step.
struct Heard {
    MachinePanel machine;
    double force_mN = 0.0;  ///< the greatest of all hands
    bool silent = true;     ///< the clock stands
};

class Desk {
public:
    // The window's side.
    void post(const UserEvent& event);
    void post(const std::vector<UserEvent>& events);
    /// Those posted after this one, which are in no picture yet.
    std::vector<UserEvent> after(std::uint64_t number);
    [[nodiscard]] std::shared_ptr<Shown> newest() const;
    /// Waits for a picture after `step` (none: for any), or until the time is over or the trial has ended. The newest;
    /// null: there is none yet.
    std::shared_ptr<Shown> wait_for(const std::optional<std::uint64_t>& step, double longest_s);
    /// This picture is drawn.
    void drawn(std::uint64_t step);
    [[nodiscard]] bool ended() const;
    void wait_until_ended();
    /// The window has gone: nobody draws any more.
    void close();

    // The simulation's side.
    std::vector<PostedEvent> take();
    /// Waits until an event is posted, or until this time of the wall clock.
    void wait_for_event(double until_s);
    void show(std::shared_ptr<Shown> shown);
    /// The last picture has been taken to be drawn, so that a newer one is of use.
    [[nodiscard]] bool wants_picture() const;
    /// From the first that was drawn to the last.
    [[nodiscard]] double pictures_per_s() const;
    /// Waits until it is drawn, or the window has gone.
    void wait_until_drawn(std::uint64_t step);
    /// Every step, drawn or not.
    void hear(const Heard& heard);
    [[nodiscard]] Heard heard() const;
    void end();
    [[nodiscard]] bool closed() const;

private:
    mutable std::mutex mutex_;
    std::condition_variable posted_;
    std::condition_variable shown_;
    std::condition_variable drawn_;
    std::vector<PostedEvent> events_;  ///< not yet taken
    std::deque<PostedEvent> recent_;   ///< not yet in a picture
    std::uint64_t last_number_ = 0;
    std::shared_ptr<Shown> newest_;
    Heard heard_;
    std::uint64_t drawn_step_ = 0;
    bool any_drawn_ = false;
    std::uint64_t pictures_ = 0;
    double first_drawn_s_ = 0.0;
    double last_drawn_s_ = 0.0;
    mutable bool taken_ = true;  ///< the newest picture
    bool ended_ = false;
    bool closed_ = false;
};

}  // namespace rhexis::station
