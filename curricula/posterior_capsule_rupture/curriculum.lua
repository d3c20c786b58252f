-- SPDX-License-Identifier: GPL-3.0-or-later
-- A hole in the posterior capsule, found while the tip is in the eye. Hold the vitreous back, or take out what came.

local rupture_events = require "rupture_events"

return exercise {
    title = "The posterior capsule is torn",
    version = 1,
    summary = "The lens is out, and a round clear edge shows in the reflex: a hole in the posterior capsule. Whatever "
        .. "lets the pressure fall now makes the hole larger and lets the vitreous come. Keep the chamber up, lay "
        .. "viscoelastic over the hole, and only then come out. What has come forward all the same is made white, and "
        .. "cut away.",
    objectives = {
        "Leave the tip in when the capsule tears, and aspirate nothing",
        "Cover the hole with viscoelastic through the side port before the tip leaves",
        "Take vitreous out of the chamber by cutting it before it is sucked in, and see that none is left",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7 },
    tissues = { "bag", "capsule", "iris", "cornea", "chamber", "vitreous" },
    instruments = { "phaco", "cannula", "cutter", "triamcinolone" },
    settings = {
        ["capsule.hole_mm"] = 1.4,
        ["capsule.hole_x_mm"] = 0.6,
        ["capsule.hole_y_mm"] = 0.8,
        ["machine.bottle_cm"] = 65,
        ["machine.flow_ml_min"] = 25,
        ["machine.vacuum_mmhg"] = 250,
    },
    levels = {
        vitreous = { meaning = "the hyaloid is broken too: vitreous is in the chamber and in the wound",
            settings = { ["vitreous.hyaloid"] = 0, ["vitreous.front_mm3"] = 6, ["vitreous.wound_mm3"] = 1 } },
    },

    goals = {
        fill_percent = { 40, from = 35, to = 95, meaning = "how full of viscoelastic the chamber must be" },
        front_mm3 = { 0.5, from = 0.1, to = 20, meaning = "how much vitreous may stay in the chamber" },
    },
    -- proposal: what group d comes near to
    reference = { time_s = 60, path_mm = 150, movements = 12, entries = 3, jerk_mm_s3 = 495 },

    requests = {
        request "Bottle down" {
            meaning = "the bottle is lowered to 50 cm above the eye",
            settings = { ["machine.bottle_cm"] = 50 },
            answer = "Bottle at 50.",
        },
    },

    steps = {
        step "hold" {
            title = "Keep the chamber up",
            hint = "Tip in with irrigation on (pedal 1), as it was when you saw the edge. No aspiration, no movement "
                .. "towards the hole.",
            done = "phaco.present and phaco.irrigating and chamber.depth_share > 0.95",
            time_limit_s = 60,
        },
        step "cover" {
            title = "Viscoelastic over the hole",
            hint = "Cannula through the side port, its end before the hole. Press until the hole is covered and the "
                .. "chamber is full of viscoelastic.",
            done = "tamponade.cover > 0.95 and 100 * tamponade.fill > goal.fill_percent",
            time_limit_s = 90,
        },
        step "withdraw" {
            title = "Come out",
            hint = "Now the tip may leave: the chamber stays as it is.",
            done = "not phaco.present and not cannula.present",
            time_limit_s = 60,
        },
        step "look" {
            title = "Is there vitreous?",
            hint = "Triamcinolone through the side port. If white strands show, cover the hole again and cut: pedal 2 "
                .. "cuts, pedal 3 cuts and aspirates. Then look once more.",
            done = "vitreous.checked_ml > 0.01 and vitreous.front_mm3 < goal.front_mm3 and vitreous.wound_mm3 < 0.2 "
                .. "and not cutter.present and not triamcinolone.present",
            time_limit_s = 240,
        },
    },

    errors = {
        error_event "Capsule torn, hyaloid intact" (rupture_events.torn { items = { "T11", "G4" } }),
        error_event "Vitreous" (rupture_events.vitreous { items = { "T11", "G4" } }),
        error_event "Vitreous pulled" (rupture_events.pulled { items = { "T11", "G4" } }),
    },

    time_limit_s = 300,

    scoring = osacss { "T8", "T11", "G3", "G4", "G5", "G6" },
}
