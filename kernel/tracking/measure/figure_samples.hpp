// SPDX-License-Identifier: GPL-3.0-or-later
// What the table of figures is made of: tracked clips of one seed after another.
#pragma once

#include "tracking/measure/calibrated_rig.hpp"
#include "tracking/measure/figures.hpp"
#include "tracking/measure/knocks.hpp"
#include "tracking/synthetic/bodies.hpp"

namespace rhexis::tracking {

/// Samples of one kind, of all seeds.
struct Gathered {
    std::vector<TipTrace> traces{};
    std::vector<double> jitters{};
    void add(const Gathered& other) {
        traces.insert(traces.end(), other.traces.begin(), other.traces.end());
        jitters.insert(jitters.end(), other.jitters.begin(), other.jitters.end());
    }
};

/// What is gathered while seeds go by.
struct Samples {
    Gathered images{};                ///< still and tremor, all cameras
    Gathered markers{};               ///< tremor, all cameras
    std::vector<Gathered> subsets{};  ///< images of the still clip: 0 two, 1 three cameras after a start with all
    Gathered still_six{};
    Gathered still_two{};
    Gathered moving{};
    Gathered occlusion{};
    std::vector<double> gains{};
    std::vector<double> lags_s{};
    std::vector<double> reacquired{};
    std::vector<double> frame_seconds{};
    std::vector<SyntheticCalibration> calibrations{};
    std::vector<KnockErrors> knocks{};
    std::int64_t identity_frames = 0;
    std::int64_t wrong = 0;
};

/// One seed's rig, as it is and as calibration has it.
struct Setting {
    MeasurePlan plan{};
    std::uint64_t seed = 0;
    synthetic::SyntheticRig rig{};
    Rig solver{};
    std::vector<MarkerBody> bodies{};

    [[nodiscard]] Result<synthetic::Clip> clip(std::string_view name) const {
        return synthetic::make_clip(name, seed, bodies, rig.nominal);
    }
    [[nodiscard]] ClipPlan clip_plan(bool images, double longest_s) const;
};

/// A rig of this seed, calibrated; the calibration goes to the samples too.
Result<Setting> setting_of(const MeasurePlan& plan, std::uint64_t seed, Samples& samples);

/// All clips of one seed.
Status measure_seed(const Setting& setting, const MeasureProgress& progress, Samples& samples);

}  // namespace rhexis::tracking
