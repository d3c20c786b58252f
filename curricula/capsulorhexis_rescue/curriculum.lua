-- SPDX-License-Identifier: GPL-3.0-or-later
-- A capsulorhexis that runs out, and is brought back: fill, take hold close to the end of the tear, pull back along the
-- way it came, then to the middle [Little2006]. It begins in the state `begin` of starts.lua.

local rhexis_events = require "rhexis_events"
local rhexis_exercise = require "rhexis_exercise"

return exercise {
    title = "Rescue of a capsulorhexis",
    version = 1,
    summary = "The tear has left the planned circle, for the chamber was shallow, and is on its way to the zonules. "
        .. "Stop, fill the chamber, bring the tear back to the circle, and close it.",
    objectives = {
        "Fill the chamber before anything is pulled at",
        "Turn the tear back: hold the flap close to its end, pull backwards, then to the middle",
        "Close the opening in one piece",
    },

    patient = rhexis_exercise.patient,
    tissues = rhexis_exercise.tissues,
    instruments = rhexis_exercise.instruments,
    settings = {
        ["viscoelastic.fill"] = 0.3,
        ["vitreous.pressure_mmhg"] = 20,
        ["capsule.toughness"] = 0.6,
    },

    accuracy = rhexis_exercise.accuracy,

    goals = rhexis_exercise.goals,
    reference = { time_s = 60, path_mm = 155, movements = 28, entries = 2, jerk_mm_s3 = 425 },

    steps = {
        step "fill" (rhexis_exercise.fill {
            hint = "Do not pull. Bring the cannula over the lens and press, until the chamber is deep again.",
        }),
        step "turn_back" {
            title = "Bring the tear back",
            hint = "Lay the flap flat, hold it close to the end of the tear, pull back along the way it came and then "
                .. "to the middle.",
            done = "rhexis.closed or (rhexis.tip_radius_mm < goal.radius_mm + 0.3 and rhexis.tip_heading_deg < 10)",
            time_limit_s = 120,
        },
        step "close" (rhexis_exercise.close {
            title = "Close the circle",
            hint = "Lead the flap round as in every capsulorhexis, and fill again before the chamber gets shallow.",
        }),
        step "withdraw" (rhexis_exercise.withdraw {}),
    },

    errors = {
        error_event "Pulled in a shallow chamber" (rhexis_events.underfilled { items = { "T3", "T5" } }),
        error_event "Overfilled" (rhexis_events.overfilled { items = { "T3" } }),
        error_event "Edge lost" (rhexis_events.edge_lost { items = { "T5" } }),
        error_event "Iris touched" (rhexis_events.iris_touched { items = { "G5", "G4" } }),
    },

    -- The attempt is over when no instrument has come back for longer than it takes to bring the eye into the picture.
    over = { "rhexis.opened", "instruments.out_s > 25" },
    time_limit_s = 300,

    scoring = osacss { "T3", "T5", "G2", "G3", "G4", "G5", "G6" },
}
