// SPDX-License-Identifier: GPL-3.0-or-later
// From what a tracking system tells of instruments and foot to the samples of a step. No threads and no clock of its
// own: whoever hears the reports says when they came, and whoever steps says for which moment a step stands.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flow/device_sample.hpp"
#include "input/clock_offset.hpp"
#include "input/tracked_instrument.hpp"
#include "net/vrpn_client.hpp"

namespace rhexis {

/// A step shows hands as they were so long ago, so that there is a pose on either side of that moment; more where
/// reports come unevenly or seldom, up to the second [us].
inline constexpr std::int64_t least_delay_us = 20'000;
inline constexpr std::int64_t most_delay_us = 100'000;

/// The device of the foot: analog 0, from 0 to 3.
inline constexpr const char* pedal_device = "pedal";
/// The device whose texts are what is asked of the staff, where there is such a device.
inline constexpr const char* staff_device = "staff";

struct TrackedModel {
    std::vector<std::string> instruments;  ///< of the scene, in its order: the names of their devices
    Pose registration;                     ///< from the frame of the tracked head to that of the simulated eye [mm]
};

enum class TrackingState {
    waiting,  ///< nothing was ever heard
    running,
    standing  ///< until what the simulation holds is met
};

/// Why the clock stands: "%s is lost" and of what. Both empty: nothing is wrong.
struct Standstill {
    std::string text{};
    std::string of{};
    friend bool operator==(const Standstill&, const Standstill&) = default;
};
std::string text_of(const Standstill& standstill);

class TrackedHands {
public:
    explicit TrackedHands(TrackedModel model);

    /// Names to listen to: instruments and the pedal.
    [[nodiscard]] std::vector<std::string> devices() const;

    // What is heard, with when it came by a clock of this computer that only goes forward [us].
    /// Of another device or sensor, and with numbers that make no sense: left out.
    void take(const DeviceReport& report, std::int64_t arrival_us);
    /// The link is lost, and why; empty: it is there.
    void link(const std::string& trouble);

    /// The simulation holds this, one sample of each instrument: before it goes on hands have to meet it.
    void hold(std::vector<DeviceSample> held, const Standstill& why = {});

    /// The step that stands for this moment of the same clock. inside: by instrument, of the eye; may be shorter.
    TrackingState look(std::int64_t now_us, const std::vector<bool>& inside);

    [[nodiscard]] TrackingState state() const { return state_; }
    [[nodiscard]] const Standstill& why() const { return why_; }
    /// While it runs, those of the step; else what the simulation holds. Their pedals are 0: see pedal().
    [[nodiscard]] const std::vector<DeviceSample>& samples() const { return samples_; }
    /// 0 to 3; none: no foot is heard.
    [[nodiscard]] std::optional<double> pedal() const { return pedal_now_; }
    /// By instrument, where it is seen at the moment of the last look.
    [[nodiscard]] const std::vector<std::optional<Pose>>& seen() const { return seen_; }
    /// How long ago that moment is, transit left out [us].
    [[nodiscard]] std::int64_t delay_us() const;
    /// What was asked of the staff by the moment of the last look, while it runs; each once.
    std::vector<std::string> take_asked();
    /// Times that the sender's clock was found to be set.
    [[nodiscard]] int clocks_set() const { return clocks_set_; }

private:
    void take_pose(std::size_t instrument, const DeviceReport& report, std::int64_t arrival_us);
    void take_value(std::size_t instrument, const DeviceReport& report);
    void stand(const Standstill& why);
    void advance_moment(std::int64_t now_us);
    [[nodiscard]] bool hand_held(std::size_t instrument) const;
    [[nodiscard]] bool all_met(const std::vector<bool>& inside) const;
    [[nodiscard]] bool hinders(std::size_t instrument, const std::vector<bool>& inside) const;
    [[nodiscard]] Standstill to_do(const std::vector<bool>& inside) const;
    void go_on(const std::vector<bool>& inside);
    void follow(const std::vector<bool>& inside);
    void forget_times();

    TrackedModel model_;
    ClockOffset clock_;
    std::vector<TrackedInstrument> instruments_;
    ValueTrack pedal_;
    TrackingState state_ = TrackingState::waiting;
    Standstill why_;
    std::string trouble_;
    struct Asked {
        std::int64_t time_us = 0;
        std::string text{};
    };
    std::vector<Asked> asked_;  ///< of the staff, and not yet taken
    std::string told_;          ///< an error of the tracking system that was not yet heeded
    std::vector<DeviceSample> samples_;
    std::vector<std::optional<Pose>> seen_;
    std::optional<double> pedal_now_;
    std::optional<std::int64_t> lag_us_;  ///< of the sender's moment that a step shows, behind this computer's clock
    std::int64_t now_us_ = 0;
    std::int64_t moment_us_ = 0;  ///< by the sender's clock
    int clocks_set_ = 0;
};

}  // namespace rhexis
