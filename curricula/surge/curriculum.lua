-- SPDX-License-Identifier: GPL-3.0-or-later
-- A piece on the tip, much vacuum, soft tubing and a low bottle: let go of it without losing the chamber.

local phaco_events = require "phaco_events"

return exercise {
    title = "Surge when an occlusion breaks",
    version = 1,
    summary = "The nucleus lies in quarters. Vacuum is high, the tubing soft, the bottle not high enough: what the "
        .. "tubing has stored comes out of the eye as soon as the piece clears. Take a piece onto the tip, let the "
        .. "vacuum build up, and let go of it with the chamber deep.",
    objectives = {
        "Know by the panel that the tip is shut, and what will follow when it opens",
        "Ease the pedal to 1 before the piece clears, or within half a second after it",
        "See a chamber that empties, and fill it before anything else",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber" },
    instruments = { "phaco" },
    settings = {
        ["nucleus.segments"] = 4,
        ["nucleus.trench_mm"] = 1.5,
        ["machine.bottle_cm"] = 65,
        ["machine.flow_ml_min"] = 32,
        ["machine.vacuum_mmhg"] = 350,
        ["machine.tubing_mm3_mmhg"] = 0.8,
        ["phaco.pulse_hz"] = 20,
        ["phaco.duty"] = 0.6,
    },

    goals = {
        vacuum_mmhg = { 180, from = 50, to = 400, meaning = "vacuum that must build up before the piece is let go" },
    },
    reference = { time_s = 20, path_mm = 53, movements = 7, entries = 1, jerk_mm_s3 = 490 },

    steps = {
        step "approach" {
            title = "Enter the eye and come to the lens",
            hint = "In through the main incision with irrigation on (pedal 1): the chamber deepens.",
            done = "phaco.tip_depth_mm > -0.5 and chamber.depth_share > 0.95",
            time_limit_s = 60,
        },
        step "occlude" {
            title = "Take a piece onto the tip",
            hint = "From the trench into the far right quarter with a touch of ultrasound, then pedal 2. Wait until "
                .. "the vacuum on the panel has built up.",
            done = "phaco.occlusion > 0.9 and panel.vacuum_mmhg > goal.vacuum_mmhg",
            time_limit_s = 90,
        },
        step "let go" {
            title = "Let it go with the chamber deep",
            hint = "Pedal to 1, and wait until the panel shows that the vacuum is gone. Only then away from the piece.",
            done = "phaco.pedal < 1.5 and panel.vacuum_mmhg < 20 and chamber.depth_share > 0.9",
            time_limit_s = 60,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Pedal 1, tip over the lens, and out through the wound.",
            done = "not phaco.present",
        },
    },

    errors = {
        error_event "Surge" (phaco_events.surge { items = { "T8", "T11", "G4" } }),
        error_event "Chamber collapse" (phaco_events.chamber_collapse { items = { "T8", "G3", "G4" } }),
        error_event "Capsule in the tip" (phaco_events.capsule_in_tip { items = { "T11", "G4" } }),
    },

    over = { "phaco.tip_depth_mm > -0.5", "not phaco.present" },
    time_limit_s = 240,

    scoring = osacss { "T8", "T11", "G3", "G4", "G5", "G6" },
}
