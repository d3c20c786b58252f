-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercises beside this one as an operation: what one part leaves, the next begins with.
return operation {
    title = "From the wound to the first surge",
    objectives = { "One eye, three parts", "What is done badly at the wound follows you" },
    patient = { age = 72, cataract = "NO3", pupil_mm = 6.5, tetrahedra = 500 },
    parts = {
        part "wounds" { exercise = "../two_wounds", time_limit_s = 40 },
        part "opening" { exercise = "../small_pupil", time_limit_s = 10, goals = { diameter_mm = 5 } },
        part "surge" {
            exercise = "../sudden_surge",
            begins_with = {
                ["capsulorhexis.diameter_mm"] = "rhexis.diameter_mm",
                ["wound.leak_ml_min"] = "min(15, 3 + 0.06 * wounds.leak_at_20_ul_s)",
            },
        },
    },
    scoring = osacss { "T2", "T4", "T5", "G4", "G5", "G6" },
}
