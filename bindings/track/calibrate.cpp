// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis track calibrate and pivot.
#include <cstdio>

#include "base/output_file.hpp"
#include "track/camera_views.hpp"
#include "track/commands.hpp"
#include "track/onlooker.hpp"
#include "track/page.hpp"
#include "tracking/calibration/pivot.hpp"
#include "tracking/calibration/rig_calibration.hpp"
#include "trial/progress.hpp"

namespace rhexis::tracking {
namespace {

Onlooker::Painter painter_of(const Setup& setup, const WandLook& look) {
    return [&setup, view = view_of(setup.rig, look)](const ScreenWish& wish, ScreenMoment& moment) {
        moment = moment_of(setup, view, wish);
    };
}

/// shown: whether the window's picture was kept where it was asked for.
Result<CalibrationReport> calibrated(const CalibrateOptions& options, const Setup& setup, Status& shown) {
    const Result<std::unique_ptr<Onlooker>> opened = Onlooker::open(options.screen, options.open_screen);
    if (!opened) {
        return opened.error();
    }
    Onlooker* const onlooker = opened.value().get();
    Onlooker::Painter last;
    Progress progress("calibrate");
    Result<CalibrationReport> report =
        calibrate_setup(setup, options.seconds, options.refine_lenses, [&](const WandLook& look) {
            progress.show(look.share, wand_advice);
            if (onlooker != nullptr && look.share >= 1.0) {
                last = painter_of(setup, look);
            } else if (onlooker != nullptr && onlooker->wants()) {
                onlooker->show(painter_of(setup, look));
            }
            return onlooker == nullptr || !onlooker->closed();
        });
    shown = report && onlooker != nullptr ? onlooker->finish(last) : success();
    return report;
}

}  // namespace

Status calibrate(const CalibrateOptions& options) {
    const Result<Setup> setup = read_setup(options.setup);
    if (!setup) {
        return setup.error();
    }
    Status shown = success();
    const Result<CalibrationReport> report = calibrated(options, setup.value(), shown);
    if (!report) {
        return report.error();
    }
    const std::string rig = options.rig.empty() ? setup.value().rig_path : options.rig;
    const std::string page = page_beside(rig, options.page);
    if (const Status written = write_rig(report.value().wand.rig, rig); !written) {
        return written.error();
    }
    if (const Status written = write_file(page, calibration_page(report.value())); !written) {
        return written.error();
    }
    const WandCalibration& wand = report.value().wand;
    std::printf("%s: residual %.3f pixels, scale to %.4f %%, %d exposures (%d left out), %.2f s\n", rig.c_str(),
                wand.residual_px, 100.0 * wand.scale_sigma, wand.frames_used, wand.frames_dropped, wand.seconds);
    for (const std::string& advice : calibration_advice(report.value())) {
        std::printf("  %s\n", advice.c_str());
    }
    std::printf("%s\n", page.c_str());
    return shown;
}

namespace {

Result<std::vector<Pose>> poses_of(const Setup& setup, int body, double seconds) {
    Result<std::unique_ptr<SpotSource>> source = open_source(setup);
    if (!source) {
        return source.error();
    }
    // In the rig, so that a head that is not there is not missed.
    Tracker tracker(setup.rig, setup.bodies, std::nullopt, TrackerSettings{});
    std::vector<CameraSpots> exposures;
    std::vector<Pose> poses;
    Progress progress("pivot");
    for (;;) {
        const Result<bool> more = source.value()->next(exposures);
        if (!more) {
            return more.error();
        }
        if (!more.value()) {
            return poses;
        }
        const TrackedBodies& told = tracker.step(exposures);
        const TrackedBody& one = told.bodies[static_cast<std::size_t>(body)];
        if (one.seen == Seen::seen) {
            poses.push_back(one.pose);
        }
        progress.show(told.time_s / seconds, "turn it about its tip");
        if (told.time_s >= seconds) {
            return poses;
        }
    }
}

Result<int> body_named(const Setup& setup, const std::string& name) {
    std::string known;
    for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
        if (setup.bodies[i].name == name) {
            return static_cast<int>(i);
        }
        known += (known.empty() ? "" : ", ") + setup.bodies[i].name;
    }
    return Error{"there is no body \"" + name + "\"", setup.path, known};
}

}  // namespace

Status pivot(const PivotOptions& options) {
    Result<Setup> setup = read_setup(options.setup);
    if (!setup) {
        return setup.error();
    }
    const Result<int> index = body_named(setup.value(), options.body);
    if (!index) {
        return index.error();
    }
    const Result<std::vector<Pose>> poses = poses_of(setup.value(), index.value(), options.seconds);
    if (!poses) {
        return poses.error();
    }
    const Result<PivotCalibration> found = calibrate_pivot(poses.value());
    if (!found) {
        return found.error();
    }
    const auto place = static_cast<std::size_t>(index.value());
    MarkerBody& body = setup.value().bodies[place];
    body.tip.position = found.value().tip;
    const std::string& path = setup.value().body_paths[place];
    if (const Status written = write_marker_body(body, path); !written) {
        return written.error();
    }
    std::printf("%s: tip at %.3f %.3f %.3f mm, to %.3f mm (%zu poses, residual %.3f mm)\n", path.c_str(),
                body.tip.position.x(), body.tip.position.y(), body.tip.position.z(), found.value().tip_sigma_mm,
                poses.value().size(), found.value().residual_mm);
    return success();
}

}  // namespace rhexis::tracking
