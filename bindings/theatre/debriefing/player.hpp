// SPDX-License-Identifier: GPL-3.0-or-later
// A recording as something to look at: the state at any step, found on a thread of its own by simulating on from the
// state before it, or from the nearest checkpoint.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "flow/frame.hpp"
#include "session/recording.hpp"
#include "station/theatre_moment.hpp"

namespace rhexis::station {

struct PlayedMoment {
    Frame frame;
    std::uint64_t step = 0;
    MachinePanel machine;
    std::vector<HandForce> forces;
};

class Player {
public:
    /// The recording outlives the player.
    explicit Player(const Recording& recording);
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    /// Wants to see this step, 0 to the number of steps; on its way there it may show what lies before.
    void go_to(std::uint64_t step);
    /// Null: nothing yet.
    [[nodiscard]] std::shared_ptr<const PlayedMoment> newest() const;
    /// Why nothing more comes; empty: it does.
    [[nodiscard]] std::string fault() const;

private:
    void run();

    const Recording& recording_;
    mutable std::mutex mutex_;
    std::condition_variable wanted_changed_;
    std::uint64_t wanted_ = 0;
    bool ends_ = false;
    std::shared_ptr<const PlayedMoment> newest_;
    std::string fault_;
    std::thread thread_;
};

}  // namespace rhexis::station
