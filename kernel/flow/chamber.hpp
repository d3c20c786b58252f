// SPDX-License-Identifier: GPL-3.0-or-later
// The fluid of the anterior chamber and of the machine, without dimensions: two elastic tanks (eye, aspiration tubing)
// between a bottle, a pump and a leaking wound. What each number means, where it comes from and where it ends:
// docs/chamber.md. Pressures are above atmospheric; a vacuum v in the tubing is the pressure -v.
#pragma once

namespace rhexis {

inline constexpr double pascal_per_mmhg = 133.322;                                            ///< [Pa]
inline constexpr double mm3_s_per_ml_min = 1000.0 / 60.0;                                     ///< [mm^3/s]
inline constexpr double resistance_per_mmhg_min_per_ml = pascal_per_mmhg / mm3_s_per_ml_min;  ///< [Pa s/mm^3]
inline constexpr double usual_flow = 1000.0 / 3.0;  ///< of a machine, 20 ml/min [mm^3/s]

/// Constant while a scene runs. check() in physics/fluid/chamber_flow.hpp has the ranges.
struct ChamberModel {
    /// Volume per pressure of the eye at 50 mmHg [mm^3/Pa]: 1 / (K P) with K = 0.0126 / mm^3 [Pallikaris2005].
    double eye_compliance = 1.6 / pascal_per_mmhg;
    /// How the eye stiffens with pressure: 1, in proportion to it [Friedenwald1937]; 0, not at all (a linear tank).
    double eye_stiffening = 1.0;
    /// Below this the eye is a linear tank as soft as it is here: cornea and capsule move in [Pa]. Proposal.
    double collapse_pressure = 5.0 * pascal_per_mmhg;
    /// Volume per pressure of the aspiration tubing [mm^3/Pa]. Fitted to the lowest pressures in [Vasavada2014].
    double tube_compliance = 0.15 / pascal_per_mmhg;
    /// Bottle to chamber: line and sleeve [Pa s/mm^3]. From pressures under surgery [Vasavada2014].
    double infusion_resistance = 0.8 * resistance_per_mmhg_min_per_ml;
    /// Bore of the tip when nothing is in it [Pa s/mm^3]. Poiseuille, 0.7 mm by 30 mm.
    double tip_resistance = 0.7 * resistance_per_mmhg_min_per_ml;
    /// Aspiration tubing [Pa s/mm^3]. With the tip 3 mmHg per ml/min, amid three machines [OlsonFluidics].
    double tube_resistance = 2.3 * resistance_per_mmhg_min_per_ml;
    /// Flow through the wounds per pressure of the eye [mm^3/(s Pa)]: 3 ml/min at 55 mmHg. Rigs: to 15 [Zeiss2023].
    double leak_conductance = 3.0 * mm3_s_per_ml_min / (55.0 * pascal_per_mmhg);
    /// The pump slows down over this last part before the vacuum limit [Pa]. Proposal.
    double pump_band = 10.0 * pascal_per_mmhg;
    /// Of the valve that lets fluid into the tubing to end its vacuum [Pa s/mm^3]. Proposal.
    double vent_resistance = 5.0 * resistance_per_mmhg_min_per_ml;
    double fluid_density = 1.0e-3;                  ///< of the irrigation [g/mm^3]
    double rest_pressure = 15.0 * pascal_per_mmhg;  ///< of the closed eye before anything is done [Pa]
    double area = 106.0;  ///< by which a change of the eye's volume deepens the chamber [mm^2]: limbus 11.64 mm wide
    /// Of that deepening, the part by which lens and iris go back; the rest is the cornea. Proposal.
    double diaphragm_share = 0.7;
    /// Hole in the posterior capsule that takes half of what holds the diaphragm forward [mm^2]. Proposal.
    double half_hole_area = 1.5;
};

/// What machine and operator ask for; constant during a step.
struct ChamberControl {
    bool irrigation = false;     ///< pedal at 1 or more: the clamp on the infusion line is open
    bool vent = false;           ///< pedal below 2: the vent valve is open
    double bottle_height = 0.0;  ///< drip chamber above the eye [mm]
    double pump_flow = 0.0;      ///< what the pump moves well below the vacuum limit [mm^3/s]
    double vacuum_limit = 0.0;   ///< the pump stands still at this vacuum [Pa]
    double tip_open = 1.0;       ///< share of the free tip's conductance, 0: occluded
    double wound_open =
        1.0;  ///< share of the wound's leak: 1 with an instrument in it, 0 closed, to 3 burnt, to 30 gaping
};

/// Fluid moved since the start [mm^3]. Backward flow counts negative.
struct ChamberTotals {
    double infused = 0.0;    ///< bottle to eye
    double vented = 0.0;     ///< vent to tubing
    double aspirated = 0.0;  ///< tubing to pump
    double leaked = 0.0;     ///< eye to wounds
};

/// The wall of the main wound.
struct WoundState {
    double temperature = 34.0;  ///< [degrees C]
    double hot_s = 0.0;         ///< time that it has been hot enough to shrink [s]
};

/// Changes from step to step; always
///   eye_volume + tube_volume = constant + infused + vented - aspirated - leaked.
struct ChamberState {
    double eye_volume = 0.0;   ///< beyond that of an eye at the collapse pressure [mm^3]; negative: collapsed
    double tube_volume = 0.0;  ///< beyond that of tubing at atmospheric pressure [mm^3]; negative: vacuum
    ChamberTotals totals;
    WoundState wound;
};

/// Of one step: mean flows [mm^3/s] and the range of the eye's pressure [Pa], which may dip within a step.
struct ChamberFlows {
    double infusion = 0.0;
    double tip = 0.0;  ///< eye to tubing
    double pump = 0.0;
    double leak = 0.0;
    double vent = 0.0;
    double lowest_eye_pressure = 0.0;
    double highest_eye_pressure = 0.0;
};

double eye_pressure(const ChamberModel& model, double eye_volume);        ///< [Pa]
double eye_stiffness(const ChamberModel& model, double eye_volume);       ///< pressure per volume [Pa/mm^3]
double eye_volume(const ChamberModel& model, double eye_pressure);        ///< [mm^3]
double tube_pressure(const ChamberModel& model, double tube_volume);      ///< [Pa], negative: vacuum
double bottle_pressure(const ChamberModel& model, double bottle_height);  ///< hydrostatic [Pa]

/// Depth of the chamber beyond that at rest [mm].
double depth_change(const ChamberModel& model, double eye_volume);

/// How far lens and iris are shifted along z, negative: back [mm]. hole_area: in the posterior capsule [mm^2], which
/// holds them against the fluid in front.
double diaphragm_shift(const ChamberModel& model, double eye_volume, double hole_area);

/// Share of the burn that shrinks the wound most: 0 until it has been hot for a second, 1 from three seconds on.
double burn_share(const WoundState& wound);

/// A cool wound with that share of a burn.
WoundState burnt_wound(double burn);

/// Tanks filled to these pressures [Pa], nothing moved yet.
ChamberState chamber_state(const ChamberModel& model, double eye_pressure, double tube_pressure);

}  // namespace rhexis
