// SPDX-License-Identifier: GPL-3.0-or-later
// What a virtual surgeon does with mouse and keys goes the whole way: through the X server, by xdotool, and back from
// it into the window.
#pragma once

#include <cstdio>
#include <deque>
#include <memory>
#include <vector>

#include "base/result.hpp"
#include "station/hands.hpp"
#include "station/user_event.hpp"

namespace rhexis::station {

class Typist {
public:
    /// window: its number in the X server; width, height [pixels]. Fails where xdotool cannot be started.
    static Result<std::unique_ptr<Typist>> create(unsigned long window, int width, int height);

    Status send(const std::vector<UserEvent>& events);
    /// These have come back.
    void heed(const std::vector<UserEvent>& events);
    /// What has not come back for so long does not come any more, and is forgotten: whether nothing is on its way.
    bool rests();
    /// The hands as they will be when all that was sent has come back.
    [[nodiscard]] Hands ahead(const Hands& now, const Surroundings& around) const;

private:
    struct Close {
        void operator()(std::FILE* file) const { ::pclose(file); }
    };
    Typist(std::FILE* pipe, int height) : pipe_(pipe), height_(height), at_(0.5 / height, -0.5 / height) {}

    std::unique_ptr<std::FILE, Close> pipe_;
    int height_;
    Cursor at_;  ///< where the cursor has been sent; at first to the pixel right below the window's middle
    std::deque<UserEvent> on_the_way_;
    double sent_s_ = 0.0;  ///< the last of them, by the wall clock
};

}  // namespace rhexis::station
