-- SPDX-License-Identifier: GPL-3.0-or-later
-- A round opening torn into the front of the lens capsule: from filling the chamber to the closed circle.

local rhexis_events = require "rhexis_events"

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

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "anterior_capsule", "viscoelastic", "iris", "cornea" },
    instruments = { "cystotome", "forceps", "cannula", "microscope" },
    settings = { ["viscoelastic.fill"] = 0.2 },

    step_s = 0.02,  -- docs/tearing.md, "What it costs, and which mesh and step"

    goals = {
        radius_mm = { 2.62, from = 2, to = 3.2, meaning = "of the circle that is planned" },
        fill_percent = { 90, from = 50, to = 100,
            meaning = "how full the chamber must be before one opens the capsule" },
    },
    reference = { time_s = 75, path_mm = 120 },

    steps = {
        step "fill" {
            title = "Fill the chamber",
            hint = "Bring the cannula over the lens and press, until the chamber is deep and the capsule lies flat.",
            done = "100 * viscoelastic.fill >= goal.fill_percent",
            time_limit_s = 60,
        },
        step "open" {
            title = "Pierce the capsule and begin the flap",
            hint = "With the cystotome: through the capsule a millimetre from its middle, outwards to the planned "
                .. "circle, and a quarter of the way round along it.",
            done = "rhexis.torn_mm > 3",
            time_limit_s = 90,
        },
        step "tear" {
            title = "Tear the flap round",
            hint = "With the forceps: fold the flap over, take hold of it near the end of the tear, lead it round in "
                .. "the plane of the capsule, and take hold anew before the tear is far from the jaws.",
            done = "rhexis.closed",
            time_limit_s = 180,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Take the flap out with the forceps.",
            done = "not forceps.present and not cystotome.present and not cannula.present",
        },
    },

    errors = {
        error_event "Underfilled" (rhexis_events.underfilled { items = { "T3", "T4" } }),
        error_event "Overfilled" (rhexis_events.overfilled { items = { "T3" } }),
        error_event "Tear runs out" (rhexis_events.runs_out { items = { "T4", "T5", "G4" } }),
        error_event "Edge lost" (rhexis_events.edge_lost { items = { "T5" } }),
        error_event "Needle too deep" (rhexis_events.too_deep { items = { "T4", "G4" } }),
        error_event "Iris touched" (rhexis_events.iris_touched { items = { "G5", "G4" } }),
    },

    -- The attempt is over when no instrument has come back for longer than it takes to change them.
    over = { "rhexis.opened", "instruments.out_s > 8" },
    time_limit_s = 300,

    scoring = osacss { "T3", "T4", "T5", "G2", "G3", "G4", "G5", "G6" },
}
