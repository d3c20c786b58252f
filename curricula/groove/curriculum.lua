-- SPDX-License-Identifier: GPL-3.0-or-later
-- One groove, sculpted into the middle of a cataract that lies free in its capsular bag.

local touch_events = require "touch_events"

return exercise {
    title = "Sculpting a groove",
    version = 1,
    summary = "The capsule is open and the nucleus turns freely. Sculpt one groove with the phaco tip: at least 4 mm "
        .. "long and so deep that the red reflex glows in it, without touching the posterior capsule or the iris and "
        .. "without pushing the lens.",
    objectives = {
        "Judge depth by the red reflex",
        "Match speed and ultrasound power, so that the tip cuts and does not push",
        "Ultrasound on the forward stroke only",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    accuracy = { force = 0.2, time = 0.02 },
    tissues = { "lens", "bag", "iris", "cornea" },
    instruments = { "phaco" },

    goals = {
        length_mm = { 4.0, from = 1, to = 7, meaning = "how long the groove must be" },
        depth_percent = { 60, from = 10, to = 90, meaning = "how deep, of the lens's thickness" },
    },
    reference = { time_s = 51, path_mm = 237, movements = 32, entries = 1, jerk_mm_s3 = 515 },

    steps = {
        step "approach" {
            title = "Enter the eye and come to the lens",
            hint = "Go in through the incision with irrigation on (pedal 1), and bring the tip to the front of the "
                .. "lens, on your own side of its centre.",
            done = "phaco.tip_depth_mm > -0.5",
            time_limit_s = 60,
        },
        step "sculpt" {
            title = "Sculpt the groove",
            hint = "Stroke away from yourself with ultrasound (pedal 3), come back without it. Take a thin layer each "
                .. "time. Stop when the groove glows red.",
            done = "groove.length_mm >= goal.length_mm and 100 * groove.depth_share >= goal.depth_percent "
                .. "and phaco.tip_depth_mm < 0",
            time_limit_s = 180,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Back to pedal 1, lift the tip over the lens and draw it out through the incision.",
            done = "not phaco.present",
        },
    },

    errors = {
        error_event "Groove too deep" {
            when = "phaco.tip_posterior_mm < 0.3 and (phaco.aspirating or phaco.ultrasound)",
            recovered = "phaco.tip_posterior_mm > 0.6",
            deadline_s = 2,
            harm = "phaco.tip_posterior_mm < 0.1",
            severity = "critical",
            cue = "The reflex in the groove is bright, and the plate at its floor feels soft.",
            advice = "Too deep: let go to pedal 1 and lift the tip straight up. Go on elsewhere, not here.",
            items = { "T9", "G4" },
            evidence = { "groove.depth_share", "phaco.power", "reflex.tip" },
        },
        error_event "Iris touched" (touch_events.iris { items = { "G5", "G4" },
            evidence = { "iris.gap_mm", "phaco.pedal" } }),
        error_event "Pushing the lens" {
            when = "lens.displacement_mm > 0.5",
            recovered = "lens.displacement_mm < 0.25",
            deadline_s = 5,
            severity = "critical",
            cue = "The whole lens moves away from the tip.",
            advice = "You push more than you cut: stop, let the lens come back, then stroke more slowly or with more "
                .. "power.",
            items = { "T9" },
            evidence = { "phaco.force_mN", "phaco.speed_mm_s", "phaco.power", "zonules.strain" },
        },
    },

    -- The attempt is over when the instrument has left the eye after work, whatever was reached.
    over = { "phaco.tip_depth_mm > -0.5", "not phaco.present" },
    time_limit_s = 240,

    scoring = osacss { "T8", "T9", "G3", "G4", "G5", "G6" },
}
