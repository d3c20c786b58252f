// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/detector_chart.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "base/clock.hpp"
#include "tracking/measure/other_detectors.hpp"
#include "tracking/sources/synthetic_source.hpp"

namespace rhexis::tracking {
namespace {

struct Detector {
    std::string name{};
    std::function<std::vector<Spot>(const GreyImage&)> find{};
    TrackerSettings tracker{};
};

/// Of detectors whose spots are less sure than outlines, and as wide as the threshold makes them.
TrackerSettings lenient() {
    TrackerSettings settings;
    settings.blur_px = 0.0;
    settings.least_area = 0.85;
    settings.most_area = 1.15;
    settings.least_roundness = 0.93;
    settings.fit.floor_px = 0.1;
    return settings;
}

Detector ours(const char* name, bool outlines, double low, double high) {
    SpotSettings settings;
    settings.outlines = outlines;
    settings.low = low;
    settings.high = high;
    auto finder = std::make_shared<SpotFinder>(settings);
    TrackerSettings tracker = outlines ? TrackerSettings{} : lenient();
    if (low <= 0.0) {
        tracker.least_area = 0.4;  // the limb is darker than the middle, and weighs less
    }
    return {name, [finder](const GreyImage& image) { return finder->find(image).spots; }, tracker};
}

std::vector<Detector> all_detectors() {
    const int threshold = SpotSettings{}.threshold;
    return {ours("fitted outlines", true, 0.15, 0.4),
            ours("moments of the outline", false, 0.15, 0.4),
            ours("moments of light", false, 0.0, 1.0),
            {"OpenCV contours, binary moments",
             [threshold](const GreyImage& image) { return contour_spots(image, threshold); }, lenient()},
            {"OpenCV connected components",
             [threshold](const GreyImage& image) { return component_spots(image, threshold); }, lenient()}};
}

Result<std::vector<FrameSet>> frames_of(const synthetic::SyntheticRig& rig, const synthetic::Clip& clip,
                                        std::uint64_t seed, int exposures) {
    synthetic::Stage stage;
    stage.scene = [&clip](double time_s, synthetic::Scene& scene) { scene_at(clip, time_s, scene); };
    synthetic::Film film;
    film.seed = seed;
    film.frames = exposures;
    const Result<std::unique_ptr<FrameSource>> source = film_images(rig, stage, film);
    if (!source) {
        return source.error();
    }
    std::vector<FrameSet> frames;
    FrameSet set;
    for (;;) {
        const Result<bool> more = source.value()->next(set);
        if (!more) {
            return more.error();
        }
        if (!more.value()) {
            return frames;
        }
        frames.push_back(set);
    }
}

/// Spots of all images; seconds for one image of each camera.
std::vector<std::vector<CameraSpots>> detect(const std::vector<FrameSet>& frames, const Detector& detector,
                                             std::vector<double>& seconds) {
    std::vector<std::vector<CameraSpots>> recorded;
    seconds.clear();
    for (const FrameSet& set : frames) {
        std::vector<CameraSpots> exposures;
        const double begun_s = thread_cpu_seconds();
        for (const CameraFrame& frame : set.frames) {
            exposures.push_back({frame.camera, frame.time_s, detector.find(frame.view())});
        }
        seconds.push_back((thread_cpu_seconds() - begun_s) /
                          static_cast<double>(std::max<std::size_t>(set.frames.size(), 1)));
        recorded.push_back(std::move(exposures));
    }
    return recorded;
}

/// Every instrument with its first markers only; the others still stand before the cameras.
synthetic::Clip with_markers(synthetic::Clip clip, std::size_t markers) {
    for (MarkerBody& body : clip.bodies) {
        if (body.name != "head") {
            body.markers.resize(std::min(body.markers.size(), markers));
        }
    }
    return clip;
}

std::string name_of(const Detector& detector, std::size_t cameras, std::size_t markers) {
    return "detector." + detector.name + "." + std::to_string(cameras) + "." + std::to_string(markers);
}

/// Two that face each other would see the same side; these are a third of the ring apart.
const std::vector<std::vector<int>>& chart_cameras() {
    static const std::vector<std::vector<int>> all{
        {0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 4}, {0, 1, 3, 4}, {0, 2, 4}, {0, 2}};
    return all;
}
constexpr std::array<std::size_t, 2> chart_markers{4, 3};

}  // namespace

Result<Numbers> measure_detectors(const Setting& setting) {
    constexpr double found_s = 0.1;  // by all cameras, for all rows alike; errors are told from then on
    constexpr int exposures = 24;
    const Result<synthetic::Clip> clip = setting.clip("still");
    if (!clip) {
        return clip.error();
    }
    const Result<std::vector<FrameSet>> frames = frames_of(setting.rig, clip.value(), setting.seed, exposures);
    if (!frames) {
        return frames.error();
    }
    Numbers numbers;
    for (const Detector& detector : all_detectors()) {
        std::vector<double> seconds;
        const std::vector<std::vector<CameraSpots>> recorded = detect(frames.value(), detector, seconds);
        for (const std::vector<int>& used : chart_cameras()) {
            for (const std::size_t markers : chart_markers) {
                const synthetic::Clip seen = with_markers(clip.value(), markers);
                ClipPlan plan = setting.clip_plan(false, 1e9);
                plan.tracker = detector.tracker;
                const std::vector<std::vector<CameraSpots>> fewer = only_cameras(recorded, used, found_s);
                RecordedSpots source(fewer, plan.delivery.rate_hz);
                const Result<ClipRun> run = track_spots(source, setting.solver(), seen, plan);
                if (!run) {
                    return run.error();
                }
                const std::string name = name_of(detector, used.size(), markers);
                add_tips(setting.bodies, run.value(), name, numbers);
                append({{name + ".detect_s", seconds}, {name + ".track_s", run.value().seconds}}, numbers);
            }
        }
    }
    return numbers;
}

std::vector<ChartRow> chart_rows(const Numbers& numbers) {
    std::vector<ChartRow> rows;
    for (const Detector& detector : all_detectors()) {
        for (const std::vector<int>& used : chart_cameras()) {
            for (const std::size_t markers : chart_markers) {
                const std::string name = name_of(detector, used.size(), markers);
                const std::vector<double>& seen = row_of(numbers, name + ".seen");
                if (!seen.empty()) {
                    rows.push_back(
                        {detector.name, static_cast<int>(used.size()), static_cast<int>(markers),
                         figures_of(row_of(numbers, name + ".tip_mm"), std::ssize(seen)),
                         static_cast<double>(used.size()) * share_of(row_of(numbers, name + ".detect_s"), 0.5),
                         share_of(row_of(numbers, name + ".track_s"), 0.5)});
                }
            }
        }
    }
    return rows;
}

}  // namespace rhexis::tracking
