// SPDX-License-Identifier: GPL-3.0-or-later
// An anterior capsule that is torn at random, by topology alone and by instruments, and looked at after every change.
#pragma once

#include <cstdint>
#include <string>

namespace rhexis::scenes {

struct RandomTearsTask {
    int operations = 2000;       ///< > 0: an edit asked for, a grasp, a pull, or a stab with the needle
    int triangles = 200;         ///< of the sheet, about, 200 to 20,000
    int longest_sheet = 250;     ///< operations on one sheet before a new one is taken; sooner where it is all torn
    double by_instrument = 0.2;  ///< share of the operations, 0 to 1
    std::uint64_t seed = 1;
};

/// What happened, and the worst of what was seen after any change.
struct RandomTears {
    long operations = 0;
    long edits = 0;         ///< asked for and made
    long refused = 0;       ///< asked for, and impossible in the mesh as it was
    long mad = 0;           ///< of these: no such tip, node or triangle, or no direction
    long grasps = 0;        ///< that took hold of something
    long pulls = 0;         ///< of what was held
    long punctures = 0;     ///< by the needle
    long torn_by_pull = 0;  ///< sheets that steps of physics made: tears, cuts and punctures
    long steps = 0;
    long given_up = 0;   ///< steps that had to be
    long taken_out = 0;  ///< pieces that jaws took out of the eye; each ends its sheet's run
    long sheets = 0;
    long torn_up = 0;                ///< of these: until a tenth of the edges between triangles was left
    double least_angle = 180.0;      ///< [degrees]
    double most_cosine = -1.0;       ///< of any angle over what the rule allows: at most 0
    double least_edge = 1.0;         ///< shortest edge over the mean one at the start
    double most_of_bound = 0.0;      ///< triangles, share of the bound that kernel/topology/tear.hpp states
    double most_per_triangle = 0.0;  ///< nodes
    int most_nodes = 0;
    int most_triangles = 0;
    double area_off = 0.0;  ///< relative, likewise all below
    double mass_off = 0.0;
    double torn_off = 0.0;     ///< area torn, against the edges that are there
    double energy_off = 0.0;   ///< energy torn, against that area
    double elastic_off = 0.0;  ///< energy of the sheet over an edit, of that before
    std::uint64_t print = 0;   ///< of the places of all nodes at the ends of all sheets: the same for the same task
    std::string fault;         ///< the first; empty: none
};

RandomTears random_tears(const RandomTearsTask& task);

}  // namespace rhexis::scenes
