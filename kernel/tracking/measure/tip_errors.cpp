// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/tip_errors.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/clock.hpp"
#include "math/poses.hpp"
#include "tracking/sources/synthetic_source.hpp"

namespace rhexis::tracking {
namespace {

std::optional<int> head_of(const std::vector<MarkerBody>& bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies[i].name == "head") {
            return static_cast<int>(i);
        }
    }
    return std::nullopt;
}

synthetic::Stage stage_of(const synthetic::SyntheticRig& rig, const synthetic::Clip& clip) {
    synthetic::Stage stage;
    stage.scene = [&clip](double time_s, synthetic::Scene& scene) { scene_at(clip, time_s, scene); };
    stage.camera = [&clip, &rig](int camera, double time_s) { return camera_at(clip, rig, camera, time_s); };
    return stage;
}

Result<std::unique_ptr<SpotSource>> source_of(const synthetic::SyntheticRig& rig, const synthetic::Clip& clip,
                                              const ClipPlan& plan) {
    synthetic::Film film;
    film.seed = plan.seed;
    film.delivery = plan.delivery;
    film.frames = static_cast<int>(std::min(plan.longest_s, clip.duration_s) * plan.delivery.rate_hz);
    if (!plan.images) {
        return film_markers(rig, stage_of(rig, clip), film);
    }
    Result<std::unique_ptr<FrameSource>> frames = film_images(rig, stage_of(rig, clip), film);
    if (!frames) {
        return frames.error();
    }
    return std::unique_ptr<SpotSource>(std::make_unique<ImageSpots>(std::move(frames).value(), plan.spots));
}

void leave_out(const std::vector<int>& used, std::vector<CameraSpots>& exposures) {
    if (!used.empty()) {
        std::erase_if(exposures, [&used](const CameraSpots& exposure) {
            return std::find(used.begin(), used.end(), exposure.camera) == used.end();
        });
    }
}

void add_samples(const synthetic::Clip& clip, const TrackedBodies& told, std::optional<int> head, ClipRun& run) {
    constexpr double wrong_mm = 5.0;
    for (std::size_t i = 0; i < told.bodies.size(); ++i) {
        const TrackedBody& body = told.bodies[i];
        const Pose tip = tip_at(clip, static_cast<int>(i), told.time_s);
        const bool itself = head && static_cast<int>(i) == *head;
        TipSample sample;
        sample.time_s = told.time_s;
        sample.seen = body.seen == Seen::seen;
        sample.is = head && !itself ? relative(tip_at(clip, *head, told.time_s), tip) : tip;
        sample.told = body.tip;
        sample.cameras = body.cameras;
        run.wrong += sample.seen && (sample.is.position - sample.told.position).norm() > wrong_mm ? 1 : 0;
        run.traces[i].push_back(sample);
    }
}

std::vector<double> collect(const TipTrace& trace, double after_s, std::int64_t& frames,
                            double (*of)(const TipSample&)) {
    std::vector<double> values;
    frames = 0;
    for (const TipSample& sample : trace) {
        if (sample.time_s >= after_s) {
            ++frames;
            if (sample.seen) {
                values.push_back(of(sample));
            }
        }
    }
    return values;
}

}  // namespace

double share_of_sorted(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) {
        return 0.0;
    }
    const auto index = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted[std::clamp<std::size_t>(index, 1, sorted.size()) - 1];
}

double share_of(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return share_of_sorted(values, share);
}

ErrorFigures figures_of(std::vector<double> errors, std::int64_t frames) {
    ErrorFigures figures;
    figures.frames = frames;
    figures.valid = static_cast<std::int64_t>(errors.size());
    if (errors.empty()) {
        return figures;
    }
    std::sort(errors.begin(), errors.end());
    double squares = 0.0;
    for (const double error : errors) {
        figures.mean += error / static_cast<double>(errors.size());
        squares += error * error;
    }
    figures.rms = std::sqrt(squares / static_cast<double>(errors.size()));
    figures.of_95 = share_of_sorted(errors, 0.95);
    figures.of_999 = share_of_sorted(errors, 0.999);
    figures.worst = errors.back();
    return figures;
}

Result<ClipRun> track_clip(const synthetic::SyntheticRig& rig, const Rig& solver, const synthetic::Clip& clip,
                           const ClipPlan& plan) {
    const Result<std::unique_ptr<SpotSource>> source = source_of(rig, clip, plan);
    if (!source) {
        return source.error();
    }
    return track_spots(*source.value(), solver, clip, plan);
}

Result<std::vector<std::vector<CameraSpots>>> record_spots(const synthetic::SyntheticRig& rig,
                                                           const synthetic::Clip& clip, const ClipPlan& plan) {
    const Result<std::unique_ptr<SpotSource>> source = source_of(rig, clip, plan);
    if (!source) {
        return source.error();
    }
    std::vector<std::vector<CameraSpots>> recorded;
    std::vector<CameraSpots> exposures;
    for (;;) {
        const Result<bool> more = source.value()->next(exposures);
        if (!more) {
            return more.error();
        }
        if (!more.value()) {
            return recorded;
        }
        recorded.push_back(exposures);
    }
}

std::vector<std::vector<CameraSpots>> only_cameras(std::vector<std::vector<CameraSpots>> recorded,
                                                   const std::vector<int>& used, double from_s) {
    for (std::vector<CameraSpots>& exposures : recorded) {
        std::erase_if(exposures, [&used, from_s](const CameraSpots& exposure) {
            return exposure.time_s >= from_s && std::find(used.begin(), used.end(), exposure.camera) == used.end();
        });
    }
    return recorded;
}

Result<bool> RecordedSpots::next(std::vector<CameraSpots>& exposures) {
    exposures.clear();
    if (next_ == exposures_.size()) {
        return false;
    }
    exposures = exposures_[next_++];
    return true;
}

Result<ClipRun> track_spots(SpotSource& source, const Rig& solver, const synthetic::Clip& clip, const ClipPlan& plan) {
    const std::optional<int> head = head_of(clip.bodies);
    Tracker tracker(solver, clip.bodies, head, plan.tracker);
    ClipRun run;
    run.traces.resize(clip.bodies.size());
    std::vector<CameraSpots> exposures;
    for (;;) {
        const Result<bool> more = source.next(exposures);
        if (!more) {
            return more.error();
        }
        if (!more.value()) {
            return run;
        }
        leave_out(plan.cameras, exposures);
        const double begun_s = thread_cpu_seconds();
        const TrackedBodies& told = tracker.step(exposures);
        run.seconds.push_back(thread_cpu_seconds() - begun_s);
        add_samples(clip, told, head, run);
    }
}

ErrorFigures tip_errors(const TipTrace& trace, double after_s) {
    std::int64_t frames = 0;
    std::vector<double> errors = collect(trace, after_s, frames, [](const TipSample& sample) {
        return (sample.told.position - sample.is.position).norm();
    });
    return figures_of(std::move(errors), frames);
}

double axis_off_deg(const TipSample& sample) {
    const Vec3 is = sample.is.orientation * Vec3::UnitZ();
    const Vec3 told = sample.told.orientation * Vec3::UnitZ();
    return std::atan2(is.cross(told).norm(), is.dot(told)) * 180.0 / std::numbers::pi;
}

ErrorFigures axis_errors(const TipTrace& trace, double after_s) {
    std::int64_t frames = 0;
    std::vector<double> errors = collect(trace, after_s, frames, axis_off_deg);
    return figures_of(std::move(errors), frames);
}

double jitter(const TipTrace& trace, double after_s) {
    Vec3 sum = Vec3::Zero();
    Vec3 squares = Vec3::Zero();
    double count = 0.0;
    for (const TipSample& sample : trace) {
        if (sample.seen && sample.time_s >= after_s) {
            const Vec3 off = sample.told.position - sample.is.position;
            sum += off;
            squares += off.cwiseAbs2();
            count += 1.0;
        }
    }
    const Vec3 variance = squares / count - (sum / count).cwiseAbs2();
    return std::sqrt(std::max(variance.maxCoeff(), 0.0));
}

WaveResponse response(const TipTrace& trace, double frequency_hz, double after_s) {
    using Complex = std::complex<double>;
    const double turn = 2.0 * std::numbers::pi * frequency_hz;
    std::array<Complex, 3> is{};
    std::array<Complex, 3> told{};
    Vec3 is_mean = Vec3::Zero();
    Vec3 told_mean = Vec3::Zero();
    double count = 0.0;
    for (const TipSample& sample : trace) {
        if (sample.seen && sample.time_s >= after_s) {
            is_mean += sample.is.position;
            told_mean += sample.told.position;
            count += 1.0;
        }
    }
    for (const TipSample& sample : trace) {
        if (sample.seen && sample.time_s >= after_s) {
            const Complex wave = std::polar(1.0, -turn * sample.time_s);
            for (std::size_t i = 0; i < 3; ++i) {
                const auto axis = static_cast<Eigen::Index>(i);
                is[i] += wave * (sample.is.position[axis] - is_mean[axis] / count);
                told[i] += wave * (sample.told.position[axis] - told_mean[axis] / count);
            }
        }
    }
    // The one factor that brings what was to what was told, over all axes.
    Complex both = 0.0;
    double power = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        both += std::conj(is[i]) * told[i];
        power += std::norm(is[i]);
    }
    const Complex factor = both / power;
    return {frequency_hz, std::abs(factor), -std::arg(factor) / turn};
}

}  // namespace rhexis::tracking
