-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events that belong to the machine, the chamber and the posterior capsule rather than to one exercise. An
-- exercise names them, gives the items that they cap, and may put another value in place of any field:
--
--   local phaco_events = require "phaco_events"
--   errors = { error_event "Chamber collapse" (phaco_events.chamber_collapse { items = { "T8", "G3", "G4" } }) }

local with = require "with_fields"

local phaco_events = {}

--- The chamber runs empty: more leaves it than the bottle gives.
function phaco_events.chamber_collapse(own)
    return with({
        when = "chamber.depth_share < 0.4 and phaco.present",
        recovered = "chamber.depth_share > 0.9",
        deadline_s = 4,
        near_miss_s = 0,
        severity = "critical",
        cue = "Iris and capsule rush forward, the cornea folds.",
        advice = "The chamber is empty: pedal to 1, bottle up, and look whether the tubing or the wound leaks.",
        evidence = { "chamber.pressure_mmhg", "chamber.infusion_ml_min", "phaco.pedal" },
    }, own)
end

--- Fluid that the tubing stored as vacuum is filled from the eye when an occlusion breaks.
function phaco_events.surge(own)
    return with({
        when = "chamber.depth_lost_share > 0.3",
        recovered = "phaco.pedal < 1.5 and chamber.depth_share > 0.9",
        deadline_s = 2,
        near_miss_s = 0,
        severity = "critical",
        cue = "The iris and the capsule bounce as the piece clears.",
        advice = "Surge: pedal to 1 at once and let the chamber fill. Less vacuum, or a higher bottle, before you "
            .. "go on.",
        evidence = { "chamber.depth_share", "chamber.lowest_pressure_mmhg", "panel.vacuum_mmhg", "phaco.pedal" },
    }, own)
end

--- The posterior capsule is sucked onto the mouth of the tip.
function phaco_events.capsule_in_tip(own)
    return with({
        when = "capsule.captured",
        recovered = "not capsule.captured and not capsule.open",
        deadline_s = 1.5,
        near_miss_s = 0,
        harm = "capsule.strain_share > 0.9",
        severity = "critical",
        cue = "Folds run like a star to the tip.",
        advice = "The capsule is in the tip: let go of the pedal, and do not pull away while it is held.",
        evidence = { "capsule.strain_share", "phaco.suction_mmhg", "phaco.pedal" },
    }, own)
end

--- Ultrasound is off, and something flows. Into a full chamber flows no more than what leaks at the wound.
phaco_events.flows_again = "not phaco.ultrasound and (chamber.infusion_ml_min > 5 "
    .. "or (chamber.infusion_ml_min > 1 and chamber.depth_share > 1))"

--- Ultrasound without the flow that cools the tip. For hold_s the flow may be low: so long it takes to follow the pedal
--- and to come back after tissue has shut the mouth for a moment.
function phaco_events.infusion_off(own)
    return with({
        when = "phaco.ultrasound and chamber.infusion_ml_min < 5",
        hold_s = 0.3,
        recovered = phaco_events.flows_again,
        deadline_s = 3,
        near_miss_s = 0,
        severity = "critical",
        cue = "Nothing flows through the bottle's drip chamber, and the chamber does not deepen.",
        advice = "Ultrasound without flow heats the wound: let go of ultrasound at once, open the infusion, and see "
            .. "that it flows before you go on.",
        evidence = { "chamber.infusion_ml_min", "panel.flow_ml_min", "phaco.occlusion", "phaco.power" },
    }, own)
end

--- The needle that rubs in its sleeve without flow burns the wound. Its shrunken lips do not close again: what can be
--- put right is that it goes on.
function phaco_events.wound_burn(own)
    return with({
        when = "wound.burn_share > 0",
        recovered = "not phaco.ultrasound and wound.temperature_c < 45",
        deadline_s = 3,
        near_miss_s = 0,
        harm = "wound.burn_share > 0.5",
        severity = "critical",
        cue = "The edge of the wound turns white, milky fluid stands at the tip.",
        advice = "The wound burns: ultrasound off at once, and let cool fluid through: infusion open, tip free. Look "
            .. "why nothing flowed before you go on, and close the wound with a suture in the end.",
        evidence = { "wound.temperature_c", "chamber.infusion_ml_min", "phaco.power", "phaco.occlusion" },
    }, own)
end

--- The posterior capsule tears: irrigation only until the chamber is deep, then out. ready: what must hold besides
--- before the tip leaves, or nil.
function phaco_events.capsule_torn(ready, own)
    local safe = "phaco.pedal >= 0.5 and phaco.pedal < 1.5 and chamber.depth_share > 0.9"
    return with({
        when = "capsule.open",
        recovered = { ready and ("%s and %s"):format(safe, ready) or safe, "not phaco.present" },
        deadline_s = 20,
        near_miss_s = 0,
        harm = "capsule.hole_mm2 > 7",
        severity = "critical",
        cue = "The chamber deepens suddenly, the pupil widens for a moment, a round clear edge shows.",
        advice = "The posterior capsule is torn: stay in with irrigation only, no vacuum, no ultrasound; fill the "
            .. "chamber, then leave. Do not chase what sinks.",
        evidence = { "capsule.hole_mm2", "chamber.diaphragm_mm", "fragments.sunk_mm" },
    }, own)
end

--- A piece falls behind the posterior capsule. Not chased: no aspiration, the tip away from the depth.
function phaco_events.dropped_piece(own)
    return with({
        when = "fragments.sunk_mm > 2",
        given = "fragments.sunk_mm > 2",
        recovered = "phaco.pedal < 1.5 and phaco.tip_posterior_mm > 1",
        deadline_s = 5,
        near_miss_s = 0,
        severity = "critical",
        cue = "A piece grows dim and small, and tumbles away behind the capsule.",
        advice = "The piece is in the vitreous: do not chase it. Irrigation only, tip up and out of the depth; "
            .. "it is taken out from behind, later.",
        evidence = { "fragments.sunk_mm", "capsule.hole_mm2", "phaco.pedal", "phaco.tip_posterior_mm" },
    }, own)
end

return phaco_events
