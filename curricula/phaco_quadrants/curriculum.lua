-- SPDX-License-Identifier: GPL-3.0-or-later
-- A nucleus that is cut into quarters is taken out, quarter by quarter, with vacuum and pulsed ultrasound.

local phaco_events = require "phaco_events"

return exercise {
    title = "Removing the quarters",
    version = 1,
    summary = "A laser has cut the lens into quarters. Take them out one after the other: bury the tip in a quarter, "
        .. "let the vacuum build up and hold it, draw it to the middle of the pupil, and emulsify it there, away "
        .. "from the posterior capsule.",
    objectives = {
        "Let vacuum hold a piece, and draw it to a safe place before emulsifying",
        "Keep the chamber deep when an occlusion breaks",
        "Recognise a capsule that is held, and let go before pulling",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber" },
    instruments = { "phaco" },
    settings = {
        ["nucleus.segments"] = 4,
        ["nucleus.trench_mm"] = 1.5,
        ["machine.bottle_cm"] = 95,
        ["machine.flow_ml_min"] = 32,
        ["machine.vacuum_mmhg"] = 350,
        ["machine.tubing_mm3_mmhg"] = 0.3,
        ["phaco.pulse_hz"] = 20,
        ["phaco.duty"] = 0.6,
    },

    goals = {
        left_percent = { 25, from = 1, to = 95, meaning = "how much of the lens may stay, of its volume" },
    },
    -- what group d comes to on seeds 101 and 103 to 105 (72 to 108 s)
    reference = { time_s = 89, path_mm = 363, movements = 79, entries = 1, jerk_mm_s3 = 497 },

    steps = {
        step "approach" {
            title = "Enter the eye and come to the lens",
            hint = "Go in through the main incision with irrigation on (pedal 1): the chamber deepens. Bring the "
                .. "tip to the front of the lens.",
            done = "phaco.tip_depth_mm > -0.5",
            time_limit_s = 60,
        },
        step "quarters" {
            title = "Take out the quarters",
            hint = "Bury the tip with a touch of ultrasound, go back to pedal 2 and wait for the vacuum. Draw the "
                .. "piece to the middle and up, then pulse. When it clears, be at pedal 1 before the capsule comes.",
            picture_when = "fragments.left_share < 0.6",
            done = "100 * fragments.left_share < goal.left_percent",
            time_limit_s = 600,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Pedal 1, tip over the lens, and out through the wound with irrigation on.",
            done = "not phaco.present",
        },
    },

    errors = {
        error_event "Surge" (phaco_events.surge { items = { "T8", "T11", "G4" } }),
        error_event "Chamber collapse" (phaco_events.chamber_collapse { items = { "T8", "G3", "G4" } }),
        error_event "Capsule in the tip" (phaco_events.capsule_in_tip { items = { "T11", "G4" } }),
        error_event "Capsule torn" (phaco_events.capsule_torn(nil, { items = { "T11", "T12", "G4" } })),
        error_event "Iris in the tip" {
            when = "iris.captured",
            recovered = "not iris.captured",
            deadline_s = 1.5,
            near_miss_s = 0,
            harm = "iris.torn_mm > 0 or phaco.ultrasound",
            severity = "critical",
            cue = "The edge of the pupil runs into the tip.",
            advice = "Iris in the tip: let go of the pedal and wait until it slips off; do not pull.",
            items = { "G5", "G4" },
            evidence = { "iris.strain", "phaco.suction_mmhg", "phaco.pedal" },
        },
        error_event "Dropped piece" (phaco_events.dropped_piece { items = { "T11", "G4" } }),
        error_event "Wound burn" (phaco_events.wound_burn { items = { "T8", "T14", "G1" } }),
    },

    over = { "phaco.tip_depth_mm > -0.5", "not phaco.present" },
    time_limit_s = 600,

    scoring = osacss { "T7", "T8", "T11", "G3", "G4", "G5", "G6" },
}
