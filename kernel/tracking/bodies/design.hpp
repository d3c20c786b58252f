// SPDX-License-Identifier: GPL-3.0-or-later
// Where the spheres of an instrument's replica stand, so that it is known from others and can be printed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tracking/bodies/mount.hpp"

namespace rhexis::tracking {

struct DesignPlan {
    std::string name{};       ///< of the body: the instrument's
    Handle handle{};          ///< in the instrument's frame, its tip at the origin
    double behind_mm = 95.0;  ///< of the tip, where the body's origin is; 30 to 200; less where a handle ends before it
    double reach_mm = 26.0;   ///< from the handle's axis to a sphere, and along it from the origin; 18 to 60
    double off_mm = 5.0;      ///< between a sphere and the handle, at least; 2 to 15
    double apart_mm = 2.1;    ///< as of check_signatures(); 0.5 to 5
    std::uint64_t seed = 1;
    int moves = 60000;  ///< of the annealing; 1000 to 10000000
    MountSizes mount{};
};

/// What a body is not to be taken for.
struct OtherBodies {
    std::vector<MarkerBody> unlike{};  ///< no three spheres of one can be three of the other: as of check_signatures()
    std::vector<MarkerBody> beside{};  ///< used at the same time: no distance is found in them either, so that two
                                       ///< spheres of one with a third of another are no three of it
};

/// Four spheres of 3 mm by simulated annealing [Kirkpatrick1983]: check_signatures() accepts the body together with all
/// others, mount_of() finds room for its struts, and the error of the tip that errors of the spheres lead to is small
/// [Fitzpatrick1998]. The body's frame: z along the handle, its origin on the handle's axis, x as much as may be that
/// of the instrument. The same for the same plan. The error: a number out of its range, or that no such places were
/// found and what was in the way in the end.
Result<MarkerBody> design_body(const DesignPlan& plan, const OtherBodies& others);

/// The root mean square error of a body's tip, where each sphere's place has one of 1 mm [Fitzpatrick1998].
double tip_error_share(const MarkerBody& body);

}  // namespace rhexis::tracking
