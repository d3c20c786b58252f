-- SPDX-License-Identifier: GPL-3.0-or-later
-- An occlusion breaks: the surge, what puts it right and by when, and what the educator lets follow.
return exercise {
    title = "When the occlusion breaks",
    objectives = {
        "Know a surge by the chamber that goes flat",
        "Foot up to irrigation at once",
        "Then: bottle up, vacuum down",
    },

    patient = { age = 72, cataract = "NO4", pupil_mm = 7, tetrahedra = 500 },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber" },
    instruments = { "phaco" },
    settings = { machine = { bottle_cm = 60, vacuum_mmhg = 550, flow_ml_min = 40, tubing_mm3_mmhg = 0.6 } },

    requests = {
        request "Bottle up" { settings = { ["machine.bottle_cm"] = 110 },
            meaning = "bottle at 110 cm", answer = "At 110." },
        request "Vacuum down" { settings = { ["machine.vacuum_mmhg"] = 200 },
            meaning = "200 mmHg", answer = "200." },
    },
    goals = { flat_share = { 0.3, from = 0.1, to = 0.6, meaning = "share of the depth lost within a second" } },

    steps = {
        step "occlude" {
            title = "Occlude the tip",
            hint = "Tip into the nucleus, pedal 2, until the vacuum stands.",
            done = "phaco.occlusion > 0.8 and panel.vacuum_mmhg > 400",
            time_limit_s = 30,
        },
        step "hold the chamber" {
            title = "Hold the chamber when it breaks",
            hint = "Pedal back to 1 as the piece comes free.",
            done = { "phaco.occlusion < 0.3", "not phaco.aspirating", "chamber.depth_share > 1.1" },
            time_limit_s = 30,
        },
        step "leave" {
            title = "Make it safe and leave",
            hint = "Bottle up, vacuum down, then out with irrigation on.",
            done = "not phaco.present",
            time_limit_s = 20,
        },
    },

    errors = {
        error_event "Surge" {
            when = "chamber.depth_lost_share > goal.flat_share",
            recovered = "chamber.depth_share > 0.9 and not phaco.aspirating",
            recovered_hold_s = 0.3,
            deadline_s = 3,
            quiet_s = 2,
            harm = "capsule.open",
            cue = "The chamber shallows, the pupil comes forward.",
            advice = "Foot up to position 1. Wait for the chamber. Then bottle up, vacuum down.",
            consequences = { "The nurse turns the vacuum down.", ["machine.vacuum_mmhg"] = 250 },
            items = { "T8", "G6" },
            evidence = { "chamber.lowest_pressure_mmhg", "panel.vacuum_mmhg" },
        },
        error_event "Capsule caught" {
            when = "capsule.captured",
            recovered = "not capsule.captured",
            deadline_s = 2,
            advice = "Foot up; do not pull. Let reflux or time free it.",
            items = { "T8" },
        },
    },
    scoring = osacss { "T8", "G4", "G6" },
    time_limit_s = 100,
}
