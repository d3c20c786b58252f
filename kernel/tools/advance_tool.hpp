// SPDX-License-Identifier: GPL-3.0-or-later
// The tools stage: what a device sample makes of an instrument in one step.
#pragma once

#include <string>

#include "flow/device_sample.hpp"
#include "flow/tool.hpp"

namespace rhexis {

struct ToolSettings {
    double power_limit = 1.0;     ///< ultrasound at full pedal, share of full power, 0 to 1
    double pulse_hz = 0.0;        ///< ultrasound pulses per second; 0: continuous
    double duty = 0.5;            ///< share of a pulse's period with ultrasound, above 0 to 1
    double bottle_height = 0.0;   ///< drip chamber above the eye [mm]
    bool infusion = true;         ///< its line is open
    double pump_flow = 0.0;       ///< at full aspiration [mm^3/s]
    double vacuum_limit = 0.0;    ///< at full aspiration [Pa]
    double cut_rate = 0.5;        ///< of a cutter, share of fastest_cutter
    double cutter_flow = 0.0;     ///< of its pump at full aspiration [mm^3/s]
    double cutter_vacuum = 0.0;   ///< at full aspiration [Pa]
    double ia_flow = 0.0;         ///< of an aspirator's pump at full aspiration [mm^3/s]
    double ia_vacuum = 0.0;       ///< at full aspiration [Pa]
    bool cut_first = true;        ///< pedal 2 cuts and 3 sucks as well; false: 2 sucks and 3 cuts as well
    double max_speed = 2000.0;    ///< a sample that asks for more is a tracking error [mm/s]
    double max_distance = 200.0;  ///< of the tip from the centre of the eye [mm]
};

struct ToolStep {
    ToolState state;
    std::string rejected;  ///< why the sample was not used, one line; empty if it was
};

/// The tool at the end of a step of dt [s]. Pedal p: irrigation from p = 1; aspiration grows over p = 1 to 2 (position
/// 2), ultrasound over p = 2 to 3 (position 3) up to power_limit, in pulses that begin with it. A finite pedal or jaw
/// beyond its range is clamped. A sample with a number that is not finite, a pose out of range or a jump is rejected as
/// a whole: everything is held, nothing moves. A tool that was withdrawn appears where the sample says, without a jump.
ToolStep next_tool(const ToolModel& model, const ToolState& previous, const DeviceSample& sample, double dt,
                   const ToolSettings& settings);

/// When no sample came: everything stays, nothing moves.
ToolState hold_tool(const ToolState& previous);

}  // namespace rhexis
