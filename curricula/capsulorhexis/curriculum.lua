-- SPDX-License-Identifier: GPL-3.0-or-later
-- A round opening torn into the front of the lens capsule: from filling the chamber to the closed circle.

local rhexis_events = require "rhexis_events"
local rhexis_exercise = require "rhexis_exercise"

return exercise {
    title = "Capsulorhexis",
    version = 1,
    summary = "Fill the chamber with viscoelastic, pierce the anterior capsule with the cystotome and cut the "
        .. "beginning of a flap, then take hold of it with the forceps and tear it round, so that the opening is a "
        .. "circle a little smaller than the optic of the implant.",
    objectives = {
        "Fill the chamber before the capsule is opened, so that it lies flat",
        "Take hold of the flap near the end of the tear, again and again, and lead it round",
        "See a tear that runs outwards while it can still be put right",
    },

    patient = rhexis_exercise.patient,
    tissues = rhexis_exercise.tissues,
    instruments = rhexis_exercise.instruments,
    settings = { ["viscoelastic.fill"] = 0.2 },

    accuracy = rhexis_exercise.accuracy,

    goals = rhexis_exercise.goals,
    levels = {
        easy = { meaning = "wide pupil, chamber already filled", patient = { pupil_mm = 8.5 },
            settings = { ["viscoelastic.fill"] = 1 } },
        hard = { meaning = "narrow pupil, no hints", patient = { pupil_mm = 6 }, mode = "exam" },
    },
    reference = { time_s = 75, path_mm = 190, movements = 27, entries = 3, jerk_mm_s3 = 425 },

    steps = {
        step "fill" (rhexis_exercise.fill {
            hint = "Bring the cannula over the lens and press, until the chamber is deep and the capsule lies flat.",
        }),
        step "open" {
            title = "Pierce the capsule and begin the flap",
            hint = "With the cystotome: through the capsule a millimetre from its middle, outwards to the planned "
                .. "circle, and a quarter of the way round along it.",
            done = "rhexis.torn_mm > 3",
            time_limit_s = 90,
        },
        step "tear" (rhexis_exercise.close {
            title = "Tear the flap round",
            hint = "With the forceps: fold the flap over, take hold of it near the end of the tear, lead it round in "
                .. "the plane of the capsule, and take hold anew before the tear is far from the jaws.",
        }),
        -- Who sees that the opening is not as planned has time to come back with the needle, or to have it recorded.
        step "withdraw" (rhexis_exercise.withdraw {
            hint = "Take the flap out with the forceps. Compare the opening with the plan before you leave.",
            done = "instruments.out_s > 0 and (instruments.out_s > 7 or requested.opening_recorded or "
                .. "(abs(rhexis.diameter_mm - 2 * goal.radius_mm - 0.01) < 0.75 and rhexis.centre_offset_mm <= 0.5))",
        }),
    },

    requests = {
        request "Opening recorded" {
            meaning = "size and place of the opening go on record, and lens and place of the optic are chosen by them",
            answer = "On record: the lens is chosen by it.",
        },
        request "Weak zonules declared" {
            meaning = "the zonules are weak: hooks or a ring before the nucleus is touched",
            answer = "Hooks and a ring are laid out.",
        },
    },

    errors = {
        error_event "Underfilled" (rhexis_events.underfilled { items = { "T3", "T4" } }),
        error_event "Overfilled" (rhexis_events.overfilled { items = { "T3" } }),
        error_event "Wrinkles at the puncture" (rhexis_events.wrinkles { items = { "T4", "T10" } }),
        error_event "Tear runs out" (rhexis_events.runs_out { items = { "T4", "T5", "G4" } }),
        error_event "Edge lost" (rhexis_events.edge_lost { items = { "T5" } }),
        error_event "Opening too small" (rhexis_events.too_small { items = { "T5", "T13" } }),
        error_event "Opening too large" (rhexis_events.too_large { items = { "T5", "T13" } }),
        error_event "Opening off-centre" (rhexis_events.off_centre { items = { "T5", "T13" } }),
        error_event "Needle too deep" (rhexis_events.too_deep { items = { "T4", "G4" } }),
        error_event "Iris touched" (rhexis_events.iris_touched { items = { "G5", "G4" } }),
    },

    -- The attempt is over when no instrument has come back for longer than it takes to change them.
    over = { "rhexis.opened", "instruments.out_s > 8" },
    time_limit_s = 300,

    scoring = osacss { "T3", "T4", "T5", "G2", "G3", "G4", "G5", "G6" },
}
