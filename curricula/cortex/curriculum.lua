-- SPDX-License-Identifier: GPL-3.0-or-later
-- The lens is out; cortex hangs all round on the inner wall of the bag. It is stripped and aspirated.

local bag_events = require "bag_events"

return exercise {
    title = "Irrigation and aspiration of cortex",
    version = 1,
    summary = "The nucleus has left the bag, and cortex hangs in grey-white tags all round, from fornix to back. "
        .. "The tip holds a tag in the fornix, draws it towards the middle so that it comes off the capsule, and "
        .. "aspirates it there. A mouth that looks down takes the posterior capsule instead.",
    objectives = {
        "Hold cortex in the fornix with the mouth up, and strip it along the capsule",
        "Go all round until next to none is left",
        "Let go of a posterior capsule that was drawn in, before it tears",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 8.5 },
    tissues = { "bag", "capsule", "iris", "cornea", "globe", "chamber", "cortex" },
    instruments = { "ia_tip" },
    settings = {
        ["machine.bottle_cm"] = 75,
        ["ia.vacuum_mmhg"] = 400,
        ["ia.flow_ml_min"] = 30,
    },

    goals = {
        left_percent = { 2, from = 0, to = 50, meaning = "how much of the bag may keep cortex" },
    },
    -- proposal: what group d comes near to on seeds 101 to 104
    reference = { time_s = 53, path_mm = 215, movements = 39, entries = 1, jerk_mm_s3 = 590 },

    steps = {
        step "enter" {
            title = "Go in",
            hint = "Irrigation on (pedal 1), the mouth up, and through the incision to the middle of the bag.",
            done = "ia_tip.present and ia_tip.irrigating and cortex.left_percent >= 0",
            time_limit_s = 30,
        },
        step "strip" {
            title = "Strip and aspirate",
            hint = "Under the rim to the fornix, pedal 2, and when the tag is held, draw it to the middle. Go round.",
            picture_when = "cortex.held and cortex.left_percent < 60",
            done = "cortex.left_percent <= goal.left_percent",
            time_limit_s = 240,
        },
        step "withdraw" {
            title = "Come out",
            hint = "Straight out through the incision, irrigation on.",
            done = "not ia_tip.present",
            time_limit_s = 30,
        },
    },

    errors = {
        error_event "Posterior capsule drawn in" (bag_events.captured { items = { "T12", "G4" } }),
        error_event "Cortex left" (bag_events.cortex_left { items = { "T12" } }),
    },

    time_limit_s = 300,

    scoring = osacss { "T12", "G1", "G3", "G4", "G5", "G6" },
}
