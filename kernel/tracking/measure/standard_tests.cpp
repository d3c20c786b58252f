// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/standard_tests.hpp"

#include <Eigen/Geometry>
#include <array>
#include <numbers>

#include "math/poses.hpp"
#include "tracking/bodies/identity.hpp"

namespace rhexis::tracking {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Two bodies on a bar; the tip of both is its middle, about which it turns.
std::vector<MarkerBody> bar_of(const std::vector<MarkerBody>& bodies) {
    constexpr double apart_mm = 120.0;
    std::vector<MarkerBody> ends{bodies[1], bodies[2]};
    ends[0].tip = {{0.5 * apart_mm, 0.0, 0.0}, Quat::Identity()};
    ends[1].tip = {{-0.5 * apart_mm, 0.0, 0.0}, Quat::Identity()};
    return ends;
}

/// To and fro along `path`, the bar along `axis`, turning a little as what a hand carries does.
Result<synthetic::Clip> carried(const Setting& setting, const Vec3& path, const Vec3& axis) {
    constexpr double reach_mm = 40.0;
    constexpr double fastest_mm_s = 100.0;
    Result<synthetic::Clip> clip =
        synthetic::make_clip("still", setting.seed, bar_of(setting.bodies), setting.rig.nominal);
    if (!clip) {
        return clip;
    }
    clip.value().hands = false;
    const double frequency_hz = fastest_mm_s / (2.0 * std::numbers::pi * reach_mm);
    for (synthetic::Motion& motion : clip.value().motions) {
        motion.tip = {Vec3::Zero(), Quat::FromTwoVectors(Vec3::UnitX(), axis)};
        motion.moves = {{reach_mm * path, frequency_hz, 0.0}};
        motion.turns = {{Vec3(0.1, 0.07, 0.05), 0.7, 0.0}};
    }
    return clip;
}

void add_bar(const ClipRun& run, const std::vector<MarkerBody>& ends, Numbers& numbers) {
    for (std::size_t i = 0; i < run.traces[0].size(); ++i) {
        const TipSample& left = run.traces[0][i];
        const TipSample& right = run.traces[1][i];
        if (!left.seen || !right.seen) {
            continue;
        }
        const auto between = [&ends](const Pose& of_left, const Pose& of_right) {
            return relative(times(of_left, inverse(ends[0].tip)), times(of_right, inverse(ends[1].tip)));
        };
        const Pose is = between(left.is, right.is);
        const Pose told = between(left.told, right.told);
        numbers["artifact.distance_mm"].push_back(told.position.norm() - is.position.norm());
        numbers["artifact.turn_deg"].push_back(told.orientation.angularDistance(is.orientation) / degree);
    }
}

/// Readings of a tip that stands still at one place, relative to the head.
struct Placement {
    Vec3 is = Vec3::Zero();
    std::vector<Vec3> told{};

    [[nodiscard]] Vec3 mean() const {
        Vec3 sum = Vec3::Zero();
        for (const Vec3& one : told) {
            sum += one;
        }
        return sum / static_cast<double>(told.size());
    }
};

/// The instrument's tip at a place of the rig, turned about it by `turn` in its own axes. No readings: it is not seen.
Result<Placement> placed(const Setting& setting, const Vec3& place, const Quat& turn) {
    constexpr double begun_s = 0.005;
    constexpr double until_s = 0.05;
    const std::vector<MarkerBody> bodies{setting.bodies[0], setting.bodies[1]};
    Result<synthetic::Clip> clip = synthetic::make_clip("still", setting.seed, bodies, setting.rig.nominal);
    if (!clip) {
        return clip.error();
    }
    synthetic::Motion& motion = clip.value().motions[1];
    motion.tip = {place, motion.tip.orientation * turn};
    const Result<ClipRun> run =
        track_clip(setting.rig, setting.solver(), clip.value(), setting.clip_plan(true, until_s));
    if (!run) {
        return run.error();
    }
    Placement placement;
    for (const TipSample& sample : run.value().traces[1]) {
        placement.is = sample.is.position;
        if (sample.seen && sample.time_s >= begun_s) {
            placement.told.push_back(sample.told.position);
        }
    }
    return placement;
}

/// 5 x 4 points, 15 mm apart, by turns on two levels.
Result<std::vector<Placement>> phantom_points(const Setting& setting) {
    std::vector<Placement> points;
    for (int i = 0; i < 20; ++i) {
        const Vec3 place(15.0 * (i % 5 - 2), 15.0 * (i / 5 - 1.5), i % 2 == 0 ? 0.0 : -15.0);
        Result<Placement> placement = placed(setting, place, Quat::Identity());
        if (!placement) {
            return placement.error();
        }
        if (!placement.value().told.empty()) {
            points.push_back(std::move(placement).value());
        }
    }
    return points;
}

void add_points(const std::vector<Placement>& points, Numbers& numbers) {
    std::vector<Vec3> are;
    std::vector<Vec3> told;
    for (const Placement& point : points) {
        are.push_back(point.is);
        told.push_back(point.mean());
    }
    const Pose registration = fitted(are, told);
    for (std::size_t i = 0; i < are.size(); ++i) {
        for (const Vec3& one : points[i].told) {
            numbers["phantom.point"].push_back((one - registration.to_world(are[i])).norm());
        }
        for (std::size_t j = 0; j < i; ++j) {
            numbers["phantom.distance"].push_back((told[i] - told[j]).norm() - (are[i] - are[j]).norm());
        }
    }
}

/// The middle point, straight and turned.
Status add_turned(const Setting& setting, Numbers& numbers) {
    struct Turn {
        const char* row;
        Vec3 axis;
        std::array<double, 4> degrees;
    };
    const std::array<Turn, 3> turns{{{"phantom.pitch", Vec3::UnitX(), {-20.0, -10.0, 10.0, 20.0}},
                                     {"phantom.yaw", Vec3::UnitY(), {-20.0, -10.0, 10.0, 20.0}},
                                     {"phantom.roll", Vec3::UnitZ(), {-60.0, -30.0, 30.0, 60.0}}}};
    const Result<Placement> straight = placed(setting, Vec3::Zero(), Quat::Identity());
    if (!straight) {
        return straight.error();
    }
    if (straight.value().told.empty()) {
        return success();
    }
    const Vec3 mean = straight.value().mean();
    numbers["phantom.bias"].push_back((mean - straight.value().is).norm());
    for (const Vec3& one : straight.value().told) {
        numbers["phantom.spread"].push_back((one - mean).norm());
    }
    for (const Turn& turn : turns) {
        for (const double degrees : turn.degrees) {
            const Result<Placement> turned =
                placed(setting, Vec3::Zero(), Quat(Eigen::AngleAxisd(degrees * degree, turn.axis)));
            if (!turned) {
                return turned.error();
            }
            if (!turned.value().told.empty()) {
                numbers[turn.row].push_back((turned.value().mean() - mean).norm());
            }
        }
    }
    return success();
}

}  // namespace

Result<Numbers> measure_artifact(const Setting& setting) {
    Numbers numbers;
    for (const Vec3& path : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
        for (int axis = 0; axis < 3; ++axis) {
            const Result<synthetic::Clip> clip = carried(setting, path, Vec3(Vec3::Unit(axis)));
            if (!clip) {
                return clip.error();
            }
            const Result<ClipRun> run =
                track_clip(setting.rig, setting.solver(), clip.value(), setting.clip_plan(true, setting.plan.image_s));
            if (!run) {
                return run.error();
            }
            add_bar(run.value(), clip.value().bodies, numbers);
        }
    }
    return numbers;
}

Result<Numbers> measure_phantom(const Setting& setting) {
    Numbers numbers;
    const Result<std::vector<Placement>> points = phantom_points(setting);
    if (!points) {
        return points.error();
    }
    add_points(points.value(), numbers);
    if (const Status status = add_turned(setting, numbers); !status) {
        return status.error();
    }
    return numbers;
}

}  // namespace rhexis::tracking
