// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/rig_calibration.hpp"

#include "tracking/calibration/lens_calibration.hpp"
#include "tracking/sources/board_source.hpp"

namespace rhexis::tracking {
namespace {

Result<std::vector<WandFrame>> watch(const Setup& setup, double seconds,
                                     const std::function<bool(const WandLook&)>& look) {
    Result<std::unique_ptr<SpotSource>> source = open_wand(setup);
    if (!source) {
        return source.error();
    }
    std::vector<WandFrame> frames;
    std::vector<CameraSpots> exposures;
    const double most = seconds * source.value()->rate_hz();
    for (double count = 0.0; count < most; count += 1.0) {
        const Result<bool> more = source.value()->next(exposures);
        if (!more) {
            return more.error();
        }
        if (!more.value()) {
            break;
        }
        frames.push_back(wand_frame(exposures, setup.wand_mm.size()));
        if (!look({count / most, exposures, source.value()->images(), frames})) {
            return Error{"it was ended before the wand was waved; nothing is written", setup.path, ""};
        }
    }
    look({1.0, exposures, source.value()->images(), frames});
    return frames;
}

Status find_lenses(const SyntheticPlan& plan, Rig& rig) {
    constexpr int views = 24;
    constexpr double noise_px = 0.02;
    const GridPlan& board = synthetic::standard_board;
    const Result<synthetic::SyntheticRig> true_rig = synthetic::SyntheticRig::create(plan.seed);
    if (!true_rig) {
        return true_rig.error();
    }
    for (std::size_t i = 0; i < rig.cameras.size() && i < true_rig.value().cameras.size(); ++i) {
        const std::vector<BoardView> held =
            synthetic::held_board(true_rig.value().cameras[i], board, views, noise_px, plan.seed * 100U + i);
        const Result<LensCalibration> lens = calibrate_lens(held, board);
        if (!lens) {
            return lens.error();
        }
        rig.cameras[i].lens = lens.value().lens;
    }
    return success();
}

}  // namespace

WandFrame wand_frame(const std::vector<CameraSpots>& exposures, std::size_t spheres) {
    constexpr double least_roundness = 0.9;
    WandFrame frame;
    for (const CameraSpots& exposure : exposures) {
        WandView view{exposure.camera, {}};
        for (const Spot& spot : exposure.spots) {
            if (!spot.at_rim && !spot.crowded && spot.roundness > least_roundness) {
                view.spots.push_back(spot.at);
            }
        }
        if (view.spots.size() == spheres) {
            frame.views.push_back(std::move(view));
        }
    }
    return frame;
}

Result<CalibrationReport> calibrate_setup(const Setup& setup, double seconds, bool refine_lenses,
                                          const std::function<bool(const WandLook&)>& look) {
    Rig given = setup.rig;
    if (const auto* synthetic = std::get_if<SyntheticPlan>(&setup.source); synthetic && setup.rig.lenses.empty()) {
        if (const Status found = find_lenses(*synthetic, given); !found) {
            return found.error();
        }
    }
    const Result<std::vector<WandFrame>> frames = watch(setup, seconds, look);
    if (!frames) {
        return frames.error();
    }
    Wand wand;
    wand.at_mm = setup.wand_mm;
    wand.radius_mm = setup.wand_radius_mm;
    WandSettings settings;
    settings.refine_lenses = refine_lenses;
    Result<WandCalibration> calibrated = calibrate_wand(given, wand, frames.value(), settings);
    if (!calibrated) {
        return calibrated.error();
    }
    CalibrationReport report;
    report.title = setup.rig_path;
    report.coverage = wand_coverage(calibrated.value().rig, frames.value());
    report.wand = std::move(calibrated).value();
    report.wand.rig.calibrated = true;
    report.wand.rig.lenses = setup.rig.lenses;
    return report;
}

}  // namespace rhexis::tracking
