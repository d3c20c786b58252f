// SPDX-License-Identifier: GPL-3.0-or-later
// The clips' scripts, by name.
#include <cmath>
#include <numbers>

#include "base/rng.hpp"
#include "math/rotation.hpp"
#include "tracking/synthetic/clips.hpp"

namespace rhexis::tracking::synthetic {
namespace {

/// Of an instrument at rest: its tip within a millimetre or two of the eye, its handle up and to its own side.
Pose resting_tip(int instrument, int instruments, Rng& rng) {
    const double around =
        2.0 * std::numbers::pi * (instrument + 0.15 * (rng.uniform() - 0.5)) / std::max(instruments, 3) + 0.4;
    const double up = (38.0 + 6.0 * (rng.uniform() - 0.5)) * std::numbers::pi / 180.0;
    const Vec3 out{std::cos(around), std::sin(around), 0.0};
    const Vec3 axis = std::cos(up) * out + std::sin(up) * Vec3::UnitZ();
    // one side of the hand is level, the other away from the work
    Mat3 axes;
    axes.col(2) = axis;
    axes.col(0) = Vec3::UnitZ().cross(axis).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return {4.0 * out, Quat(axes)};
}

Vec3 random_direction(Rng& rng) {
    Vec3 direction;
    for (int i = 0; i < 3; ++i) {
        direction[i] = rng.normal();
    }
    return direction.normalized();
}

std::vector<Worn> draw_worn(std::size_t markers, Rng& rng) {
    constexpr double share_worn = 0.25;
    std::vector<Worn> worn(markers);
    for (Worn& one : worn) {
        one.towards = random_direction(rng);
        const double left = 0.3 + 0.5 * rng.uniform();
        const double half_angle = 0.4 + 0.4 * rng.uniform();
        if (rng.uniform() < share_worn) {
            one.cosine = std::cos(half_angle);
            one.left = left;
        }
    }
    return worn;
}

bool is_head(const MarkerBody& body) { return body.name == "head"; }

/// From the tip to the hand.
Vec3 handle_axis(const MarkerBody& body, const Motion& motion) {
    return motion.tip.orientation * (body.tip.orientation.conjugate() * Vec3::UnitZ());
}

void add_circles(Clip& clip) {
    constexpr double radius = 1.0;
    for (std::size_t i = 0; i < clip.bodies.size(); ++i) {
        if (!is_head(clip.bodies[i])) {
            clip.motions[i].moves.push_back({radius * Vec3::UnitX(), 1.0, 0.5 * std::numbers::pi});
            clip.motions[i].moves.push_back({radius * Vec3::UnitY(), 1.0, 0.0});
        }
    }
}

void add_tremor(Clip& clip, Rng& rng) {
    constexpr double slow_mm = 0.3;
    constexpr double tremor_mm = 0.05;
    constexpr int waves = 6;
    for (std::size_t i = 0; i < clip.bodies.size(); ++i) {
        if (is_head(clip.bodies[i])) {
            continue;
        }
        std::vector<Wave>& moves = clip.motions[i].moves;
        moves.push_back({slow_mm * random_direction(rng), 2.0, 2.0 * std::numbers::pi * rng.uniform()});
        for (int j = 0; j < waves; ++j) {
            const double frequency = 6.0 + 8.0 * (j + rng.uniform()) / waves;
            // amplitudes whose squares sum to that of one wave of 50 um
            const Vec3 amplitude = tremor_mm / std::sqrt(waves) * random_direction(rng);
            moves.push_back({amplitude, frequency, 2.0 * std::numbers::pi * rng.uniform()});
        }
        clip.motions[i].turns.push_back({0.01 * random_direction(rng), 0.7, 2.0 * std::numbers::pi * rng.uniform()});
    }
}

void add_insertions(Clip& clip) {
    constexpr double frequency = 4.0;
    constexpr double speed_mm_s = 500.0;
    for (std::size_t i = 0; i < clip.bodies.size(); ++i) {
        if (!is_head(clip.bodies[i])) {
            Motion& motion = clip.motions[i];
            const Vec3 axis = handle_axis(clip.bodies[i], motion);
            const double amplitude = speed_mm_s / (2.0 * std::numbers::pi * frequency);
            motion.tip.position += amplitude * axis;
            motion.moves.push_back({amplitude * axis, frequency, static_cast<double>(i)});
        }
    }
}

/// All choices of two cameras that are left, one after another; then each marker.
void add_occlusion(Clip& clip) {
    constexpr double each_s = 0.25;
    constexpr double pause_s = 0.1;
    const int cameras = static_cast<int>(clip.eyes.size());
    double time_s = 0.5;
    for (int first = 0; first < cameras; ++first) {
        for (int second = first + 1; second < cameras; ++second) {
            for (int camera = 0; camera < cameras; ++camera) {
                if (camera != first && camera != second) {
                    clip.covers.push_back({camera, -1, -1, time_s, time_s + each_s});
                }
            }
            time_s += each_s + pause_s;
        }
    }
    for (std::size_t body = 0; body < clip.bodies.size(); ++body) {
        for (std::size_t marker = 0; marker < clip.bodies[body].markers.size(); ++marker) {
            clip.covers.push_back({-1, static_cast<int>(body), static_cast<int>(marker), time_s, time_s + each_s});
            time_s += each_s + pause_s;
        }
    }
    clip.duration_s = time_s;
}

/// Moves the rest of two instruments so that their markers' centres are on one line of sight from an eye.
void lay_on_one_sight(const Vec3& eye, const MarkerBody& body, const MarkerBody& other, Motion& motion,
                      Motion& others) {
    const auto markers = [](const MarkerBody& it, const Motion& its) {
        return Vec3(its.tip.position + its.tip.orientation * (it.tip.orientation.conjugate() * -it.tip.position));
    };
    const Vec3 here = markers(body, motion);
    const Vec3 there = markers(other, others);
    const Vec3 sight = (0.5 * (here + there) - eye).normalized();
    const Vec3 apart = there - here;
    const Vec3 aside = apart - apart.dot(sight) * sight;
    motion.tip.position += 0.5 * aside;
    others.tip.position -= 0.5 * aside;
}

/// The first two instruments cross before the first camera, twice in two seconds; then all leave.
void add_crossing(Clip& clip) {
    constexpr double swing_mm = 40.0;
    constexpr double away_mm = 420.0;
    std::vector<std::size_t> instruments;
    for (std::size_t i = 0; i < clip.bodies.size(); ++i) {
        if (!is_head(clip.bodies[i])) {
            instruments.push_back(i);
            const Vec3 axis = handle_axis(clip.bodies[i], clip.motions[i]);
            clip.motions[i].trips.push_back({away_mm * axis, 7.0, 10.0, 0.8});
        }
    }
    clip.duration_s = 12.0;
    if (instruments.size() < 2 || clip.eyes.empty()) {
        return;
    }
    const std::size_t first = instruments[0];
    const std::size_t second = instruments[1];
    const Vec3& eye = clip.eyes[0];
    lay_on_one_sight(eye, clip.bodies[first], clip.bodies[second], clip.motions[first], clip.motions[second]);
    const Vec3 across = eye.normalized().unitOrthogonal();
    clip.motions[first].moves.push_back({swing_mm * across, 0.5, 0.7});
    clip.motions[second].moves.push_back({-swing_mm * across, 0.5, 0.7});
}

void add_bump(Clip& clip, Rng& rng) {
    constexpr double turn = 0.1 * std::numbers::pi / 180.0;
    const double angle = 2.0 * std::numbers::pi * rng.uniform();
    clip.bump.camera = static_cast<int>(rng.integer(0, static_cast<int>(clip.eyes.size()) - 1));
    clip.bump.time_s = 0.5 * clip.duration_s;
    // about an axis across the view: as a knock does, and as an image shows
    clip.bump.turn = turn * Vec3(std::cos(angle), std::sin(angle), 0.0);
}

/// Of a head that is draped and lies loosely: its eye, and about it.
void add_breathing(Clip& clip, Rng& rng) {
    constexpr double drift_mm = 0.5;
    constexpr double breath_mm = 0.2;
    constexpr double turn_per_mm = 0.01;  // as of a head that rocks on a point 100 mm away
    for (std::size_t i = 0; i < clip.bodies.size(); ++i) {
        if (!is_head(clip.bodies[i])) {
            continue;
        }
        Motion& motion = clip.motions[i];
        for (const auto& [most_mm, frequency_hz] : {std::pair(drift_mm, 0.05), std::pair(breath_mm, 0.25)}) {
            const double phase = 2.0 * std::numbers::pi * rng.uniform();
            motion.moves.push_back({most_mm * random_direction(rng), frequency_hz, phase});
            motion.turns.push_back({turn_per_mm * most_mm * random_direction(rng), frequency_hz, phase});
        }
    }
}

/// Hands that lean on the head and let it go.
void add_knocks(Clip& clip, Rng& rng) {
    constexpr double push_mm = 1.0;
    constexpr double every_s = 2.0;
    constexpr double leant_s = 1.0;
    constexpr double ramp_s = 0.1;
    for (std::size_t i = 0; i < clip.bodies.size(); ++i) {
        for (double begin_s = 0.15; is_head(clip.bodies[i]) && begin_s < clip.duration_s; begin_s += every_s) {
            clip.motions[i].trips.push_back({push_mm * random_direction(rng), begin_s, begin_s + leant_s, ramp_s});
        }
    }
}

/// About their tips, as they are turned to be found.
void add_pivots(Clip& clip) {
    constexpr double half_cone = 0.35;  // [rad]
    constexpr double frequency = 0.4;
    for (std::size_t i = 0; i < clip.bodies.size(); ++i) {
        if (!is_head(clip.bodies[i])) {
            Motion& motion = clip.motions[i];
            const Mat3 axes = motion.tip.orientation.toRotationMatrix();
            motion.turns.push_back({half_cone * axes.col(0), frequency, 0.0});
            motion.turns.push_back({half_cone * axes.col(1), frequency, 0.5 * std::numbers::pi});
        }
    }
}

void add_script(std::string_view name, Clip& clip, Rng& rng) {
    if (name == "circle") {
        add_circles(clip);
    } else if (name == "tremor") {
        clip.duration_s = 20.0;
        add_tremor(clip, rng);
    } else if (name == "insertions") {
        add_insertions(clip);
    } else if (name == "occlusion") {
        add_tremor(clip, rng);
        add_occlusion(clip);
    } else if (name == "crossing") {
        add_crossing(clip);
    } else if (name == "bump") {
        add_circles(clip);
        add_bump(clip, rng);
    } else if (name == "breathing" || name == "knocks") {
        clip.duration_s = 20.0;
        add_tremor(clip, rng);
        add_breathing(clip, rng);
        if (name == "knocks") {
            add_knocks(clip, rng);
        }
    } else if (name == "pivot") {
        add_pivots(clip);
    }
}

std::string all_names() {
    std::string all;
    for (const std::string_view name : clip_names) {
        all += all.empty() ? "" : ", ";
        all += name;
    }
    return all;
}

}  // namespace

Result<Clip> make_clip(std::string_view name, std::uint64_t seed, std::span<const MarkerBody> bodies, const Rig& rig) {
    if (std::find(clip_names.begin(), clip_names.end(), name) == clip_names.end()) {
        return Error{"there is no clip \"" + std::string(name) + "\"", "clips", all_names()};
    }
    const auto heads = static_cast<int>(std::count_if(bodies.begin(), bodies.end(), is_head));
    const int instruments = static_cast<int>(bodies.size()) - heads;
    if (instruments > most_instruments) {
        return Error{std::to_string(instruments) + " instruments", "clips",
                     "at most " + std::to_string(most_instruments)};
    }
    Clip clip;
    clip.name = name;
    clip.seed = seed;
    clip.bodies.assign(bodies.begin(), bodies.end());
    for (const Camera& camera : rig.cameras) {
        clip.eyes.push_back(camera.pose.position);
    }
    Rng rng(seed, "clip " + clip.name);
    int instrument = 0;
    for (const MarkerBody& body : bodies) {
        Motion motion;
        if (!is_head(body)) {
            motion.tip = resting_tip(instrument++, instruments, rng);
            // it is held by its handle, which is the body's z axis
            motion.tip.orientation = motion.tip.orientation * body.tip.orientation;
        }
        clip.motions.push_back(motion);
        clip.worn.push_back(draw_worn(body.markers.size(), rng));
    }
    add_script(name, clip, rng);
    return clip;
}

}  // namespace rhexis::tracking::synthetic
