-- SPDX-License-Identifier: GPL-3.0-or-later
-- Iris in a wound that is short and lies far back: let the pressure out through the side port, and stroke it home.

local globe_events = require "globe_events"

return exercise {
    title = "Iris prolapse",
    version = 1,
    summary = "The main wound was cut too short and comes out too near to the iris. When the tip left under pressure, "
        .. "the iris came after it. Pushed back, it comes again, and worse. Let the pressure out through the side "
        .. "port, and stroke over the lip of the wound.",
    objectives = {
        "Know a prolapse by the pupil that peaks towards the wound, and push nothing back",
        "Lower the pressure through the side port by pressing on its lip",
        "Stroke over the outer lip until the iris has slipped back",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 6 },
    tissues = { "iris", "cornea", "chamber", "wounds", "globe" },
    instruments = { "phaco", "spatula" },
    settings = {
        ["machine.bottle_cm"] = 80,
        ["machine.flow_ml_min"] = 25,
        ["wounds.main_tunnel_mm"] = 1.0,
        ["wounds.main_inner_lip_mm"] = 0.5,
    },

    goals = {
        pressure_mmhg = { 10, from = 2, to = 20, meaning = "pressure to which the eye must be let down" },
    },
    -- proposal: what group d comes near to
    reference = { time_s = 30, path_mm = 60, movements = 12, entries = 1, jerk_mm_s3 = 500 },

    steps = {
        step "let down" {
            title = "Let the pressure out",
            hint = "Spatula into the side port, just through it. Press its lip aside until fluid runs out and the eye "
                .. "is soft. Leave the iris alone.",
            done = "chamber.pressure_mmhg < goal.pressure_mmhg",
            time_limit_s = 60,
        },
        step "stroke" {
            title = "Stroke the iris home",
            hint = "Out of the side port. Stroke over the outer lip of the main wound, to and fro, without going in.",
            done = "iris.prolapse_mm < 0.2",
            time_limit_s = 60,
        },
        step "leave it" {
            title = "See that it stays",
            script = function(_, act)
                act.wait_until("iris.prolapse_mm < 0.2 and not phaco.present and not spatula.present")
                act.wait(1.5)
            end,
            hint = "Instruments away. The pupil is round again.",
            time_limit_s = 30,
        },
    },

    errors = {
        error_event "Iris prolapse" (globe_events.iris_prolapse { items = { "G5", "T2", "T14" } }),
        error_event "Eye rolled" (globe_events.eye_rolled { items = { "G1" } }),
    },

    time_limit_s = 200,

    scoring = osacss { "G1", "G3", "G4", "G5", "G6" },
}
