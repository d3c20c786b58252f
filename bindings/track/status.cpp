// SPDX-License-Identifier: GPL-3.0-or-later
#include "track/status.hpp"

#include <unistd.h>

#include <cstdio>

namespace rhexis::tracking {

const char* word_of(Seen seen) { return seen == Seen::seen ? "seen" : seen == Seen::held ? "held" : "lost"; }

namespace {

std::string line_of(const std::string& name, const TrackedBody& body, double lost_s) {
    std::array<char, 200> text{};
    if (body.seen == Seen::lost) {
        std::snprintf(text.data(), text.size(), "%-24s lost for %.1f s", name.c_str(), lost_s);
    } else {
        const Vec3& tip = body.tip.position;
        std::snprintf(text.data(), text.size(),
                      "%-24s %s by %d cameras, %d markers, %.3f pixels; tip %8.2f %8.2f %8.2f mm", name.c_str(),
                      word_of(body.seen), body.cameras, body.markers, body.residual_px, tip.x(), tip.y(), tip.z());
    }
    return text.data();
}

}  // namespace

StatusLines::StatusLines(const Setup& setup)
    : before_(setup.bodies.size(), Seen::lost),
      since_s_(setup.bodies.size(), 0.0),
      terminal_(isatty(STDERR_FILENO) == 1) {
    for (const MarkerBody& body : setup.bodies) {
        names_.push_back(body.name);
    }
}

void StatusLines::show(const TrackedBodies& told, const RigHealth& health) {
    if (terminal_ && drawn_) {
        std::fprintf(stderr, "\x1b[%zuA", names_.size() + 1);
    }
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const TrackedBody& body = told.bodies[i];
        const bool changed = (body.seen == Seen::lost) != (before_[i] == Seen::lost);
        if (body.seen != Seen::lost || changed) {
            since_s_[i] = told.time_s;
        }
        before_[i] = body.seen;
        if (terminal_) {
            std::fprintf(stderr, "\r\x1b[K%s\n", line_of(names_[i], body, told.time_s - since_s_[i]).c_str());
        } else if (changed) {
            std::fprintf(stderr, "%.3f s: %s is %s\n", told.time_s, names_[i].c_str(), word_of(body.seen));
        }
    }
    if (terminal_) {
        std::fprintf(stderr, "\r\x1b[K%.0f exposures/s, %.2f ms each, %llu lost; %zu listening%s%s\n",
                     health.sets_per_s, health.compute_ms, static_cast<unsigned long long>(health.lost),
                     health.listeners, health.warning.empty() ? "" : "; ", health.warning.c_str());
        drawn_ = true;
    } else if (health.warning != warned_) {
        std::fprintf(stderr, "%.3f s: %s\n", told.time_s,
                     health.warning.empty() ? "the rig is well again" : health.warning.c_str());
        warned_ = health.warning;
    }
}

}  // namespace rhexis::tracking
