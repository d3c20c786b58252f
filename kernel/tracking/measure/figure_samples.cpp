// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/figure_samples.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/clock.hpp"
#include "tracking/sources/synthetic_source.hpp"

namespace rhexis::tracking {
namespace {

constexpr double rate_hz = 120.0;

/// Of instruments; the head is told in the rig, whose frame is the calibration's.
Gathered instruments_of(const Setting& setting, const ClipRun& run) {
    Gathered result;
    for (std::size_t i = 0; i < setting.bodies.size(); ++i) {
        if (setting.bodies[i].name != "head") {
            result.traces.push_back(run.traces[i]);
            const double spread = jitter(run.traces[i]);
            if (std::isfinite(spread)) {
                result.jitters.push_back(spread);
            }
        }
    }
    return result;
}

/// Without what was seen while all cameras were there.
void cut_start(ClipRun& run, double from_s) {
    for (TipTrace& trace : run.traces) {
        std::erase_if(trace, [from_s](const TipSample& sample) { return sample.time_s < from_s; });
    }
}

Result<Gathered> with_cameras(const Setting& setting, const synthetic::Clip& clip,
                              const std::vector<std::vector<CameraSpots>>& recorded, const std::vector<int>& used) {
    constexpr double from_s = 0.1;
    const std::vector<std::vector<CameraSpots>> fewer = only_cameras(recorded, used, from_s);
    RecordedSpots source(fewer, rate_hz);
    Result<ClipRun> run = track_spots(source, setting.solver, clip, setting.clip_plan(false, 1e9));
    if (!run) {
        return run.error();
    }
    cut_start(run.value(), from_s);
    return instruments_of(setting, run.value());
}

/// All of it for six cameras, all pairs and all triples, of the same images.
Status measure_images(const Setting& setting, Samples& samples) {
    for (const std::string_view name : {"still", "tremor"}) {
        const Result<synthetic::Clip> clip = setting.clip(name);
        if (!clip) {
            return clip.error();
        }
        const auto recorded = record_spots(setting.rig, clip.value(), setting.clip_plan(true, setting.plan.image_s));
        if (!recorded) {
            return recorded.error();
        }
        RecordedSpots source(recorded.value(), rate_hz);
        const Result<ClipRun> run = track_spots(source, setting.solver, clip.value(), setting.clip_plan(false, 1e9));
        if (!run) {
            return run.error();
        }
        const Gathered all = instruments_of(setting, run.value());
        samples.images.add(all);
        if (name == "still") {
            samples.still_six.add(all);
        }
        for (int first = 0; first < 6; ++first) {
            for (int second = first + 1; second < 6; ++second) {
                const int third = (second + 1) % 6 == first ? (second + 2) % 6 : (second + 1) % 6;
                const Result<Gathered> two = with_cameras(setting, clip.value(), recorded.value(), {first, second});
                const Result<Gathered> three =
                    with_cameras(setting, clip.value(), recorded.value(), {first, second, third});
                if (!two || !three) {
                    return two ? three.error() : two.error();
                }
                samples.subsets[0].add(two.value());
                samples.subsets[1].add(three.value());
                if (name == "still") {
                    samples.still_two.add(two.value());
                }
            }
        }
    }
    return success();
}

Status measure_tremor(const Setting& setting, Samples& samples) {
    const Result<synthetic::Clip> clip = setting.clip("tremor");
    if (!clip) {
        return clip.error();
    }
    const Result<ClipRun> run = track_clip(setting.rig, setting.solver, clip.value(), setting.clip_plan(false, 1e9));
    if (!run) {
        return run.error();
    }
    samples.markers.add(instruments_of(setting, run.value()));
    for (std::size_t i = 0; i < setting.bodies.size(); ++i) {
        if (setting.bodies[i].name == "head") {
            continue;
        }
        for (const synthetic::Wave& wave : clip.value().motions[i].moves) {
            if (wave.frequency_hz >= 6.0) {
                const WaveResponse wave_response = response(run.value().traces[i], wave.frequency_hz);
                samples.gains.push_back(wave_response.gain);
                samples.lags_s.push_back(wave_response.lag_s);
            }
        }
    }
    return success();
}

/// At up to 100 mm/s, while cameras expose 5 ms after one another.
Status measure_moving(const Setting& setting, Samples& samples) {
    constexpr double share_of_clip = 0.2;  // which goes at up to 500 mm/s
    Result<synthetic::Clip> clip = setting.clip("insertions");
    if (!clip) {
        return clip.error();
    }
    for (synthetic::Motion& motion : clip.value().motions) {
        for (synthetic::Wave& wave : motion.moves) {
            wave.amplitude *= share_of_clip;
        }
    }
    ClipPlan plan = setting.clip_plan(false, setting.plan.marker_s);
    plan.delivery.skew_s = 5e-3;
    const Result<ClipRun> run = track_clip(setting.rig, setting.solver, clip.value(), plan);
    if (!run) {
        return run.error();
    }
    samples.moving.add(instruments_of(setting, run.value()));
    return success();
}

Status measure_occlusion(const Setting& setting, Samples& samples) {
    for (const std::string_view name : {"occlusion", "crossing"}) {
        const Result<synthetic::Clip> clip = setting.clip(name);
        if (!clip) {
            return clip.error();
        }
        const Result<ClipRun> run =
            track_clip(setting.rig, setting.solver, clip.value(), setting.clip_plan(false, 1e9));
        if (!run) {
            return run.error();
        }
        samples.wrong += run.value().wrong;
        samples.identity_frames += static_cast<std::int64_t>(run.value().traces[0].size());
        if (name == "occlusion") {
            samples.occlusion.add(instruments_of(setting, run.value()));
        }
    }
    return success();
}

/// Exposures from when all cameras are free again until each body is seen; they were blocked long enough to lose it.
Status measure_reacquiring(const Setting& setting, Samples& samples) {
    constexpr double blocked_s = 0.35;
    Result<synthetic::Clip> clip = setting.clip("tremor");
    if (!clip) {
        return clip.error();
    }
    std::vector<double> free_s;
    for (int gap = 0; gap < 5; ++gap) {
        const double begin_s = 0.3 + 0.7 * gap;
        free_s.push_back(begin_s + blocked_s);
        for (int camera = 0; camera < 6; ++camera) {
            clip.value().covers.push_back({camera, -1, -1, begin_s, begin_s + blocked_s});
        }
    }
    const Result<ClipRun> run = track_clip(setting.rig, setting.solver, clip.value(), setting.clip_plan(false, 4.0));
    if (!run) {
        return run.error();
    }
    for (const TipTrace& trace : run.value().traces) {
        for (const double since_s : free_s) {
            double waited = 0.0;
            for (const TipSample& sample : trace) {
                if (sample.time_s >= since_s) {
                    waited += 1.0;
                    if (sample.seen) {
                        break;
                    }
                }
            }
            samples.reacquired.push_back(waited);
        }
    }
    return success();
}

/// From six images that are in memory to poses, on this thread.
Status measure_compute(const Setting& setting, Samples& samples) {
    const Result<synthetic::Clip> clip = setting.clip("tremor");
    if (!clip) {
        return clip.error();
    }
    synthetic::Stage stage;
    stage.scene = [&clip](double time_s, synthetic::Scene& scene) { scene_at(clip.value(), time_s, scene); };
    synthetic::Film film;
    film.seed = setting.seed;
    film.frames = 60;
    const Result<std::unique_ptr<FrameSource>> source = film_images(setting.rig, stage, film);
    if (!source) {
        return source.error();
    }
    Tracker tracker(setting.solver, setting.bodies, 0, TrackerSettings{});
    SpotFinder finder(SpotSettings{});
    FrameSet set;
    for (;;) {
        const Result<bool> more = source.value()->next(set);
        if (!more) {
            return more.error();
        }
        if (!more.value()) {
            return success();
        }
        const double begun_s = thread_cpu_seconds();
        std::vector<CameraSpots> exposures;
        for (const CameraFrame& frame : set.frames) {
            exposures.push_back({frame.camera, frame.time_s, finder.find(frame.view()).spots});
        }
        tracker.step(exposures);
        samples.frame_seconds.push_back(thread_cpu_seconds() - begun_s);
    }
}

Status add_knock(const Setting& setting, Samples& samples) {
    const Result<KnockErrors> errors = measure_knock(setting.rig, setting.solver, setting.bodies, setting.seed);
    if (!errors) {
        return errors.error();
    }
    samples.knocks.push_back(errors.value());
    return success();
}

/// Crossings, over and over with other noise, until enough exposures were looked at.
Status measure_identity(const Setting& setting, std::int64_t frames, Samples& samples) {
    const Result<synthetic::Clip> clip = setting.clip("crossing");
    if (!clip) {
        return clip.error();
    }
    std::uint64_t noise = setting.seed * 1000;
    for (std::int64_t done = 0; done < frames;) {
        ClipPlan plan = setting.clip_plan(false, 1e9);
        plan.seed = ++noise;
        const Result<ClipRun> run = track_clip(setting.rig, setting.solver, clip.value(), plan);
        if (!run) {
            return run.error();
        }
        done += static_cast<std::int64_t>(run.value().traces[0].size());
        samples.wrong += run.value().wrong;
        samples.identity_frames += static_cast<std::int64_t>(run.value().traces[0].size());
    }
    return success();
}

}  // namespace

ClipPlan Setting::clip_plan(bool images, double longest_s) const {
    ClipPlan result;
    result.seed = seed;
    result.images = images;
    result.longest_s = longest_s;
    result.delivery.rate_hz = rate_hz;
    return result;
}

Result<Setting> setting_of(const MeasurePlan& plan, std::uint64_t seed, Samples& samples) {
    Result<synthetic::SyntheticRig> rig = synthetic::SyntheticRig::create(seed);
    if (!rig) {
        return rig.error();
    }
    CalibrationPlan calibration;
    calibration.seed = seed;
    Result<SyntheticCalibration> calibrated = calibrate_synthetic(rig.value(), calibration);
    if (!calibrated) {
        return calibrated.error();
    }
    samples.calibrations.push_back(calibrated.value());
    return Setting{plan, seed, std::move(rig).value(), std::move(calibrated.value().rig), synthetic::standard_bodies()};
}

Status measure_seed(const Setting& setting, const MeasureProgress& progress, Samples& samples) {
    const std::string seed = "seed " + std::to_string(setting.seed) + ": ";
    const std::int64_t identity_frames = setting.plan.identity_frames / setting.plan.seeds;
    const std::vector<std::pair<const char*, std::function<Status()>>> parts{
        {"images", [&] { return measure_images(setting, samples); }},
        {"tremor", [&] { return measure_tremor(setting, samples); }},
        {"moving", [&] { return measure_moving(setting, samples); }},
        {"occlusion", [&] { return measure_occlusion(setting, samples); }},
        {"finding again", [&] { return measure_reacquiring(setting, samples); }},
        {"compute", [&] { return measure_compute(setting, samples); }},
        {"a knocked camera", [&] { return add_knock(setting, samples); }},
        {"identity", [&] { return measure_identity(setting, identity_frames, samples); }}};
    for (const auto& [what, measure] : parts) {
        progress(seed + what);
        if (Status status = measure(); !status) {
            return status;
        }
    }
    return success();
}

}  // namespace rhexis::tracking
