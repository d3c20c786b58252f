-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events of cracking a nucleus with two instruments. An exercise names them, gives the items that they cap, and
-- may put another value in place of any field.

local with = require "with_fields"

local crack_events = {}

-- How far from the posterior capsule a tip may be to count as in the lower third, or the lower half, of the groove.
crack_events.lower_third = "groove.floor_posterior_mm + 0.33 * groove.depth_mm"
crack_events.lower_half = "groove.floor_posterior_mm + 0.5 * groove.depth_mm"
crack_events.higher_tip = "max(phaco.tip_posterior_mm, spatula.tip_posterior_mm)"

local lower_third, lower_half, higher_tip = crack_events.lower_third, crack_events.lower_half, crack_events.higher_tip
local both_press = "phaco.force_mN > 2 and spatula.force_mN > 2"
local both_free = "not phaco.in_contact and not spatula.in_contact"
--- Both tips are over the lens.
crack_events.both_out = "phaco.tip_depth_mm < 0 and spatula.tip_depth_mm < 0 and " .. both_free

--- Both tips leave although something still bridges a groove. bridge: share of the nucleus that does, as a text.
function crack_events.incomplete(bridge, own)
    return with({
        when = { ("%s and %s < %s"):format(both_press, higher_tip, lower_half),
            ("%s and 100 * %s > goal.bridge_percent"):format(crack_events.both_out, bridge) },
        hold_s = 3,
        recovered = ("100 * %s <= goal.bridge_percent"):format(bridge),
        deadline_s = 60,
        near_miss_s = 0,
        quiet_s = 5,
        severity = "critical",
        cue = "The halves hang together: the bright line in the floor of the groove stops before its ends.",
        advice = "The split is not complete: go back with both tips into the lower third, next to where the halves "
            .. "still hang together, and part again.",
        evidence = { "crack.bridge_share", "crack.faces", "groove_1.depth_share" },
    }, own)
end

function crack_events.shallow(own)
    return with({
        when = ("%s and %s > %s"):format(both_press, higher_tip, lower_half),
        hold_s = 0.3,
        recovered = ("(%s and not (%s)) or %s < %s"):format("phaco.force_mN < 1", "spatula.force_mN > 1",
            higher_tip, lower_third),
        deadline_s = 2,
        near_miss_s = 0,
        quiet_s = 2,
        severity = "minor",
        cue = "The walls lean outwards above, the floor stays shut.",
        advice = "The tips are too high: close them, go down to the lower third of the groove, then part.",
        evidence = { "phaco.tip_posterior_mm", "spatula.tip_posterior_mm", "groove.floor_posterior_mm" },
    }, own)
end

function crack_events.pushing(own)
    return with({
        when = "lens.displacement_mm > 0.5 and (phaco.in_contact or spatula.in_contact)",
        recovered = "lens.displacement_mm < 0.25 and " .. both_free,
        recovered_hold_s = 0.5,
        deadline_s = 3,
        near_miss_s = 0,
        severity = "critical",
        cue = "The whole lens moves away from the instruments.",
        advice = "You push the nucleus instead of parting it: let go, let it come back, and part with both tips at "
            .. "the same place, by the same amount.",
        evidence = { "phaco.force_mN", "spatula.force_mN", "zonules.strain" },
    }, own)
end

function crack_events.zonules(own)
    return with({
        when = "zonules.strain > 0.35",
        recovered = "zonules.strain < 0.22 and " .. both_free,
        recovered_hold_s = 0.5,
        deadline_s = 3,
        near_miss_s = 0,
        severity = "critical",
        cue = "The edge of the bag shows, the reflex becomes uneven.",
        advice = "The zonules carry the load: close the tips and take them off the lens. Part in the middle of the "
            .. "groove's width, not to one side and not down.",
        evidence = { "zonules.load_mN", "phaco.force_mN", "spatula.force_mN" },
    }, own)
end

function crack_events.struck(own)
    return with({
        when = "phaco.tip_posterior_mm < 0.3 or spatula.tip_posterior_mm < 0.3",
        recovered = "not (phaco.tip_posterior_mm < 1 or spatula.tip_posterior_mm < 1)",
        recovered_hold_s = 0.5,
        deadline_s = 2,
        near_miss_s = 0,
        harm = "capsule.strain_share > 0.9",
        severity = "critical",
        cue = "The floor gives way under a tip, folds run from it.",
        advice = "A tip is on the posterior capsule: lift it straight up, at once. Judge the floor by its reflex "
            .. "before you go down.",
        evidence = { "phaco.tip_posterior_mm", "spatula.tip_posterior_mm", "capsule.dimple_mm" },
    }, own)
end

function crack_events.torn(own)
    return with({
        when = "capsule.open",
        recovered = { "phaco.pedal >= 0.5 and phaco.pedal < 1.5 and not spatula.present", "not phaco.present" },
        deadline_s = 20,
        near_miss_s = 0,
        harm = "capsule.hole_mm2 > 7",
        severity = "critical",
        cue = "The chamber deepens suddenly, the pupil widens for a moment, a round clear edge shows.",
        advice = "The posterior capsule is torn: irrigation only, second instrument out, chamber full, then leave. "
            .. "Do not part any more.",
        evidence = { "capsule.hole_mm2", "capsule.peak_strain", "chamber.diaphragm_mm" },
    }, own)
end

function crack_events.iris(own)
    return with({
        when = "iris.touch and phaco.tip_depth_mm > -1.5",
        recovered = "iris.gap_mm > 0.1 and phaco.pedal < 1.5",
        recovered_hold_s = 0.5,
        deadline_s = 2,
        near_miss_s = 0,
        severity = "minor",
        cue = "The pupil's edge moves with the instrument.",
        advice = "Iris touched: stop, lift the tip to the middle of the pupil, and look at the shaft.",
        evidence = { "iris.gap_mm", "phaco.pedal" },
    }, own)
end

return crack_events
