-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events of the wounds of the eye, for every exercise that simulates them.

local with = require "with_fields"

local wound_events = {}

-- Two clock hours from the wound that was left, which is tight as well.
local elsewhere = "wounds.old_angle_deg >= 59 and wounds.leak_at_20_ul_s < 0.05"

--- The tunnel is too short to close by itself. Put right: swollen or sutured until it is tight, or cut anew elsewhere.
function wound_events.short(own)
    return with({
        when = "wounds.main_cut and wounds.main_tunnel_mm < 1.25",
        hold_s = 0.1,
        recovered = "wounds.main_cut and wounds.leak_at_20_ul_s < 0.05 and (wounds.main_sutures > 0 "
            .. "or wounds.main_swelling > 0.2 or wounds.old_angle_deg >= 59 and wounds.main_tunnel_mm >= 1.25)",
        deadline_s = 120,
        near_miss_s = 0,
        harm = "wounds.main_leak_ul_s > 0.5",
        severity = "critical",
        cue = "The lip gapes, fluid comes at the wound, the chamber gets shallow.",
        advice = "The tunnel is too short. Hydrate it, then suture it, until it is tight; or close it and cut a new "
            .. "one two clock hours away.",
        evidence = { "wounds.main_tunnel_mm", "wounds.main_width_mm", "wounds.main_leak_at_20_ul_s" },
    }, own)
end

--- The tunnel is so long that instruments point at the cornea. Put right: a new one, two clock hours away.
function wound_events.long(own)
    return with({
        when = "wounds.main_cut and wounds.main_tunnel_mm > 2.75",
        hold_s = 0.1,
        recovered = "wounds.main_cut and wounds.main_tunnel_mm <= 2.75 and " .. elsewhere,
        deadline_s = 120,
        near_miss_s = 0,
        severity = "minor",
        cue = "Folds in the cornea over the tip, which is hard to lower.",
        advice = "The tunnel is too long: the tip will point at the cornea and fold it. Cut a new one two clock hours "
            .. "away, and leave this one shut.",
        evidence = { "wounds.main_tunnel_mm", "wounds.main_inner_lip_mm" },
    }, own)
end

--- The blade came out at the root of the iris. Put right: closed, and a new wound two clock hours away.
function wound_events.posterior(own)
    return with({
        when = "wounds.main_cut and wounds.main_inner_lip_mm < 0.5",
        hold_s = 0.05,
        recovered = "wounds.main_cut and wounds.main_inner_lip_mm >= 0.5 and " .. elsewhere,
        deadline_s = 120,
        near_miss_s = 0,
        harm = "wounds.touches > 0",
        severity = "critical",
        cue = "The iris lies at the inner lip at once.",
        advice = "You came in too far back. Out with the blade, do not push the iris; close this wound with a suture, "
            .. "and cut a new one two clock hours away.",
        evidence = { "wounds.main_inner_lip_mm", "wounds.touches", "wounds.leak_at_20_ul_s" },
    }, own)
end

--- Descemet's membrane hangs off at the inner lip. Put right: viscoelastic or air under the flap lays it flat.
function wound_events.descemet(own)
    return with({
        when = "wounds.main_peel_mm > 0.5 or wounds.side_peel_mm > 0.5",
        recovered = "wounds.main_peel_mm < 0.1 and wounds.side_peel_mm < 0.1",
        deadline_s = 60,
        near_miss_s = 0,
        harm = "wounds.main_most_peel_mm > 1",
        severity = "critical",
        cue = "A clear curled flap at the inner lip.",
        advice = "You push Descemet's membrane off. Draw back, come in again with the tip turned down, and lay the "
            .. "flap flat with viscoelastic under it.",
        evidence = { "wounds.main_peel_mm", "wounds.side_peel_mm", "wounds.main_most_peel_mm" },
    }, own)
end

--- A wound leaks: seen when it is tested, or with nothing in the eye. Put right: hydrated, then sutured, and tested
--- again.
function wound_events.leak(own)
    return with({
        when = "wounds.checked and wounds.tested_leak_ul_s > 0.05 "
            .. "or instruments.out_s > 0.5 and wounds.leak_at_20_ul_s > 0.05",
        recovered = "wounds.checked and wounds.tested_leak_ul_s <= 0.05 and wounds.leak_at_20_ul_s <= 0.05",
        deadline_s = 120,
        near_miss_s = 0,
        harm = "chamber.pressure_mmhg < 6",
        severity = "critical",
        cue = "Fluid comes at the lip, the eye gets soft and the chamber shallow.",
        advice = "The wound leaks. Hydrate its stroma on both sides; if it leaks still, suture it. Then press on the "
            .. "lip and look again.",
        evidence = { "wounds.leak_at_20_ul_s", "wounds.tested_leak_ul_s", "wounds.main_swelling", "wounds.main_sutures",
            "chamber.pressure_mmhg" },
    }, own)
end

--- Bleeding behind the choroid, which an instructor sets off (suprachoroidal.pressure_mmhg). Put right: everything out
--- and the wounds tight within 30 s, so that the pressure of the eye stops it.
function wound_events.bleeding(own)
    return with({
        when = "suprachoroidal.blood_mm3 > 3",
        recovered = "instruments.out_s > 0 and wounds.leak_ul_s < 0.05 and chamber.pressure_mmhg > 20",
        recovered_hold_s = 0.5,
        deadline_s = 30,
        near_miss_s = 0,
        harm = "chamber.depth_share < 0.6",
        severity = "critical",
        cue = "The eye hardens, the chamber gets shallow, the reflex darkens.",
        advice = "Bleeding behind the choroid: everything out, and close the wounds at once. The pressure of a closed "
            .. "eye stops it.",
        evidence = { "suprachoroidal.pressure_mmhg", "suprachoroidal.blood_mm3", "wounds.leak_ul_s",
            "chamber.pressure_mmhg", "chamber.depth_share" },
    }, own)
end

return wound_events
