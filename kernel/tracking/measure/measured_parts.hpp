// SPDX-License-Identifier: GPL-3.0-or-later
// What the tables of figures are made of: for each seed one part after another, each of which stands alone.
#pragma once

#include <functional>

#include "tracking/measure/calibrated_rig.hpp"
#include "tracking/measure/figures.hpp"
#include "tracking/measure/kept_parts.hpp"
#include "tracking/synthetic/bodies.hpp"

namespace rhexis::tracking {

/// One seed's rig, as it is and as calibration has it.
struct Setting {
    MeasurePlan plan{};
    std::uint64_t seed = 0;
    synthetic::SyntheticRig rig{};
    SyntheticCalibration calibration{};
    std::vector<MarkerBody> bodies{};

    [[nodiscard]] const Rig& solver() const { return calibration.rig; }
    [[nodiscard]] Result<synthetic::Clip> clip(std::string_view name) const {
        return synthetic::make_clip(name, seed, bodies, rig.nominal);
    }
    [[nodiscard]] ClipPlan clip_plan(bool images, double longest_s) const;
};

/// A rig of this seed, calibrated by boards and wand.
Result<Setting> setting_of(const MeasurePlan& plan, std::uint64_t seed);

struct Part {
    std::string name{};
    std::string plan{};   ///< what of MeasurePlan it depends on
    bool images = false;  ///< it renders, which takes long
    std::function<Result<Numbers>(const Setting&)> measure{};
};

/// All parts of a seed, each of which gives rows whose names no other has.
std::vector<Part> measured_parts(const MeasurePlan& plan);

/// Rows of what instruments' tips were off after 0.1 s, exposure by exposure: "NAME.tip_mm" and "NAME.axis_deg" of
/// those that were told as seen, "NAME.by4.tip_mm" of those that four cameras saw, and "NAME.seen", 1 or 0, of all.
void add_tips(const std::vector<MarkerBody>& bodies, const ClipRun& run, const std::string& name, Numbers& numbers);
/// "NAME.jitter_mm", as jitter(), one of each instrument.
void add_jitters(const std::vector<MarkerBody>& bodies, const ClipRun& run, const std::string& name, Numbers& numbers);

// Parts, each in a file with its name.
Result<Numbers> measure_images(const Setting& setting);
Result<Numbers> measure_compute(const Setting& setting);
Result<Numbers> measure_tremor(const Setting& setting);
Result<Numbers> measure_moving(const Setting& setting);
Result<Numbers> measure_hidden(const Setting& setting);
Result<Numbers> measure_found_again(const Setting& setting);
Result<Numbers> measure_head(const Setting& setting);
/// `number`: which of a seed's chunks, each with other noise and other crossings.
Result<Numbers> measure_identity(const Setting& setting, int number, int exposures);

}  // namespace rhexis::tracking
