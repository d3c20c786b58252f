-- SPDX-License-Identifier: GPL-3.0-or-later
-- A capsulorhexis of a stated size in a small pupil, where the red reflex is lost.
return exercise {
    title = "Rhexis in a small pupil",
    summary = "A white cataract, a pupil of 5 mm: a round opening that stays inside what can be seen.",
    objectives = { "Keep the tear inside the pupil", "Stain when the red reflex is lost" },

    patient = { age = 74, nuclear_grade = 3, cortical_opacity = 1, pupil_mm = 5 },
    tissues = { "anterior_capsule", "iris", "cornea", "viscoelastic" },
    instruments = { "cystotome", "forceps", "cannula" },

    goals = { diameter_mm = { 4.5, from = 3.5, to = 5.5, meaning = "diameter of the opening" },
              limit_mm = { 2.6, from = 1, to = 4, meaning = "farthest that the tear may go from the middle" } },
    settings = { capsule = { trypan_blue = 1, triangles = 800 } },  -- stained; coarse, which is fast

    levels = {
        easy = { meaning = "pupil of 6 mm", patient = { pupil_mm = 6 } },
        hard = { meaning = "pupil of 4.5 mm, smaller opening", patient = { pupil_mm = 4.5 },
            goals = { diameter_mm = 4 } },
    },

    steps = {
        step "open" {
            title = "Pierce the capsule",
            hint = "No red reflex: the capsule is stained with trypan blue. Pierce it near the middle.",
            done = "rhexis.opened",
            time_limit_s = 40,
        },
        step "tear" {
            title = "Tear round",
            hint = "What you tear must stay in the pupil: grasp close to the tip of the tear, pull inwards.",
            hint_after_s = 5,
            done = "rhexis.closed",
            time_limit_s = 180,
        },
        step "leave" {
            title = "Leave the eye",
            done = "not cystotome.present and not forceps.present",
            time_limit_s = 20,
        },
    },

    errors = {
        error_event "Tear under the iris" {
            when = "rhexis.tip_radius_mm > goal.limit_mm",
            recovered = "rhexis.tip_radius_mm < goal.limit_mm - 0.2",
            deadline_s = 6,
            cue = "The tip of the tear cannot be seen any more.",
            advice = "Stop. Fill with viscoelastic, let go, grasp close to the tip, pull to the middle.",
            items = { "T3", "T5" },
            steps = { "tear" },
        },
        error_event "Iris touched" {
            when = "iris.touch",
            recovered = "iris.gap_mm > 0.2",
            deadline_s = 2,
            severity = "minor",
            advice = "Draw the tip back to the middle of the pupil.",
            items = { "G5" },
        },
        error_event "Tip out of sight" {
            when = "instruments.hidden",
            hold_s = 0.3,
            recovered = "not instruments.hidden",
            deadline_s = 1.5,
            severity = "minor",
            advice = "Work where you can see.",
            items = { "G4" },
        },
    },

    scoring = osacss { "T3", "T4", "T5", "G4", "G5" },
    time_limit_s = 240,
}
