-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events of zonules that are weak or lost, for every exercise that simulates that they break.

local rupture_events = require "rupture_events"
local with = require "with_fields"

local zonule_events = {}

--- Zonules tear over a clock hour or more. Put right: bottle down, viscoelastic over the gap, and hooks, or a ring
--- where the gap is narrow enough for one, until no wide arc is without hold.
function zonule_events.dialysis(own)
    return with({
        when = "zonules.torn_deg >= 30 and zonules.gap_deg >= 30",
        recovered = {
            "chamber.pressure_mmhg < 40 and tamponade.gap_cover > 0.9",
            "zonules.unsupported_deg <= 45 and tamponade.gap_cover > 0.9 and not phaco.aspirating",
        },
        deadline_s = 12,
        near_miss_s = 0,
        harm = "zonules.torn_deg > 90 or vitreous.front_mm3 > 1",
        severity = "critical",
        cue = "The edge of the bag shows, the lens tilts and wobbles, a bright crescent stands beside it.",
        advice = "Zonules tear: stop, pedal to 1, bottle and flow down. Lay viscoelastic over the gap, and hold the "
            .. "edge of the opening there with hooks. A ring does for a gap of up to four clock hours, not for more.",
        evidence = { "zonules.torn_deg", "zonules.gap_deg", "zonules.unsupported_deg", "bag.tilt_deg", "bag.offset_mm",
            "tamponade.gap_cover", "chamber.pressure_mmhg" },
    }, own)
end

--- Ultrasound at a bag of which a wide arc has no hold.
function zonule_events.unsupported(own)
    return with({
        when = "phaco.ultrasound and zonules.unsupported_deg > 45",
        recovered = "not phaco.ultrasound and zonules.unsupported_deg <= 45",
        deadline_s = 8,
        near_miss_s = 0,
        severity = "minor",
        cue = "The lens lies aside, and moves as a whole when the tip works on it.",
        advice = "A wide arc of the bag has no hold: support it with hooks or a ring before you go on.",
        evidence = { "zonules.unsupported_deg", "zonules.hooks", "zonules.ring" },
    }, own)
end

--- Vitreous that came through a gap while the chamber was lower than what lies behind it. Put right as behind a torn
--- capsule: cut away, and triamcinolone given afterwards shows none.
function zonule_events.vitreous(own)
    return with(rupture_events.vitreous({
        deadline_s = 45,
        cue = "The chamber fell, the pupil peaks towards the wound, strands beside the edge of the bag.",
        advice = "Vitreous came through the gap: no phaco, bottle down. Cut it away before the gap and in the wound, "
            .. "cutting before you aspirate, cover the gap before you come out, and look again with triamcinolone.",
        evidence = { "vitreous.front_mm3", "vitreous.wound_mm3", "vitreous.checked_ml", "zonules.gap_deg",
            "tamponade.gap_cover", "chamber.lowest_pressure_mmhg" },
    }), own)
end

return zonule_events
