-- SPDX-License-Identifier: GPL-3.0-or-later
-- Saline under the rim of the capsulorhexis parts the cortex from the capsule, until the nucleus turns freely.

local bag_events = require "bag_events"

return exercise {
    title = "Hydrodissection",
    version = 1,
    summary = "The capsule is open, and the cortex adheres to it all round. Saline that is injected under the "
        .. "rim runs as a wave over the back of the bag and parts the two. What cannot come out past the nucleus "
        .. "pushes it forward, and at last bursts the posterior capsule. A nucleus that turns is free.",
    objectives = {
        "Bring the cannula under the rim, close to the capsule, and see the wave cross the red reflex",
        "Press the nucleus back between injections, so that no fluid stays trapped",
        "Turn the nucleus before going on, and never by force",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber", "hydrodissection" },
    instruments = { "saline_cannula", "cannula" },
    settings = {
        ["hydrodissection.freed"] = 0,
        ["hydrodissection.viscoelastic_fill"] = 0.7,
        ["capsulorhexis.diameter_mm"] = 5.25,
    },

    goals = {
        wave_percent = { 90, from = 30, to = 100, meaning = "how much of the posterior capsule the wave must pass" },
        turn_deg = { 60, from = 20, to = 360, meaning = "how far the nucleus must be turned" },
    },
    reference = { time_s = 45, path_mm = 90, movements = 20, entries = 1, jerk_mm_s3 = 500 },  -- proposal

    steps = {
        step "wave" {
            title = "The wave",
            hint = "Cannula under the rim, its end close to the capsule. Inject gently until the dark front "
                .. "has crossed the red reflex; stop when the nucleus comes forward.",
            picture_when = "hydro.wave_share > 0.4",
            done = "100 * hydro.wave_share >= goal.wave_percent",
            time_limit_s = 90,
        },
        step "decompress" {
            title = "Let the fluid out",
            hint = "Press on the middle of the nucleus until it lies back.",
            done = "hydro.forward_mm < 0.15",
            time_limit_s = 30,
        },
        step "turn" {
            title = "Turn the nucleus",
            hint = "Press the end of the cannula on the nucleus beside the middle and draw it round. It must turn "
                .. "without its bag.",
            done = "bag.slip_deg * bag.slip_deg >= goal.turn_deg * goal.turn_deg",
            time_limit_s = 90,
        },
        step "withdraw" {
            title = "Come out",
            hint = "Straight out through the incision.",
            done = "not saline_cannula.present and not cannula.present",
            time_limit_s = 30,
        },
    },

    errors = {
        error_event "No wave or no rotation" (bag_events.no_wave { items = { "T6" } }),
        error_event "Capsular block" (bag_events.block { items = { "T3", "T6" } }),
        error_event "Hydrorupture" (bag_events.hydrorupture { items = { "T6", "T11", "G4" } }),
    },

    time_limit_s = 240,

    scoring = osacss { "T6", "G3", "G4", "G5", "G6" },
}
