// SPDX-License-Identifier: GPL-3.0-or-later
// A hand that tears the anterior capsule round with forceps: it takes the flap behind the end of the tear and pulls in
// a direction given against the circle at that end.
#pragma once

#include "scenes/capsule_scene.hpp"

namespace rhexis::scenes {

constexpr double planned_radius = 2.6;  ///< of the opening, from the axis, in the capsule at rest [mm]

/// A pull begins where the flap is taken and ends when one of these is reached.
struct FlapPull {
    double inwards = 0.0;           ///< from the tangent of the circle about the axis towards the axis [degrees]
    double steering = 0.0;          ///< more of it per mm that the end of the tear is too far out [degrees/mm]
    double held_behind = 0.8;       ///< the end of the tear, where the flap is taken [mm]
    double height = 0.2;            ///< over the lens, at which it is led [mm]
    bool unfold = false;            ///< leads it back first to where it lay before it was torn
    double length = 1.5;            ///< that the end of the tear goes, at rest [mm]
    double farthest_radius = 10.0;  ///< of that end, at rest [mm]
    double farthest_round = 360.0;  ///< the axis that it has gone since the hand first led it [degrees]
};

enum class PullEnd { torn, gone_round, too_far_out, slipped, out_of_reach, end_lost, nothing_held, time_up };

struct PullResult {
    PullEnd end = PullEnd::time_up;
    double torn = 0.0;        ///< straight from where the tear ended to where it ends, at rest [mm]
    double peak_force = 0.0;  ///< [uN]
};

/// Of the flap's edge: about so far behind the end of the tear, and farthest from its place; -1: there is none.
/// end: of the tear, in the sheet at rest [mm].
int node_to_hold(const MembraneState& sheet, const Vec3& end, double behind);

class FlapHand {
public:
    /// The scene's first instrument are forceps. end: of the tear that is led, about, in the sheet at rest.
    FlapHand(CapsuleScene& scene, const Vec3& end);

    /// Takes the flap, pulls, lets it go and withdraws.
    PullResult pull(const FlapPull& how);

    /// Of the tear that is led, in the sheet at rest [mm]; where it was last seen once it is lost.
    [[nodiscard]] const Vec3& end() const { return end_; }
    [[nodiscard]] double radius() const { return end_.head<2>().norm(); }
    /// The axis that it has gone since this hand leads it [degrees].
    [[nodiscard]] double round() const { return round_; }

private:
    bool follow();
    bool take_flap(const FlapPull& how);
    void unfold(const FlapPull& how);
    void let_go();
    [[nodiscard]] Vec3 aim(const FlapPull& how) const;
    [[nodiscard]] double reach() const;
    PullEnd pull_until_done(const FlapPull& how, PullResult& result);

    CapsuleScene* scene_;
    Vec3 end_;
    int node_ = -1;              ///< at the end
    Vec3 taken_ = Vec3::Zero();  ///< place of the flap that is held, in the sheet at rest
    double round_ = 0.0;
};

}  // namespace rhexis::scenes
