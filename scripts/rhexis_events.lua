-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events of opening the anterior capsule, for the exercises that share them. An exercise names them, gives the
-- items that they cap, and may put another value in place of any field. They need the goals radius_mm and fill_percent.

local with = require "with_fields"

local rhexis_events = {}

--- The capsule is opened, or torn on, in a chamber that is not full.
function rhexis_events.underfilled(own)
    return with({
        when = "rhexis.opened and not rhexis.closed and 100 * viscoelastic.fill < goal.fill_percent - 15 "
            .. "and (cystotome.in_contact or forceps.in_contact)",
        hold_s = 0.3,
        recovered = "100 * viscoelastic.fill >= goal.fill_percent",
        deadline_s = 30,
        near_miss_s = 0,
        severity = "minor",
        cue = "The chamber is shallow, the lens comes forward, and the capsule is domed.",
        advice = "Fill the chamber before you go on: a domed capsule tears outwards.",
        evidence = { "viscoelastic.fill", "lens.lift_mm", "rhexis.tip_radius_mm" },
    }, own)
end

--- More viscoelastic than the eye bears.
function rhexis_events.overfilled(own)
    return with({
        when = "viscoelastic.pressure_mmhg > 60",
        recovered = "viscoelastic.pressure_mmhg < 30",
        deadline_s = 30,
        near_miss_s = 0,
        severity = "minor",
        cue = "The eye is hard, the iris bulges towards the wound.",
        advice = "Too much: stop pressing, and let some out through the wound before you go on.",
        evidence = { "viscoelastic.pressure_mmhg", "viscoelastic.fill", "cannula.press" },
    }, own)
end

--- Spokes about the needle before it is through: zonules that hold the capsule loosely let it wrinkle where they would
--- keep it taut (docs/tearing.md, "Wrinkles at the puncture"). Not where a shallow or overfilled chamber has moved the
--- lens: that draws wrinkles in any eye. Put right by saying so, before the nucleus is touched. An exercise with this
--- event has the request "Weak zonules declared".
function rhexis_events.wrinkles(own)
    return with({
        when = "not rhexis.opened and cystotome.wrinkled_share > 0.12 and lens.lift_mm > -0.3 and lens.lift_mm < 0.2 "
            .. "and not requested.weak_zonules_declared",
        recovered = "requested.weak_zonules_declared",
        deadline_s = 30,
        near_miss_s = 0,
        severity = "minor",
        cue = "Spokes run out from the needle, and the lens sinks before the capsule is pierced.",
        advice = "Wrinkles at the puncture tell of weak zonules: say so, and have hooks or a ring ready before the "
            .. "nucleus is touched.",
        evidence = { "cystotome.wrinkled_share", "cystotome.force_mN", "lens.lift_mm" },
    }, own)
end

--- The tear leaves the planned circle outwards. Put right when it has come back to it, or the opening is closed.
function rhexis_events.runs_out(own)
    return with({
        when = "not rhexis.closed and (rhexis.tip_radius_mm > goal.radius_mm + 0.75 "
            .. "or (rhexis.tip_heading_deg > 30 and rhexis.tip_radius_mm > goal.radius_mm + 0.45))",
        recovered = "not rhexis.run_out and (rhexis.closed or "
            .. "(rhexis.tip_radius_mm < goal.radius_mm + 0.45 and rhexis.tip_heading_deg < 20))",
        deadline_s = 60,
        near_miss_s = 0,
        harm = "rhexis.run_out",
        severity = "critical",
        cue = "The leading edge drifts outwards, and the flap hides where it hangs.",
        advice = "Stop. Fill the chamber, unfold the flap so that it lies flat, take hold of it close to the tear, "
            .. "pull back along the way it came, in the plane of the capsule, and then to the middle.",
        items = {},
        evidence = { "rhexis.tip_radius_mm", "rhexis.tip_heading_deg", "viscoelastic.fill", "forceps.force_mN" },
    }, own)
end

--- The tear has come to the zonules, and nothing undoes that. Put right when nobody pulls any more and the chamber is
--- full, so that it goes no farther, and then a new cut from the other end has met it: the flap is off.
function rhexis_events.edge_lost(own)
    return with({
        when = "rhexis.run_out",
        recovered = {
            "not forceps.holding and 100 * viscoelastic.fill >= goal.fill_percent",
            "rhexis.loose_mm2 > 5",
        },
        deadline_s = 60,
        near_miss_s = 0,
        severity = "critical",
        cue = "The end of the tear is gone behind the iris.",
        advice = "Do not pull on: let go and fill the chamber. Then begin again from the other end of the cut and lead "
            .. "the new tear into the old one, gently, without pressing fluid under the edge.",
        evidence = { "rhexis.largest_radius_mm", "rhexis.torn_mm", "viscoelastic.fill" },
    }, own)
end

-- The opening that is planned is 2 goal.radius_mm wide. With the usual 5.24 mm the limits are where T5 of the rubric
-- has three points: 4.5 and 6.0 mm, and 0.5 mm beside the middle.
local too_narrow = "not rhexis.run_out and rhexis.diameter_mm < 2 * goal.radius_mm - 0.74"
local too_wide = "not rhexis.run_out and rhexis.diameter_mm > 2 * goal.radius_mm + 0.76"

local shape = { "rhexis.diameter_mm", "rhexis.centre_offset_mm", "rhexis.circularity", "rhexis.overlap_deg" }

--- The flap is off and the opening too narrow. Put right by a second cut from its rim that goes round in a spiral.
function rhexis_events.too_small(own)
    return with({
        when = too_narrow,
        recovered = "rhexis.diameter_mm >= 2 * goal.radius_mm - 0.5 and not rhexis.run_out",
        deadline_s = 60,
        near_miss_s = 0,
        severity = "minor",
        cue = "Beside the pupil and the marks on the forceps the opening is narrow.",
        advice = "A narrow rim splits under the tip or the implant. Cut from the rim outwards, take hold of the new "
            .. "flap, and lead it round in a spiral to the planned circle.",
        evidence = shape,
    }, own)
end

--- The flap is off and the opening too wide: nothing makes it narrower. Put right by having it recorded, so that lens
--- and place of the optic are chosen by it. An exercise with this event has the request "Opening recorded".
function rhexis_events.too_large(own)
    return with({
        when = too_wide,
        recovered = "requested.opening_recorded",
        deadline_s = 60,
        near_miss_s = 0,
        severity = "minor",
        cue = "The rim is close to the edge of the pupil, and will not lie before the optic.",
        advice = "Have it recorded: the rim does not hold the optic all round. Choose the lens and where its optic "
            .. "goes by that.",
        evidence = shape,
    }, own)
end

--- The flap is off and the opening beside the middle. Put right by a second cut on its near side, or by having it
--- recorded where that would make it too wide.
function rhexis_events.off_centre(own)
    return with({
        when = "not rhexis.run_out and rhexis.centre_offset_mm > 0.5",
        recovered = "rhexis.centre_offset_mm <= 0.5 and not rhexis.run_out or requested.opening_recorded",
        deadline_s = 60,
        near_miss_s = 0,
        severity = "minor",
        cue = "The rim is nearer to the pupil's edge on one side than on the other.",
        advice = "Where the rim is near the middle, cut it outwards and lead a second flap along the planned circle. "
            .. "Where that would make the opening too wide, have it recorded and place the optic by it.",
        evidence = shape,
    }, own)
end

--- The needle ploughs the cortex under the capsule.
function rhexis_events.too_deep(own)
    return with({
        when = "cystotome.tip_depth_mm > 1.0",
        hold_s = 0.2,
        recovered = "not (cystotome.tip_depth_mm > 0.6)",
        deadline_s = 3,
        near_miss_s = 0,
        severity = "minor",
        cue = "White shreds of cortex rise around the needle.",
        advice = "Too deep: lift the needle until only its point is under the capsule.",
        evidence = { "cystotome.tip_depth_mm", "cystotome.force_mN" },
    }, own)
end

function rhexis_events.iris_touched(own)
    return with({
        when = "iris.touch",
        recovered = "iris.gap_mm > 0.1",
        recovered_hold_s = 0.3,
        deadline_s = 2,
        near_miss_s = 0,
        severity = "minor",
        cue = "The pupil's edge moves with the instrument.",
        advice = "Iris touched: stop, bring the instrument back to the middle of the pupil, and look at the shaft.",
        evidence = { "iris.gap_mm" },
    }, own)
end

return rhexis_events
