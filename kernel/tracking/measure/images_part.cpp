// SPDX-License-Identifier: GPL-3.0-or-later
// Clips that are rendered: tips by six, three and two cameras, and the same clips without images beside them.
#include <cmath>
#include <map>
#include <numeric>

#include "base/clock.hpp"
#include "tracking/measure/measured_parts.hpp"
#include "tracking/measure/spot_errors.hpp"
#include "tracking/sources/synthetic_source.hpp"

namespace rhexis::tracking {
namespace {

using Recorded = std::vector<std::vector<CameraSpots>>;

Result<ClipRun> tracked_again(const Setting& setting, const synthetic::Clip& clip, const Recorded& recorded) {
    const ClipPlan plan = setting.clip_plan(false, 1e9);
    RecordedSpots source(recorded, plan.delivery.rate_hz);
    return track_spots(source, setting.solver(), clip, plan);
}

/// After a start with all cameras, without what these saw.
Result<ClipRun> tracked_by(const Setting& setting, const synthetic::Clip& clip, const Recorded& recorded,
                           const std::vector<int>& used) {
    constexpr double from_s = 0.1;
    Result<ClipRun> run = tracked_again(setting, clip, only_cameras(recorded, used, from_s));
    if (run) {
        for (TipTrace& trace : run.value().traces) {
            std::erase_if(trace, [](const TipSample& sample) { return sample.time_s < from_s; });
        }
    }
    return run;
}

/// Of all pairs, and of each with a third camera beside it.
Status add_fewer_cameras(const Setting& setting, const synthetic::Clip& clip, const Recorded& recorded,
                         Numbers& numbers) {
    const int cameras = static_cast<int>(setting.rig.cameras.size());
    for (int first = 0; first < cameras; ++first) {
        for (int second = first + 1; second < cameras; ++second) {
            int third = (second + 1) % cameras;
            third = third == first ? (third + 1) % cameras : third;
            const Result<ClipRun> two = tracked_by(setting, clip, recorded, {first, second});
            const Result<ClipRun> three = tracked_by(setting, clip, recorded, {first, second, third});
            if (!two || !three) {
                return two ? three.error() : two.error();
            }
            add_tips(setting.bodies, two.value(), "two", numbers);
            add_tips(setting.bodies, three.value(), "three", numbers);
            if (clip.name == "still") {
                add_jitters(setting.bodies, two.value(), "two", numbers);
            }
        }
    }
    return success();
}

/// "NAME.noise_px": of each sphere in each camera, about its mean, each way; in a clip in which nothing moves.
void add_spot_noise(const std::vector<SightedSphere>& spheres, const std::string& name, Numbers& numbers) {
    constexpr std::size_t least = 8;
    std::map<std::tuple<int, int, int>, std::vector<Vec2>> offs;
    for (const SightedSphere& sphere : spheres) {
        if (sphere.sighted == Sighted::believed) {
            offs[{sphere.camera, sphere.body, sphere.marker}].push_back(sphere.off);
        }
    }
    for (const auto& [which, off] : offs) {
        if (off.size() < least) {
            continue;
        }
        const auto count = static_cast<double>(off.size());
        const Vec2 mean = std::accumulate(off.begin(), off.end(), Vec2(Vec2::Zero())) / count;
        double squares = 0.0;
        for (const Vec2& one : off) {
            squares += (one - mean).squaredNorm();
        }
        numbers[name + ".noise_px"].push_back(std::sqrt(0.5 * squares / (count - 1.0)));
    }
}

void add_spots(const Setting& setting, const synthetic::Clip& clip, const Recorded& recorded, const std::string& name,
               Numbers& numbers) {
    std::vector<double>& missing = numbers[name + ".missing"];
    std::vector<double>& refused = numbers[name + ".refused"];
    const std::vector<SightedSphere> spheres = sighted_spheres(setting.rig, clip, recorded, TrackerSettings{});
    if (clip.name == "still") {
        add_spot_noise(spheres, name, numbers);
    }
    for (const SightedSphere& sphere : spheres) {
        missing.push_back(sphere.sighted == Sighted::missing ? 1.0 : 0.0);
        if (sphere.sighted != Sighted::missing) {
            refused.push_back(sphere.sighted == Sighted::refused ? 1.0 : 0.0);
        }
        if (sphere.sighted == Sighted::believed) {
            numbers[name + ".spot_px"].push_back(sphere.off.norm());
        }
    }
}

/// One clip, from images or not: its spots, and its tips by all cameras.
Result<Recorded> add_level(const Setting& setting, const synthetic::Clip& clip, bool images, const std::string& name,
                           Numbers& numbers) {
    Result<Recorded> recorded = record_spots(setting.rig, clip, setting.clip_plan(images, setting.plan.image_s));
    if (!recorded) {
        return recorded.error();
    }
    const Result<ClipRun> run = tracked_again(setting, clip, recorded.value());
    if (!run) {
        return run.error();
    }
    add_spots(setting, clip, recorded.value(), name, numbers);
    add_tips(setting.bodies, run.value(), name, numbers);
    if (clip.name == "still") {
        add_jitters(setting.bodies, run.value(), name, numbers);
    }
    return recorded;
}

}  // namespace

Result<Numbers> measure_images(const Setting& setting) {
    Numbers numbers;
    for (const std::string_view name : {"still", "tremor"}) {
        const Result<synthetic::Clip> clip = setting.clip(name);
        if (!clip) {
            return clip.error();
        }
        const Result<Recorded> seen = add_level(setting, clip.value(), true, "images", numbers);
        const Result<Recorded> without = add_level(setting, clip.value(), false, "markers", numbers);
        if (!seen || !without) {
            return seen ? without.error() : seen.error();
        }
        if (const Status status = add_fewer_cameras(setting, clip.value(), seen.value(), numbers); !status) {
            return status.error();
        }
    }
    return numbers;
}

/// From six images that are in memory to poses, on this thread.
Result<Numbers> measure_compute(const Setting& setting) {
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
    Tracker tracker(setting.solver(), setting.bodies, 0, TrackerSettings{});
    SpotFinder finder(SpotSettings{});
    Numbers numbers;
    FrameSet set;
    for (;;) {
        const Result<bool> more = source.value()->next(set);
        if (!more) {
            return more.error();
        }
        if (!more.value()) {
            return numbers;
        }
        const double begun_s = thread_cpu_seconds();
        std::vector<CameraSpots> exposures;
        for (const CameraFrame& frame : set.frames) {
            exposures.push_back({frame.camera, frame.time_s, finder.find(frame.view()).spots});
        }
        tracker.step(exposures);
        numbers["compute.s"].push_back(thread_cpu_seconds() - begun_s);
    }
}

}  // namespace rhexis::tracking
