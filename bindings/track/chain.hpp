// SPDX-License-Identifier: GPL-3.0-or-later
// The whole chain in one process, by simulated time: hands, markers, cameras, spots, poses, the wire's bytes, clocks
// compared, samples. The same code as that of two computers, but for sockets and the wall clock.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>

#include "base/rng.hpp"
#include "input/tracked_hands.hpp"
#include "track/track_options.hpp"
#include "tracking/setup.hpp"
#include "tracking/sources/synthetic_source.hpp"
#include "trial/sample_link.hpp"

namespace rhexis::tracking {

class Chain final : public SampleLink {
public:
    /// The error: that of read_setup(), a setup whose source is not synthetic, or a rig that is not calibrated.
    static Result<std::unique_ptr<Chain>> open(const ChainOptions& options);

    Status begin(const std::vector<std::string>& instruments, double step_s) override;
    Result<std::vector<DeviceSample>> through(std::span<const DeviceSample> hands) override;

    [[nodiscard]] LinkFigures figures() const override;

private:
    /// A report on its way, by when it comes.
    struct OnItsWay {
        std::int64_t arrival_us = 0;
        DeviceReport report{};
    };
    /// An instrument that is tracked.
    struct Hand {
        int instrument = 0;  ///< of the scene
        int body = 0;
        Pose before{};  ///< the tip at the last step's end
        bool was_there = false;
    };

    Chain(Setup setup, synthetic::SyntheticRig rig, std::uint64_t seed);
    void expose(double time_s, std::span<const DeviceSample> hands);
    void place(double time_s, std::span<const DeviceSample> hands, synthetic::Scene& scene) const;
    void look(int camera, double time_s, std::span<const DeviceSample> hands, CameraSpots& exposure);
    void tell(const TrackedBodies& told, double time_s);
    void send(DeviceReport report, double time_s);
    void deliver(std::int64_t until_us);

    Setup setup_;
    synthetic::SyntheticRig rig_;
    Tracker tracker_;
    SpotFinder finder_;
    Rng rng_;
    std::vector<Hand> hands_{};
    std::vector<int> tracked_of_{};  ///< by instrument of the scene: its place among `hands_`; -1: it is not tracked
    std::optional<TrackedHands> input_{};
    std::deque<OnItsWay> on_their_way_{};
    std::map<std::string, double> jaws_{};  ///< last told
    double step_s_ = 0.01;
    double time_s_ = 0.0;     ///< of the last step's end
    double exposed_s_ = 0.0;  ///< of the last exposure
    std::vector<synthetic::SensorPattern> patterns_{};
    synthetic::RenderScratch render_{};
    synthetic::SpotScratch markers_{};
    synthetic::Image image_{};
    std::vector<synthetic::Scene> instants_{};
    std::vector<bool> is_tracked_{};  ///< by instrument of the scene
    LinkTally tally_{};
};

}  // namespace rhexis::tracking
