// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a capsulorhexis runs out under a hand that does not correct it: the same tear, from the same state, in
// chambers that are more or less full.
#pragma once

#include <array>
#include <cstdint>

#include "scenes/flap_hand.hpp"

namespace rhexis::scenes {

/// Constant while the hand pulls.
struct Chamber {
    double fill = 1.0;           ///< with viscoelastic, share of the chamber, 0 to 1
    double vitreous_mmhg = 0.0;  ///< behind the lens, above the air's [mmHg]
};

/// With which the vitreous pushes the lens forward in such a chamber [uN].
double push_of_vitreous(const Chamber& chamber);

/// Direction of each of its pulls, inwards from the tangent [degrees].
constexpr int most_pulls = 6;
using Pulls = std::array<double, most_pulls>;
Pulls steady_pulls(double inwards);

/// A beginner, who pulls about along the circle and a little inwards, each pull somewhat off his habit, and does not
/// see what comes of it. Habit: mean 10, standard deviation 12 degrees, for one has to pull somewhat inwards to stay on
/// a circle; each pull: standard deviation 8 degrees about that. Proposals, made before anything was measured.
Pulls pulls_of_beginner(std::uint64_t seed);

enum class Fate { kept, ran_out, got_stuck };

struct RunOutResult {
    Fate fate = Fate::got_stuck;
    double radius = 0.0;      ///< at which the tear ends [mm]
    double round = 0.0;       ///< the axis that it went on [degrees]
    int pulls = 0;            ///< that it took
    bool end_lost = false;    ///< it met the sheet's edge or another tear
    double peak_force = 0.0;  ///< of any pull [uN]
};

constexpr double ran_out_by = 0.75;   ///< beyond the planned radius: by then the zonules' insertion is near [mm]
constexpr double far_enough = 120.0;  ///< round the axis: a tear that kept to the circle so long is kept [degrees]

/// A state to go back to.
struct TornFlap {
    MembraneState sheet;
    Vec3 end = Vec3::Zero();  ///< of the tear that is led, in the sheet at rest
};

struct RescueResult {
    bool rescued = false;       ///< the tear ends within 0.3 mm of the planned radius again
    bool reached_edge = false;  ///< of what is modelled of the capsule, or within 0.2 mm of it
    double radius = 0.0;        ///< at which it ends [mm]
    int pulls = 0;              ///< that it took
};

class RunOutTrial {
public:
    /// Begins the tear in a full chamber: an arc of 1.2 rad by topology, led on by two pulls that are steered.
    /// mesh_seed: of another mesh of the same capsule.
    RunOutTrial(double age, std::uint64_t mesh_seed, int triangles = 1500);

    /// Of the end of the tear before the first pull [mm].
    [[nodiscard]] double start_radius() const { return start_.end.head<2>().norm(); }

    /// From the start: the chamber comes to be as it is, then the hand pulls.
    RunOutResult run(const Chamber& chamber, const Pulls& pulls, double out_by = ran_out_by);

    /// Where the last one left it.
    [[nodiscard]] TornFlap now() { return {scene_.sheet(), end_}; }

    /// The chamber comes to be as it is, then the hand leads the tear back: it unfolds the flap, holds it near the end
    /// of the tear and low over the lens, and pulls inwards by so much [degrees], as often as it takes [Little2006].
    RescueResult rescue(const TornFlap& from, const Chamber& chamber, double inwards);

private:
    CapsuleScene scene_;
    TornFlap start_;
    Vec3 end_ = Vec3::Zero();
};

}  // namespace rhexis::scenes
