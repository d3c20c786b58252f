// SPDX-License-Identifier: GPL-3.0-or-later
// Events of a tracking system beside those of the devices on the desk: by the wall clock, which stands where something
// is lost until the hand has met what the simulation holds.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "input/tracked_hands.hpp"
#include "station/event_source.hpp"
#include "station/tracked_link.hpp"

namespace rhexis::station {

struct TrackedOptions {
    double step_s = 0.01;
    bool desk = true;                                  ///< somebody sits at it, with keys
    double gives_up_s = 0.0;                           ///< that the clock may stand; 0: for ever
    std::function<void(const std::string&)> say = {};  ///< why it stands, and that it goes on; may be empty
};

/// What there is to connect to.
struct TrackedPlace {
    std::string address;                     ///< "vrpn://HOST"
    std::string registration;                ///< file; empty: the tracked frame is that of the eye
    std::vector<std::string> instruments{};  ///< of the scene, in its order
};

class TrackedSource final : public EventSource {
public:
    /// Begins to connect. Fails on an address or a file that is none.
    static Result<std::unique_ptr<TrackedSource>> create(Desk& desk, const TrackedPlace& place, TrackedOptions options);
    /// The link is to the devices of the hands, and the desk outlives the source.
    TrackedSource(Desk& desk, std::unique_ptr<TrackedLink> link, TrackedHands hands, TrackedOptions options);

    /// Waits until there is a link, no longer than this. Else why there is none.
    Status wait(double longest_s);
    Result<std::vector<UserEvent>> take(std::uint64_t step, bool waits, const Hands& hands, const Surroundings& around,
                                        const Session& session) override;
    /// The clock has stood for too long.
    [[nodiscard]] bool over() const override;
    [[nodiscard]] double slowed() const override { return clock_.slowed(); }
    [[nodiscard]] std::optional<Pace> pace() const override { return clock_.pace(); }
    [[nodiscard]] std::uint64_t last_number() const override { return clock_.last_number(); }

private:
    void hear();
    void follow(const Hands& hands);
    void tell_state(const Hands& hands, std::vector<UserEvent>& events);
    void tell_samples(const Hands& hands, std::vector<UserEvent>& events);
    void tell_seen(std::vector<UserEvent>& events);
    void say(const std::string& text);

    TrackedOptions options_;
    WallClock clock_;
    std::unique_ptr<TrackedLink> link_;
    TrackedHands tracked_;
    std::vector<std::string> names_;         ///< of the instruments
    std::vector<std::optional<Vec3>> told_;  ///< by instrument: where it was last said to be seen
    std::string said_;
    std::string missing_;           ///< device that does not answer, as it was said
    double stands_since_s_ = -1.0;  ///< of the wall clock; below 0: it does not
    bool away_ = false;             ///< the whole computer was, before this step
};

}  // namespace rhexis::station
