// SPDX-License-Identifier: GPL-3.0-or-later
// Spots of all cameras to poses of all bodies. Bodies that were seen are looked for where they should be; the others
// among the points that no body accounts for.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tracking/bodies/rigid_fit.hpp"
#include "tracking/motion_filter.hpp"
#include "tracking/points/matching.hpp"
#include "tracking/resting_pose.hpp"
#include "tracking/rig.hpp"
#include "tracking/tracked.hpp"

namespace rhexis::tracking {

struct TrackerSettings {
    double gate_px = 12.0;          ///< from where a marker should be to the spot that is taken for it
    double spot_sigma_px = 0.02;    ///< of a spot's centre, with what its own says in squares
    double area_px = 6.0;           ///< and this times the share by which its area is off: what hides or wears a part
                                    ///< of a sphere makes it smaller, and moves it
    double blur_px = -0.19;         ///< by which a spot is wider each way than the sphere's image
    double least_area = 0.96;       ///< of what the sphere's image should have: less is half hidden
    double most_area = 1.06;        ///< more is two in one
    double least_roundness = 0.95;  ///< of a body that stands still
    double most_residual_px = 0.6;  ///< of a pose that is believed
    double most_new_px = 0.15;      ///< root mean square of all sightings of a body that comes anew by three markers
    double most_leap_mm = 2.0;   ///< of a tip from where it should be, by three markers: one of them may be another's
                                 ///< point, on the circle about the other two
    double hold_s = 0.1;         ///< that a body is held where it was going when it is not seen
    double distance_mm = 0.5;    ///< that distances between points may be off those of a signature
    double exposure_s = 0.0005;  ///< in which a moving spot smears
    FilterSettings filter{};
    RestingSettings head{};  ///< what others are told relative to; its own pose is told as it was seen
    FitSettings fit{};
    MatchingSettings matching{};
};

/// From where a sighting was, with the robust pose: what a bumped camera shows.
struct CameraOffset {
    int camera = 0;
    Vec2 off = Vec2::Zero();  ///< [pixels]
};

/// Standard deviation of a spot's centre each way, taken for a sphere whose image should have this area [pixels] and
/// moves this far within the exposure; 0: it is hidden, two in one, or at the image's rim, and not believed.
double believed_sigma(const Spot& spot, double area, double smear_px, const TrackerSettings& settings);

class Tracker {
public:
    /// head: index of the body whose tip is the eye, which all others are told relative to; none: all are told in the
    /// rig.
    Tracker(Rig rig, std::vector<MarkerBody> bodies, std::optional<int> head, const TrackerSettings& settings);

    /// One exposure of each camera that has come, at most one of each, of about the same time. Times go forward; an
    /// exposure before the last step's is left out.
    const TrackedBodies& step(std::span<const CameraSpots> exposures);

    /// Where a body is in the rig, though all are told relative to the head; none: it is lost.
    [[nodiscard]] std::optional<Pose> in_rig(int body) const;
    /// All sightings of the last step.
    [[nodiscard]] const std::vector<CameraOffset>& offsets() const { return offsets_; }
    [[nodiscard]] const std::vector<MarkerBody>& bodies() const { return bodies_; }
    [[nodiscard]] const Rig& rig() const { return rig_; }

private:
    struct Track {
        Seen seen = Seen::lost;
        MotionFilter filter;
        double seen_s = 0.0;  ///< when it was seen last
        Pose shown{};         ///< in the rig
        Fit fit{};            ///< of the last pose
    };
    /// A marker and the spot that is near where it should be.
    struct Candidate {
        int body = 0;
        int exposure = 0;
        int marker = 0;
        int spot = 0;
        double apart_px = 0.0;
        double sigma_px = 0.0;
    };

    void prepare(std::span<const CameraSpots> exposures);
    void follow();
    void acquire();
    void acquire_with(int least_views);
    bool acquire_at(int body, const Pose& pose);
    [[nodiscard]] bool near_where_it_was(int body, const Fit& fit) const;
    bool accept(int body, const std::vector<Sighting>& sightings, const Pose& begun, bool fresh);
    void add_candidates(int body, const Pose& at_time, const Motion& motion, double gate_px);
    void assign();
    [[nodiscard]] std::vector<Sighting> sightings_of(int body) const;
    [[nodiscard]] Pose head_frame();
    void tell();

    Rig rig_;
    std::vector<MarkerBody> bodies_;
    std::optional<int> head_;
    TrackerSettings settings_;

    std::vector<Track> tracks_;
    RestingPose resting_head_;
    std::optional<double> last_s_;

    // Of one step.
    std::vector<CameraSpots> exposures_{};
    std::vector<std::vector<bool>> taken_{};  ///< by exposure and spot
    std::vector<Candidate> candidates_{};
    double time_s_ = 0.0;
    std::vector<CameraOffset> offsets_{};
    TrackedBodies told_{};
};

}  // namespace rhexis::tracking
