// SPDX-License-Identifier: GPL-3.0-or-later
// Provocations of the models without meshes - chamber, wounds, iris, cortex, viscoelastic, vitreous, hydrodissection,
// zonules - at the longest step, with settings at the ends of their ranges. Each returns what it measured; the gates
// stand where it is called.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rhexis::scenes {

/// Models that are run together.
struct LumpedScene {
    const char* name;
    std::vector<std::string> tissues;
    std::vector<std::string> instruments;
    bool bursts = false;  ///< something may give way at once: then when decides
};
std::span<const LumpedScene> lumped_scenes();

struct Extremes {
    bool finite = true;     ///< all that is observed, in every step
    double lowest = 0.0;    ///< smallest volume of anything that is there or not, 0 or more if sound [mm^3]
    double pressure = 0.0;  ///< most of the eye, above or below the atmosphere [Pa]
    double chatter =
        0.0;             ///< while nothing that is asked for changes: steps whose pressure turns by over a mmHg, share
    double apart = 0.0;  ///< pressure in steps of 20 ms against that in steps of 1 ms, rms, over the range it goes
    int failures = 0;    ///< steps that no way could solve
};
/// So many seconds of a scene in steps of 20 ms and again of 1 ms. Every setting of its models and of the machine lies
/// at an end of its range, which is drawn by the seed, like the hand's way and pedal.
Extremes run_extremes(const LumpedScene& scene, std::uint64_t seed, double seconds);

}  // namespace rhexis::scenes
