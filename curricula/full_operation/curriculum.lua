-- SPDX-License-Identifier: GPL-3.0-or-later
-- The operation, made of the exercises that train its parts. One eye goes through all of them.

return operation {
    title = "Cataract operation",
    version = 1,
    summary = "The whole operation on one eye: the capsule is opened, the nucleus, which a laser has cut into "
        .. "quarters, taken out, and an implant laid into the bag.",

    patient = { age = 68, cataract = "NO3", pupil_mm = 8 },

    parts = {
        part "capsulorhexis" {},
        part "phaco_quadrants" {},
        part "iol_injection" { opening = "capsulorhexis" },
    },

    scoring = osacss { "T3", "T4", "T5", "T7", "T8", "T11", "T13", "G2", "G3", "G4", "G5", "G6" },
    reference = { time_s = 550 },
}
