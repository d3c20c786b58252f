// SPDX-License-Identifier: GPL-3.0-or-later
// How far off tracked tips are, against what the synthetic rig put before its cameras.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "tracking/sources/spot_source.hpp"
#include "tracking/spots/spot_finder.hpp"
#include "tracking/synthetic/clips.hpp"
#include "tracking/tracker.hpp"

namespace rhexis::tracking {

struct ErrorFigures {
    std::int64_t frames = 0;  ///< in which it should have been there
    std::int64_t valid = 0;   ///< in which it was told as seen
    double mean = 0.0;        ///< of what was told
    double rms = 0.0;
    double of_95 = 0.0;   ///< 95 of 100 are no farther off
    double of_999 = 0.0;  ///< 999 of 1000
    double worst = 0.0;
};
ErrorFigures figures_of(std::vector<double> errors, std::int64_t frames);

/// The value that this share (0 to 1) of the values does not exceed; 0 of none. Sorted: they rise.
double share_of_sorted(const std::vector<double>& sorted, double share);
double share_of(std::vector<double> values, double share);

/// A tip at one exposure, relative to the head.
struct TipSample {
    double time_s = 0.0;
    bool seen = false;
    Pose is{};    ///< as it was
    Pose told{};  ///< as it was tracked
    int cameras = 0;
};

/// Of one body, exposure by exposure.
using TipTrace = std::vector<TipSample>;

struct ClipRun {
    std::vector<TipTrace> traces{};  ///< by body
    std::vector<double> seconds{};   ///< that each exposure took, from spots or images to poses
    int wrong = 0;                   ///< bodies told as seen farther off than 5 mm
};

struct ClipPlan {
    std::uint64_t seed = 1;
    bool images = true;          ///< else from markers, without images
    std::vector<int> cameras{};  ///< that are used; empty: all
    double longest_s = 1e9;
    TrackerSettings tracker{};
    SpotSettings spots{};
    synthetic::Delivery delivery{};
};

/// Tracks a clip with `solver`, what calibration made of the rig. The error is that of the synthetic rig.
Result<ClipRun> track_clip(const synthetic::SyntheticRig& rig, const Rig& solver, const synthetic::Clip& clip,
                           const ClipPlan& plan);

/// Likewise of spots that come from elsewhere; `plan` says which cameras and what tracker.
Result<ClipRun> track_spots(SpotSource& source, const Rig& solver, const synthetic::Clip& clip, const ClipPlan& plan);

/// The spots of a clip, exposure by exposure, to be tracked again and again.
Result<std::vector<std::vector<CameraSpots>>> record_spots(const synthetic::SyntheticRig& rig,
                                                           const synthetic::Clip& clip, const ClipPlan& plan);

/// Of these exposures what some cameras saw; before `from_s`, while bodies are found, what all saw.
std::vector<std::vector<CameraSpots>> only_cameras(std::vector<std::vector<CameraSpots>> recorded,
                                                   const std::vector<int>& used, double from_s);

/// Spots that were recorded, once more.
class RecordedSpots final : public SpotSource {
public:
    /// `exposures` outlives it.
    RecordedSpots(const std::vector<std::vector<CameraSpots>>& exposures, double rate_hz)
        : exposures_(exposures), rate_hz_(rate_hz) {}

    Result<bool> next(std::vector<CameraSpots>& exposures) override;
    [[nodiscard]] double rate_hz() const override { return rate_hz_; }

private:
    const std::vector<std::vector<CameraSpots>>& exposures_;
    double rate_hz_;
    std::size_t next_ = 0;
};

/// Millimetres from where a tip was to where it was told; after the first `after_s`.
ErrorFigures tip_errors(const TipTrace& trace, double after_s = 0.1);
/// Degrees between the axis that was and the one that was told.
double axis_off_deg(const TipSample& sample);
ErrorFigures axis_errors(const TipTrace& trace, double after_s = 0.1);
/// Standard deviation of the tip about its mean, of the axis where it is greatest [mm].
double jitter(const TipTrace& trace, double after_s = 0.1);

/// What tracking makes of a wave in the tip's motion.
struct WaveResponse {
    double frequency_hz = 0.0;
    double gain = 0.0;  ///< amplitude told by amplitude that was
    double lag_s = 0.0;
};
WaveResponse response(const TipTrace& trace, double frequency_hz, double after_s = 0.1);

}  // namespace rhexis::tracking
