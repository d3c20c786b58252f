-- SPDX-License-Identifier: GPL-3.0-or-later
-- A plug in the tip: ultrasound would burn the wound. Find out before it does, have the tip cleared, and go on.

local phaco_events = require "phaco_events"
local globe_events = require "globe_events"

return exercise {
    title = "Ultrasound without flow",
    version = 1,
    summary = "Viscoelastic has set in the tip, and the wound lies tight around the sleeve: nothing flows, and what "
        .. "does not flow does not cool. Find it out before ultrasound burns the wound, come out, have the tip "
        .. "cleared, and go on.",
    objectives = {
        "Try the flow in pedal position 2 before every first ultrasound",
        "Know a blocked tip by the panel and by the milky cloud, and let go of ultrasound at once",
        "Have the tip cleared outside of the eye, and see that it flows before going on",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber", "globe" },
    instruments = { "phaco" },
    settings = {
        ["machine.bottle_cm"] = 75,
        ["machine.flow_ml_min"] = 0,
        ["machine.vacuum_mmhg"] = 80,
        ["wound.leak_ml_min"] = 0.8,
        ["phaco.power_limit"] = 0.8,
    },

    levels = {
        kinked = { meaning = "the line of the infusion is kinked instead",
            settings = { ["machine.flow_ml_min"] = 25, ["machine.infusion"] = 0 } },
    },

    goals = {
        removed_mg = { 1.5, from = 0.2, to = 50, meaning = "how much of the lens must be taken once it flows" },
    },
    -- proposal: what group d comes near to
    reference = { time_s = 35, path_mm = 90, movements = 14, entries = 2, jerk_mm_s3 = 500 },

    steps = {
        step "enter" {
            title = "Enter the eye and come to the lens",
            hint = "In through the main incision with irrigation on (pedal 1). Then pedal 2: look whether the panel "
                .. "shows flow.",
            done = "phaco.tip_depth_mm > -1.2 or phaco.present and phaco.pedal > 1.9",
            time_limit_s = 60,
        },
        step "recognise" {
            title = "Find out that nothing flows",
            hint = "The panel shows no flow in pedal position 2: no ultrasound. Pedal up, and out of the eye.",
            hint_after_s = 8,
            done = "not phaco.present",
            time_limit_s = 60,
        },
        step "clear" {
            title = "Tip and line are cleared",
            script = function(_, act)
                act.say("The nurse flushes tip and tubing and looks along the line: now it flows.")
                act.wait(0.5)
                act.set("machine.flow_ml_min", 25)
                act.set("machine.infusion", 1)
            end,
        },
        step "go on" {
            title = "Sculpt with flow",
            hint = "In again, pedal 2 first: the panel shows flow. Then ultrasound.",
            done = "lens.removed_mg > goal.removed_mg",
            time_limit_s = 90,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Pedal 1, tip over the lens, and out through the wound.",
            done = "not phaco.present",
            time_limit_s = 60,
        },
    },

    errors = {
        error_event "Infusion off" (phaco_events.infusion_off { items = { "T7", "T8" } }),
        error_event "Wound burn" (phaco_events.wound_burn { items = { "T8", "T14", "G1" } }),
        error_event "Eye rolled" (globe_events.eye_rolled { items = { "G1" } }),
    },

    time_limit_s = 240,

    scoring = osacss { "T7", "T8", "G1", "G3", "G4", "G5", "G6" },
}
