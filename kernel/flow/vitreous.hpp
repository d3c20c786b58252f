// SPDX-License-Identifier: GPL-3.0-or-later
// The vitreous behind the lens, as volumes: what lies in front of a hole in the posterior capsule or of a gap in the
// zonules, and what hangs in the wound. With it the viscoelastic that is laid before those openings, because that is
// what holds the vitreous back. Formulas, sources and limits: docs/vitreous.md.
#pragma once

#include <array>
#include <cstddef>

#include "flow/chamber.hpp"
#include "math/types.hpp"

namespace rhexis {

/// Where vitreous can come forward.
enum VitreousOpening : std::size_t { capsule_hole, zonule_gap, opening_count };

/// Constant while a scene runs.
struct VitreousModel {
    double push = 0.0;                 ///< of an eye whose vitreous presses, beyond the pressure of the eye [Pa]
    double lag = 0.3;                  ///< with which the pressure behind follows that in front [s]. Proposal
    double hyaloid_strength = 1000.0;  ///< tension at which the hyaloid breaks over an opening [uN/mm]; 0: broken
    double mobility = 1.2e-3;          ///< flow through an opening per pressure and area [mm^3/(s Pa mm^2)]. Proposal
    double chamber_volume = 250.0;     ///< of the anterior chamber [mm^3]
    double injection = 40.0;           ///< of a syringe pressed with full force [mm^3/s]. Proposal
    double most_pressure = 80.0 * pascal_per_mmhg;  ///< of the eye against which a hand can press [Pa]. Proposal
    double mound = 2.0;      ///< height of viscoelastic that holds an opening shut [mm]. Proposal
    double margin = 1.0;     ///< by which it lies over the edge of the opening [mm]. Proposal
    double held_back = 0.9;  ///< share of the pressure that it takes there. Proposal
    double near = 3.0;       ///< of an opening: what comes out of a cannula there lies before it [mm]. Proposal
    double gape = 20.0;      ///< of a wound that a sleeve leaves, times the leak beside it. Proposal
    double gape_s = 0.3;     ///< for which it stands open [s]. Proposal
    double strand_stiffness = 2000.0;  ///< of vitreous that a mouth holds, pulled away [uN/mm]. Proposal
    Vec3 wound = Vec3::Zero();         ///< inner lip of the main wound [mm]
    double start_front = 0.0;          ///< as in VitreousState
    double start_wound = 0.0;
    double start_marked = 0.0;
    double start_fill = 0.0;  ///< share of the chamber that viscoelastic fills
};

/// Changes from step to step. Volumes in mm^3.
struct VitreousState {
    bool broken = false;                        ///< the hyaloid over an opening
    double behind = 0.0;                        ///< pressure of the vitreous [Pa]
    double drive = 0.0;                         ///< with which it presses on the wall around the openings now [Pa]
    std::array<double, opening_count> front{};  ///< vitreous in front of each opening
    double wound = 0.0;                         ///< in the main wound
    double marked = 0.0;         ///< share of what is in front and in the wound that triamcinolone has made white
    double cut = 0.0;            ///< cut and taken away so far
    int tool = -1;               ///< whose mouth it lies in; -1: none
    Vec3 caught = Vec3::Zero();  ///< where that mouth caught it [mm]
    double traction = 0.0;       ///< pull on it, and by it on the retina [uN]
    double peak_traction = 0.0;
    double checked = 0.0;                      ///< triamcinolone given since vitreous last came forward or was cut
    std::array<double, opening_count> plug{};  ///< viscoelastic before each opening
    double filled = 0.0;                       ///< viscoelastic elsewhere in the chamber
    double given = 0.0;                        ///< viscoelastic so far
    double open_s = 0.0;                       ///< for which the main wound still gapes [s]
    double inside = 0.0;                       ///< 1: an instrument stood in the main wound in the last step
};

/// As an operation left it, or an exercise begins with it, in an eye at rest.
VitreousState rest_state(const VitreousModel& model, const ChamberModel& chamber);

/// All that is in front of the openings.
double vitreous_in_front(const VitreousState& state);

/// Radius of the ball that a volume fills [mm].
double vitreous_radius(double volume);

/// Viscoelastic in the chamber, share of it.
double filled_share(const VitreousModel& model, const VitreousState& state);

/// Share of an opening of this area [mm^2] that a plug covers.
double covered_share(const VitreousModel& model, double plug, double area);

}  // namespace rhexis
