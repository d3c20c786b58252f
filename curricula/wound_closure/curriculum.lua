-- SPDX-License-Identifier: GPL-3.0-or-later
-- The end of the operation: wounds that are swollen shut or sewn, an eye of the right pressure, and a test of it.

local wound_events = require "wound_events"

return exercise {
    title = "Closing the wounds",
    version = 1,
    summary = "The implant is in. Swell the lips of the wound with saline, bring the eye to 15 to 25 mmHg, then press "
        .. "on the lip with a sponge and look whether anything comes. If it does: hydrate, then suture, then test "
        .. "again.",
    objectives = {
        "Hydrate the stroma until it is white",
        "Leave an eye of 15 to 25 mmHg",
        "Test every wound, and suture the one that leaks",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 6 },
    tissues = { "iris", "cornea", "chamber", "wounds" },
    instruments = { "hydration_cannula", "sponge", "needle_holder", "cannula" },
    settings = { ["implant.in_place"] = 1, ["wounds.main_tunnel_mm"] = 1.8, ["wounds.main_width_mm"] = 2.5 },

    levels = {
        short = { meaning = "a short tunnel, which leaks",
            settings = { ["wounds.main_tunnel_mm"] = 1.1, ["wounds.main_width_mm"] = 2.6 } },
        burnt = { meaning = "a burnt wound, which only stitches close", settings = { ["wounds.main_burn"] = 0.8 } },
        flap = { meaning = "Descemet's membrane hangs off at the inner lip",
            settings = { ["wounds.main_peel_mm"] = 0.9 } },
    },

    goals = {
        least_mmhg = { 15, from = 8, to = 20, meaning = "pressure that the eye must have at least" },
        most_mmhg = { 25, from = 20, to = 40, meaning = "and at most" },
    },
    -- proposal: what group d comes near to
    reference = { time_s = 30, path_mm = 40, movements = 12, entries = 2, jerk_mm_s3 = 300 },

    steps = {
        step "hydrate" {
            title = "Hydrate",
            hint = "The end of the cannula into the stroma beside the tunnel; press until it is white.",
            done = "wounds.main_swelling > 0.4 or wounds.main_sutures > 0",
            time_limit_s = 60,
        },
        step "fill" {
            title = "Pressure",
            hint = "The end into the chamber; fill it until it feels firm, 15 to 25 mmHg.",
            done = "chamber.pressure_mmhg >= goal.least_mmhg and chamber.pressure_mmhg <= goal.most_mmhg "
                .. "and not hydration_cannula.present",
            time_limit_s = 60,
        },
        step "test" {
            title = "Test",
            hint = "Press on the outer lip with the sponge. Nothing may come. If it does: hydrate, suture, test again.",
            picture_when = "wounds.press_mN > 100",
            done = "wounds.checked and wounds.tested_leak_ul_s <= 0.05 and wounds.leak_at_20_ul_s <= 0.05 "
                .. "and not sponge.present",
            time_limit_s = 180,
        },
    },

    errors = {
        error_event "Leak" (wound_events.leak { items = { "T14" } }),
        error_event "Descemet's membrane peeled" (wound_events.descemet { items = { "T14", "G3" } }),
        error_event "Suprachoroidal bleeding" (wound_events.bleeding { items = { "G6", "T14" } }),
    },

    time_limit_s = 300,

    scoring = osacss { "T14", "G3", "G5", "G6" },
}
