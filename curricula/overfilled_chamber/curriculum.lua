-- SPDX-License-Identifier: GPL-3.0-or-later
-- More viscoelastic in the chamber than the eye bears: the lip of the side port is pressed aside until enough has come
-- out.

local rhexis_events = require "rhexis_events"

return exercise {
    title = "Overfilled chamber",
    version = 1,
    summary = "Too much viscoelastic was pressed into the chamber: the eye is hard, and the iris bulges towards the "
        .. "wounds. Let some out past the lip of the side port until the eye is soft.",
    objectives = {
        "Feel that an eye is too hard before anything is cut",
        "Let viscoelastic out by pressing on the lip of a wound, a little at a time",
        "Leave the chamber full: what comes out by itself at a low pressure is little",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7 },
    tissues = { "viscoelastic", "iris", "cornea", "globe" },
    instruments = { "spatula", "cannula" },
    settings = { ["viscoelastic.fill"] = 1.2 },

    goals = {
        pressure_mmhg = { 25, from = 15, to = 29, meaning = "pressure to which the eye must be let down" },
    },
    -- proposal: what group d comes near to
    reference = { time_s = 20, path_mm = 40, movements = 8, entries = 1, jerk_mm_s3 = 500 },

    steps = {
        step "let out" {
            title = "Let the pressure out",
            hint = "Spatula into the side port, just through it. Press its lip aside, let go, and look: viscoelastic "
                .. "comes while the lip stands open.",
            done = "viscoelastic.pressure_mmhg < goal.pressure_mmhg",
            time_limit_s = 60,
        },
        step "leave it" {
            title = "Leave the eye soft",
            hint = "Back to the middle of the wound, and out.",
            done = "instruments.out_s > 1 and viscoelastic.pressure_mmhg < 30",
            time_limit_s = 60,
        },
    },

    errors = {
        error_event "Overfilled" (rhexis_events.overfilled { items = { "T3" },
            evidence = { "viscoelastic.pressure_mmhg", "viscoelastic.fill" } }),
    },

    time_limit_s = 150,

    scoring = osacss { "T3", "G1", "G4", "G5", "G6" },
}
