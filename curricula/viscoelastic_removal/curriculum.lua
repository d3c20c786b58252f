-- SPDX-License-Identifier: GPL-3.0-or-later
-- The implant lies in the bag; viscoelastic is left before it, behind it, and in the angle of the chamber.

local bag_events = require "bag_events"

return exercise {
    title = "Removal of viscoelastic",
    version = 1,
    summary = "The implant lies in the bag amid viscoelastic. What is in front comes to the tip and is washed out; "
        .. "what lies behind the optic stays unless the tip goes there or rocks the optic. What is left raises the "
        .. "pressure in the days after.",
    objectives = {
        "Aspirate in front of the implant and round the angle",
        "Aspirate behind the optic, or rock it, until it lies still",
        "Keep the posterior capsule out of the mouth",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "bag", "capsule", "iris", "cornea", "globe", "chamber", "retained_viscoelastic" },
    instruments = { "ia_tip" },
    settings = {
        ["machine.bottle_cm"] = 75,
        ["ia.vacuum_mmhg"] = 400,
        ["ia.flow_ml_min"] = 30,
    },

    goals = {
        left_percent = { 5, from = 1, to = 50, meaning = "how much viscoelastic may stay" },
    },
    reference = { time_s = 45, path_mm = 60, movements = 12, entries = 1, jerk_mm_s3 = 500 },  -- proposal

    steps = {
        step "front" {
            title = "In front of the implant",
            hint = "Tip over the optic, mouth up, pedal 2.",
            done = "ia_tip.present and viscoelastic.front_mm3 < 15",
            time_limit_s = 90,
        },
        step "behind" {
            title = "Behind the implant",
            hint = "Past the edge of the optic, the mouth up, and aspirate there; or press its edge to rock "
                .. "it.",
            picture_when = "viscoelastic.under_optic",
            done = "viscoelastic.left_percent <= goal.left_percent",
            time_limit_s = 120,
        },
        step "withdraw" {
            title = "Come out",
            hint = "Straight out through the incision, irrigation on.",
            done = "not ia_tip.present",
            time_limit_s = 30,
        },
    },

    errors = {
        error_event "Viscoelastic left behind the implant" (bag_events.viscoelastic_left { items = { "T12", "T14" } }),
        error_event "Posterior capsule drawn in" (bag_events.captured { items = { "T12", "G4" } }),
    },

    time_limit_s = 240,

    scoring = osacss { "T12", "T14", "G1", "G3", "G4", "G5", "G6" },
}
