// SPDX-License-Identifier: GPL-3.0-or-later
// Scripted clips: where bodies, hands and cameras are at any time. The same for the same name, seed, bodies and rig.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "tracking/marker_body.hpp"
#include "tracking/synthetic/delivery.hpp"
#include "tracking/synthetic/scene.hpp"

namespace rhexis::tracking::synthetic {

/// amplitude * sin(2 pi frequency t + phase)
struct Wave {
    Vec3 amplitude = Vec3::Zero();
    double frequency_hz = 0.0;
    double phase = 0.0;  ///< [rad]
};

/// To another place, there for a while, and back; `ramp_s` each way, within the time from begin to end.
struct Trip {
    Vec3 to = Vec3::Zero();  ///< from where it was [mm]
    double begin_s = 0.0;
    double end_s = 0.0;
    double ramp_s = 0.5;
};

/// Of a body's tip; it turns about it.
struct Motion {
    Pose tip{};                 ///< at rest, in the rig
    std::vector<Wave> moves{};  ///< [mm]
    std::vector<Wave> turns{};  ///< rotation vectors [rad], small
    std::vector<Trip> trips{};
};

/// A disc before one camera that slides in from the side, or a ball about one marker, for a while.
struct Cover {
    int camera = -1;  ///< one of camera and body is -1
    int body = -1;
    int marker = -1;
    double begin_s = 0.0;
    double end_s = 0.0;
    double slide_s = 0.03;  ///< of a disc, each way, within the time from begin to end
};

/// One camera is turned about its own axes from a time on.
struct Bump {
    int camera = -1;  ///< -1: none is
    double time_s = 0.0;
    Vec3 turn = Vec3::Zero();  ///< [rad]
};

/// Worn or dirty part of a marker.
struct Worn {
    Vec3 towards = Vec3::UnitZ();  ///< in the body's frame
    double cosine = 2.0;           ///< above 1: none
    double left = 1.0;
};

struct Clip {
    std::string name{};
    std::uint64_t seed = 0;
    double duration_s = 10.0;
    std::vector<MarkerBody> bodies{};
    std::vector<Motion> motions{};          ///< one for each body
    std::vector<std::vector<Worn>> worn{};  ///< one for each body's marker
    std::vector<Cover> covers{};
    std::vector<Vec3> eyes{};  ///< where covers take the cameras to be: the nominal rig
    Bump bump{};
    double marker_light = 130.0;  ///< as Sphere::light
    double ambient = 3.0;
    double specks = 0.1;
    bool hands = true;   ///< fingers, handles, the microscope's column
    bool glints = true;  ///< two on the drape, one on each instrument's handle
};

/// still        nothing moves; 10 s
/// circle       tips go round in circles of 1 mm, once a second; 10 s
/// tremor       2 Hz of 0.3 mm, and 50 um of six waves between 6 and 14 Hz; 20 s
/// insertions   along the axis, to and fro, at up to 0.5 m/s; 10 s
/// occlusion    four of six cameras blocked in turn, all 15 choices; then each marker in turn; tremor
/// crossing     the first two instruments cross before the first camera; all leave the volume and return; 12 s
/// bump         one camera is turned by 0.1 degrees in the middle; circles; 10 s
/// breathing    the head drifts to and fro by 0.5 mm in 20 s, and by 0.2 mm every 4 s, as with breath; tremor; 20 s
/// knocks       likewise, and every two seconds hands push the head by 1 mm within 0.1 s, and it comes back
/// pivot        tips rest in hollows while instruments swing through cones of 40 degrees; 10 s
inline constexpr std::array<std::string_view, 10> clip_names{
    "still", "circle", "tremor", "insertions", "occlusion", "crossing", "bump", "breathing", "knocks", "pivot"};

inline constexpr int most_instruments = 6;  ///< that there is room for in a clip

/// Bodies named "head" are on the head, which rests unless told above; others are instruments, up to six of them, with
/// their tips at the eye, held along the z axes of their bodies. The error tells the names there are.
Result<Clip> make_clip(std::string_view name, std::uint64_t seed, std::span<const MarkerBody> bodies, const Rig& rig);

/// A body's frame in the rig [mm], at any time; also before 0 and after the end.
Pose pose_at(const Clip& clip, int body, double time_s);

/// Its tip in the rig.
Pose tip_at(const Clip& clip, int body, double time_s);

/// All of it; spheres body by body, in the order of their markers. What `scene` held is gone, its memory is used.
void scene_at(const Clip& clip, double time_s, Scene& scene);

/// A camera as it stands at a time.
TrueCamera camera_at(const Clip& clip, const SyntheticRig& rig, int camera, double time_s);

/// The scenes that a shot sees: `count` (at least 1) at even distances within its exposure.
void instants_of(const Clip& clip, const Shot& shot, double exposure_s, int count, std::vector<Scene>& instants);

}  // namespace rhexis::tracking::synthetic
