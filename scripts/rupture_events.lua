-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events of an open posterior capsule and of the vitreous behind it, for every exercise that simulates them.

local with = require "with_fields"

local rupture_events = {}

--- A hole with the hyaloid behind it whole. Put right: the tip stays in with nothing aspirated while viscoelastic is
--- laid over the hole, and leaves a full chamber; the hole is as it was.
function rupture_events.torn(own)
    return with({
        when = "capsule.open and not vitreous.hyaloid_broken and phaco.present",
        given = "capsule.open and not vitreous.hyaloid_broken",
        recovered = {
            "phaco.present and phaco.pedal < 1.5 and tamponade.cover > 0.95 and tamponade.fill > 0.35 "
                .. "and chamber.depth_share > 0.9",
            "not phaco.present and capsule.hole_growth <= 0.1 and not vitreous.hyaloid_broken",
        },
        deadline_s = 45,
        near_miss_s = 0,
        harm = "capsule.hole_growth > 0.1",
        severity = "critical",
        cue = "The chamber deepens suddenly, a round clear edge shows, pieces no longer come to the tip.",
        advice = "Stay in with the tip, aspirate nothing (pedal 0 or 1). Lay dispersive viscoelastic over the hole "
            .. "through the side port until the chamber is full, and only then come out. Bottle down, slowly.",
        evidence = { "capsule.hole_mm2", "capsule.hole_growth", "tamponade.cover", "tamponade.fill",
            "vitreous.drive_mmhg" },
    }, own)
end

--- Vitreous in the chamber or in the wound. Put right: cut away, and triamcinolone given afterwards shows none.
function rupture_events.vitreous(own)
    return with({
        when = "vitreous.front_mm3 > 1 or vitreous.wound_mm3 > 0.5",
        recovered = "vitreous.checked_ml > 0.01 and vitreous.front_mm3 < 0.5 and vitreous.wound_mm3 < 0.2",
        deadline_s = 120,
        near_miss_s = 0,
        harm = "vitreous.uncut_s > 2",
        severity = "critical",
        cue = "The pupil peaks towards the wound, pieces hang, white strands show after triamcinolone.",
        advice = "There is vitreous in the chamber: no more phaco. Cover the hole, make the vitreous white, and cut it "
            .. "away, cutting before you aspirate and fast; also what hangs in the wound. Look again with "
            .. "triamcinolone.",
        evidence = { "vitreous.front_mm3", "vitreous.wound_mm3", "vitreous.checked_ml", "capsule.hole_mm2" },
    }, own)
end

--- A mouth that sucks on vitreous without cutting it pulls on the retina.
function rupture_events.pulled(own)
    return with({
        when = "vitreous.held and vitreous.traction_mN > 0.5",
        hold_s = 0.1,
        recovered = "not vitreous.held",
        deadline_s = 2,
        near_miss_s = 0,
        harm = "vitreous.peak_traction_mN > 4",
        severity = "critical",
        cue = "Strands run to the tip, and the edge of the hole moves with it.",
        advice = "You suck on vitreous that is not cut: pedal up at once, and do not draw back. Cut first, then "
            .. "aspirate: pedal 2 cuts, pedal 3 aspirates as well.",
        evidence = { "vitreous.traction_mN", "vitreous.uncut_s", "vitreous.front_mm3" },
    }, own)
end

return rupture_events
