// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/settings.hpp"

#include <algorithm>
#include <array>

#include "base/near_names.hpp"
#include "base/numbers.hpp"

namespace rhexis {
namespace {

constexpr auto known_settings = std::to_array<SettingInfo>({
    {"bag.friction", "1", 0.0, 2.0, 0.1, false, "Of the bag's wall on an implant, Coulomb coefficient."},
    {"bag.triangles", "1", 300.0, 8000.0, 800.0, false, "Of the bag that an implant is laid into, about so many."},
    {"beads.count", "1", 1.0, 6.0, 3.0, false, "Beads in the chamber, for practice with forceps."},
    {"capsule.fibres", "1", 0.0, 1.0, 0.0, false,
     "Fibres of the anterior capsule: 0: none, as anatomy has it; 1: in circles, as a model of them has it."},
    {"capsule.hole_mm", "mm", 0.0, 6.0, 0.0, false,
     "Diameter of a hole that the posterior capsule has at the start; 0: it is whole."},
    {"capsule.hole_x_mm", "mm", -3.0, 3.0, 0.0, false, "Its place, to the surgeon's right of the bag's axis."},
    {"capsule.hole_y_mm", "mm", -3.0, 3.0, 0.0, false, "Its place, away from the surgeon."},
    {"capsule.strength", "1", 0.1, 2.0, 1.0, false,
     "Strain that the posterior capsule bears, or the opening of a bag, share of the standard one."},
    {"capsule.toughness", "1", 0.2, 5.0, 1.0, false,
     "Energy that a tear of the anterior capsule takes, share of the standard one."},
    {"capsule.triangles", "1", 200.0, 20000.0, 1500.0, false, "Of the anterior capsule, about so many."},
    {"capsule.trypan_blue", "1", 0.0, 1.0, 0.0, false,
     "Stain of the anterior capsule with trypan blue, in the picture: 0 none, 1 full."},
    {"capsulorhexis.diameter_mm", "mm", 3.0, 8.0, 5.25, false, "Diameter of the opening in the anterior capsule."},
    {"cartridge.bore_mm", "mm", 1.0, 4.0, 2.8, false, "Inner diameter of the cartridge where the implant is laid."},
    {"cartridge.friction", "1", 0.0, 2.0, 0.1, false, "Of the cartridge's wall, Coulomb coefficient."},
    {"cartridge.inverted", "1", 0.0, 1.0, 0.0, false,
     "1: the implant is folded lying on its front and the injector held turned by half a turn, so that haptics on its "
     "optic come out behind it."},
    {"cartridge.nozzle_mm", "mm", 1.0, 4.0, 2.8, false,
     "Inner diameter of the cartridge at its tip; at most that where the implant is laid."},
    {"cartridge.tucked", "1", 0.0, 1.0, 1.0, false,
     "1: the implant is folded with its haptics on its optic; 0: they lie before and behind it."},
    {"cortex.adhesion", "1", 0.1, 5.0, 1.0, false,
     "Pull that strips cortex from the capsule, share of the standard one."},
    {"cortex.left", "1", 0.0, 1.0, 1.0, false, "Share of the bag's sectors that have cortex at the start."},
    {"cutter.cut_first", "1", 0.0, 1.0, 1.0, true,
     "1: the cutter's pedal cuts at 2 and sucks as well at 3; 0: it sucks at 2 and cuts as well at 3."},
    {"cutter.cuts_per_min", "1/min", 50.0, 5000.0, 2500.0, true, "Of the cutter's blade."},
    {"cutter.flow_ml_min", "ml/min", 0.0, 60.0, 15.0, true, "Flow of the aspiration pump at full pedal, cutter."},
    {"cutter.vacuum_mmhg", "mmHg", 0.0, 650.0, 250.0, true, "Vacuum at which the pump stops, cutter."},
    {"hydrodissection.freed", "1", 0.0, 1.0, 1.0, false, "Share of the cortex that no longer adheres to the capsule."},
    {"hydrodissection.viscoelastic_fill", "1", 0.0, 1.3, 0.8, false,
     "Share of the anterior chamber that viscoelastic fills when hydrodissection begins."},
    {"ia.flow_ml_min", "ml/min", 0.0, 60.0, 30.0, true,
     "Flow of the aspiration pump at full pedal, irrigation/aspiration tip."},
    {"ia.vacuum_mmhg", "mmHg", 0.0, 650.0, 400.0, true, "Vacuum at which the pump stops, irrigation/aspiration tip."},
    {"implant.centre_mm", "mm", 0.1, 2.0, 0.7, false, "Thickness of the implant's optic in its middle."},
    {"implant.edge_mm", "mm", 0.05, 2.0, 0.25, false, "Thickness of the implant's optic at its edge."},
    {"implant.haptic_mm", "mm", 0.05, 1.0, 0.4, false, "Thickness of the implant's haptics."},
    {"implant.in_place", "1", 0.0, 1.0, 0.0, false,
     "1: an implant lies in the eye of a scene that has neither lens nor implant, in the picture only."},
    {"implant.modulus_mpa", "MPa", 0.1, 10.0, 1.0, false, "Young's modulus of the implant in the long run."},
    {"implant.tackiness_kpa", "kPa", 0.0, 100.0, 0.0, false,
     "Pull per area that parts layers of the implant which were pressed together."},
    {"implant.triangles", "1", 400.0, 8000.0, 743.0, false, "Of the implant, about so many."},
    {"injector.push_n", "N", 1.0, 100.0, 30.0, false, "Most that a hand presses the plunger of the injector with."},
    {"machine.bottle_cm", "cm", 0.0, 150.0, 75.0, true, "Height of the infusion bottle above the eye."},
    {"machine.flow_ml_min", "ml/min", 0.0, 60.0, 25.0, true, "Flow of the aspiration pump at full pedal."},
    {"machine.infusion", "1", 0.0, 1.0, 1.0, true,
     "1: the infusion's line is open; 0: shut, kinked, or the bottle is empty."},
    {"machine.tubing_mm3_mmhg", "mm^3/mmHg", 0.05, 1.0, 0.15, false, "Volume per pressure of the aspiration tubing."},
    {"machine.vacuum_mmhg", "mmHg", 0.0, 650.0, 80.0, true, "Vacuum at which the pump stops, at full pedal."},
    {"microscope.depth_of_field_mm", "mm", 0.2, 20.0, 1.4, false,
     "Depth within which all looks sharp, from end to end; see docs/picture.md."},
    {"microscope.field_mm", "mm", 10.0, 30.0, 14.6, false, "Diameter of the microscope's field at the eye."},
    {"microscope.focus_mm", "mm", -8.0, 8.0, 2.0, false,
     "How far over the plane of the pupil the microscope is focused at the start."},
    {"microscope.x_mm", "mm", -4.0, 4.0, 1.6, false,
     "How far to the surgeon's right of the pupil the microscope stands at the start."},
    {"microscope.y_mm", "mm", -4.0, 4.0, 1.2, false,
     "How far beyond the pupil, seen from the surgeon, the microscope stands at the start."},
    {"nucleus.segments", "1", 0.0, 8.0, 0.0, false, "Segments into which a laser has cut the lens: 0, 2, 4, 6 or 8."},
    {"nucleus.trench_mm", "mm", 0.0, 2.0, 0.0, false,
     "Width of trenches that were sculpted along those cuts, down to the back of the nucleus; 0: none."},
    {"phaco.duty", "1", 0.05, 1.0, 0.5, true, "Share of a pulse's period with ultrasound."},
    {"phaco.power_limit", "1", 0.0, 1.0, 1.0, true,
     "Ultrasound power at full pedal, share of the machine's full power."},
    {"phaco.pulse_hz", "1/s", 0.0, 100.0, 0.0, true, "Ultrasound pulses per second; 0: continuous."},
    {"side_port.angle_deg", "degrees", -150.0, 150.0, 80.0, false,
     "Angle of the planned side port from the main wound, towards the surgeon's left; negative: right."},
    {"suprachoroidal.pressure_mmhg", "mmHg", 0.0, 80.0, 0.0, true,
     "Pressure of bleeding behind the choroid, above that of the eye at rest; 0: none.", true},
    {"tamponade.fill", "1", 0.0, 1.0, 0.0, false,
     "Share of the anterior chamber that viscoelastic fills at the start, where fluid flows and vitreous is "
     "simulated."},
    {"viscoelastic.angle_mm3", "mm^3", 0.0, 100.0, 20.0, false,
     "Viscoelastic in the angle of the chamber at the start, where its removal is simulated."},
    {"viscoelastic.behind_mm3", "mm^3", 0.0, 100.0, 40.0, false, "Viscoelastic behind the implant, likewise."},
    {"viscoelastic.fill", "1", 0.0, 1.2, 1.0, false,
     "Share of the anterior chamber that viscoelastic fills at the start."},
    {"viscoelastic.front_mm3", "mm^3", 0.0, 300.0, 180.0, false,
     "Viscoelastic in front of the implant at the start, where its removal is simulated."},
    {"viscoelastic.leak", "1/s", 0.0, 0.1, 0.004, false,
     "Share of a full chamber that leaves beside each instrument in a wound: a thin agent leaves faster."},
    {"vitreous.front_mm3", "mm^3", 0.0, 100.0, 0.0, false,
     "Vitreous before the hole in the posterior capsule at the start."},
    {"vitreous.hyaloid", "1", 0.0, 3.0, 1.0, false,
     "Strength of the hyaloid, share of the standard one; 0: it is broken at the start."},
    {"vitreous.marked", "1", 0.0, 1.0, 0.0, false, "Share of it that triamcinolone shows at the start."},
    {"vitreous.pressure_mmhg", "mmHg", 0.0, 25.0, 10.0, false,
     "Pressure behind the lens, which viscoelastic stands against."},
    {"vitreous.push_mmhg", "mmHg", 0.0, 15.0, 0.0, false,
     "Pressure of the vitreous beyond that of the chamber: positive pressure."},
    {"vitreous.wound_mm3", "mm^3", 0.0, 50.0, 0.0, false, "Vitreous in the main wound at the start."},
    {"wound.leak_ml_min", "ml/min", 0.0, 15.0, 3.0, false, "Leak of the wounds around the instruments at 55 mmHg."},
    {"wounds.main_burn", "1", 0.0, 1.0, 0.0, false, "Burn of the main wound at the start."},
    {"wounds.main_inner_lip_mm", "mm", 0.2, 3.0, 1.8, false,
     "Distance of the main wound's inner lip from the limbus at the start."},
    {"wounds.main_peel_mm", "mm", 0.0, 5.0, 0.0, false,
     "Length of Descemet's membrane that hangs off at the main wound's inner lip at the start."},
    {"wounds.main_tunnel_mm", "mm", 0.7, 4.0, 2.0, false, "Length of the main wound's tunnel at the start."},
    {"wounds.main_width_mm", "mm", 1.0, 6.0, 2.4, false, "Width of the main wound at the start."},
    {"wounds.side_tunnel_mm", "mm", 0.7, 4.0, 1.5, false, "Length of the side port's tunnel at the start."},
    {"wounds.side_width_mm", "mm", 0.5, 3.0, 1.0, false, "Width of the side port at the start."},
    {"wounds.uncut", "1", 0.0, 2.0, 0.0, false,
     "Wounds that are not cut at the start: 0: none; 1: the main wound; 2: nor the side port."},
    {"zonules.lost_deg", "deg", 0.0, 345.0, 0.0, false,
     "Arc without zonules at the start, in steps of 15; where tissues name zonules."},
    {"zonules.lost_from_deg", "deg", 0.0, 360.0, 0.0, false,
     "Where that arc begins, against the clock from the surgeon's right."},
    {"zonules.strength", "1", 0.05, 2.0, 1.0, false, "Stiffness of the zonules, share of that at the patient's age."},
    {"zonules.tension", "1", 0.0, 2.0, 1.0, false,
     "Tension of the zonules that hold the anterior capsule at rest, share of the standard one."},
    {"zonules.toughness", "1", 0.02, 3.0, 1.0, false,
     "Stretch at which a zonule breaks, share of 3.82 mm; where tissues name zonules."},
});

std::vector<std::string> names() {
    std::vector<std::string> list;
    for (const SettingInfo& info : known_settings) {
        list.emplace_back(info.name);
    }
    return list;
}

}  // namespace

std::span<const SettingInfo> setting_table() { return known_settings; }

const SettingInfo* find_setting(std::string_view name) {
    const auto* found = std::find_if(known_settings.begin(), known_settings.end(),
                                     [&](const SettingInfo& info) { return info.name == name; });
    return found == known_settings.end() ? nullptr : found;
}

Status check_setting(std::string_view name, double value) {
    const SettingInfo* info = find_setting(name);
    if (info == nullptr) {
        return Error{"there is no setting " + std::string(name), "settings", suggestion(name, names())};
    }
    return check_range("settings." + std::string(name), value, info->minimum, info->maximum);
}

}  // namespace rhexis
