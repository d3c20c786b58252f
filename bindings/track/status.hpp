// SPDX-License-Identifier: GPL-3.0-or-later
// What a tracking computer's terminal shows: each body on a line, redrawn; in a pipe, what changes.
#pragma once

#include <string>
#include <vector>

#include "tracking/setup.hpp"

namespace rhexis::tracking {

/// Of the whole rig.
struct RigHealth {
    double sets_per_s = 0.0;
    double compute_ms = 0.0;        ///< from images to poses, median of the last second
    std::uint64_t lost = 0;         ///< exposures that did not come
    std::uint64_t lost_lately = 0;  ///< of them, in the last second
    std::size_t listeners = 0;
    std::string warning{};
    int warned_camera = -1;  ///< that it is about; -1: of none
};

/// "seen", "held" or "lost".
const char* word_of(Seen seen);

class StatusLines {
public:
    explicit StatusLines(const Setup& setup);
    void show(const TrackedBodies& told, const RigHealth& health);

private:
    std::vector<std::string> names_;
    std::vector<std::string> cameras_;
    std::vector<Seen> before_;
    std::vector<double> since_s_;
    std::string warned_{};
    bool terminal_;
    bool drawn_ = false;
};

}  // namespace rhexis::tracking
