// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/knocks.hpp"

#include "tracking/measure/tip_errors.hpp"

namespace rhexis::tracking {
namespace {

constexpr double knocked_at_s = 1.0;
constexpr double until_s = 2.5;

struct NamedCamera {
    double at_s = 0.0;
    int camera = -1;
};

/// The first camera that is named; none: none is.
Result<std::optional<NamedCamera>> first_named(const synthetic::SyntheticRig& rig, const Rig& solver,
                                               const synthetic::Clip& clip, std::uint64_t seed) {
    ClipPlan plan;
    plan.seed = seed;
    plan.images = false;
    plan.longest_s = until_s;
    const Result<std::vector<std::vector<CameraSpots>>> recorded = record_spots(rig, clip, plan);
    if (!recorded) {
        return recorded.error();
    }
    Tracker tracker(solver, clip.bodies, 0, TrackerSettings{});
    CameraHealth health(static_cast<int>(solver.cameras.size()));
    for (const std::vector<CameraSpots>& exposures : recorded.value()) {
        const double time_s = tracker.step(exposures).time_s;
        health.add(time_s, tracker.offsets());
        if (const std::optional<Drift> drift = health.drift()) {
            return std::optional(NamedCamera{time_s, drift->camera});
        }
    }
    return std::optional<NamedCamera>{};
}

}  // namespace

Result<KnockErrors> measure_knock(const synthetic::SyntheticRig& rig, const Rig& solver,
                                  const std::vector<MarkerBody>& bodies, std::uint64_t seed) {
    Result<synthetic::Clip> clip = synthetic::make_clip("bump", seed, bodies, rig.nominal);
    if (!clip) {
        return clip.error();
    }
    clip.value().bump.time_s = knocked_at_s;
    const Result<std::optional<NamedCamera>> knocked = first_named(rig, solver, clip.value(), seed);
    const int camera = clip.value().bump.camera;
    clip.value().bump.camera = -1;
    const Result<std::optional<NamedCamera>> still = first_named(rig, solver, clip.value(), seed);
    if (!knocked || !still) {
        return knocked ? still.error() : knocked.error();
    }
    KnockErrors errors{until_s - knocked_at_s, still.value() ? 1 : 0};
    if (const std::optional<NamedCamera>& named = knocked.value()) {
        const bool right = named->at_s >= knocked_at_s && named->camera == camera;
        errors.named_after_s = right ? named->at_s - knocked_at_s : errors.named_after_s;
        errors.false_alarms += right ? 0 : 1;
    }
    return errors;
}

}  // namespace rhexis::tracking
