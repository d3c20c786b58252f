-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events of putting a folded implant into the bag. An exercise names them, gives the items that they cap, and may
-- put another value in place of any field. They need the goal fill_percent.

local with = require "with_fields"

local implant_events = {}

local coming_out = "implant.delivered > 0.02 and not implant.released"

--- Without viscoelastic the bag is collapsed, and nothing slows the implant.
function implant_events.unfilled(own)
    return with({
        when = coming_out .. " and 100 * viscoelastic.fill < goal.fill_percent - 15",
        hold_s = 0.3,
        recovered = "100 * viscoelastic.fill >= goal.fill_percent",
        deadline_s = 30,
        near_miss_s = 0,
        severity = "minor",
        cue = "The chamber is shallow, the bag lies flat, and the implant comes near to the cornea.",
        advice = "Stop pushing, and fill bag and chamber before the implant comes out.",
        evidence = { "viscoelastic.fill", "implant.delivered", "implant.cornea_mm" },
    }, own)
end

--- The plunger needs more than a hand gives. Nothing undoes that: it is put right when nobody pushes any more.
function implant_events.jammed(own)
    return with({
        when = "injector.jammed",
        recovered = "injector.force_mN < 1000",
        recovered_hold_s = 0.5,
        deadline_s = 5,
        near_miss_s = 0,
        severity = "critical",
        cue = "The plunger goes no farther, the nozzle widens.",
        advice = "The implant is jammed: stop pushing, draw the plunger back a little, and take a wider cartridge.",
        evidence = { "injector.force_mN", "injector.plunger_mm", "implant.delivered" },
    }, own)
end

--- The haptics look like an S instead of a 7 and an L.
function implant_events.upside_down(own)
    return with({
        when = "implant.released and implant.upside_down",
        hold_s = 2,
        recovered = "not implant.upside_down and bag.rim_stretch < 1.2",
        recovered_hold_s = 1,
        deadline_s = 90,
        near_miss_s = 0,
        severity = "critical",
        cue = "Seen from the front the haptics leave the optic clockwise, like an S.",
        advice = "The implant is upside down: turn it over under viscoelastic, without stretching the rim, or take it "
            .. "out.",
        evidence = { "implant.tilt_deg", "implant.haptics_in_bag", "bag.rim_stretch" },
    }, own)
end

--- Hook or forceps have left, and a haptic is still before the rim.
function implant_events.haptic_out(own)
    return with({
        when = { "implant.released and (hook.present or lens_forceps.present)",
            "not hook.present and not lens_forceps.present and implant.haptics_in_bag < 2" },
        hold_s = 1,
        recovered = "implant.haptics_in_bag >= 2 and implant.decentration_mm <= 0.5",
        deadline_s = 60,
        near_miss_s = 0,
        quiet_s = 5,
        severity = "critical",
        cue = "A haptic lies in front of the rim, the optic is off the middle.",
        advice = "A haptic is not in the bag: go back with lens forceps. Draw its arm into the opening hand over hand, "
            .. "until its elbow is within the rim, press it down, and lead it back behind the rim.",
        evidence = { "implant.haptic_leading_in_bag", "implant.haptic_trailing_in_bag", "implant.decentration_mm" },
    }, own)
end

--- It does not unfold by itself. Arms that lie in the bag touch the optic's edge too: nothing is wrong with that.
function implant_events.haptic_stuck(own)
    return with({
        when = "implant.released and implant.haptics_on_optic > 0 and "
            .. "(implant.haptics_in_bag < 2 or implant.tilt_deg > 5)",
        hold_s = 20,
        recovered = "implant.haptics_in_bag >= 2 and implant.tilt_deg <= 5",
        deadline_s = 60,
        near_miss_s = 0,
        quiet_s = 5,
        severity = "critical",
        cue = "A haptic stays folded on the optic, which is tilted.",
        advice = "The haptic sticks to the optic: take its arm with lens forceps, lift it off, and lead it behind the "
            .. "rim.",
        evidence = { "implant.haptics_on_optic", "implant.tilt_deg", "implant.unfolded" },
    }, own)
end

--- The opening is wider than its edge bears for long.
function implant_events.rim_stretched(own)
    return with({
        when = "bag.rim_stretch > 1.25",
        recovered = "bag.rim_stretch < 1.15",
        deadline_s = 3,
        near_miss_s = 0,
        harm = "bag.rim_split",
        severity = "minor",
        cue = "The edge of the opening is drawn out to an oval.",
        advice = "You pull on the rim: let go, and come under it from the middle.",
        evidence = { "bag.rim_stretch", "bag.rim_force_mN" },
    }, own)
end

--- Nothing closes it again: it is put right when nothing pulls on the rim any more.
function implant_events.rim_split(own)
    return with({
        when = "bag.rim_split",
        recovered = "bag.rim_force_mN < 1 and bag.rim_stretch < 1.1",
        recovered_hold_s = 1,
        deadline_s = 5,
        near_miss_s = 0,
        severity = "critical",
        cue = "A notch in the edge of the opening, the optic tilts.",
        advice = "The rim has split: stop turning, take the load off it, and leave the haptics across the split.",
        evidence = { "bag.rim_peak_stretch", "bag.rim_force_mN", "implant.tilt_deg" },
    }, own)
end

function implant_events.capsule_struck(own)
    return with({
        when = "bag.posterior_force_mN > 5",
        recovered = "bag.posterior_force_mN < 0.5",
        recovered_hold_s = 0.5,
        deadline_s = 2,
        near_miss_s = 0,
        severity = "critical",
        cue = "Folds run from the end of the instrument across the back of the bag.",
        advice = "You press on the posterior capsule: lift the instrument at once.",
        evidence = { "bag.posterior_force_mN", "bag.posterior_touches" },
    }, own)
end

--- By the implant, or by an instrument away from the wound that it goes through.
function implant_events.cornea_touched(own)
    return with({
        when = "implant.cornea_mm < 0.05 or (hook.endothelium_mm < 0.1 and hook.tip_x_mm > -2.5)",
        recovered = "not (implant.cornea_mm < 0.2) and not (hook.endothelium_mm < 0.2 and hook.tip_x_mm > -2.5)",
        recovered_hold_s = 0.3,
        deadline_s = 4,
        near_miss_s = 0,
        severity = "minor",
        cue = "A haptic or the optic shows at the back of the cornea.",
        advice = "Too high: lead the implant down, through the opening, before more of it unfolds.",
        evidence = { "implant.cornea_mm", "hook.endothelium_mm", "viscoelastic.fill" },
    }, own)
end

return implant_events
