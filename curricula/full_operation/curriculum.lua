-- SPDX-License-Identifier: GPL-3.0-or-later
-- The operation, made of the exercises that train its parts. One eye goes through all of them: what one part leaves for
-- the next is named.

return operation {
    title = "Cataract operation",
    version = 2,
    summary = "The whole operation on one eye, from the drape to the closed wound: incisions, viscoelastic and the "
        .. "opening of the capsule, hydrodissection, the nucleus, which a laser has cut into quarters, cortex, an "
        .. "implant in the bag, viscoelastic out, wounds tight.",
    objectives = { "Complete every part, and leave the eye tight, with the implant centred in the bag",
        "Hand on to each part what it needs: a round opening, a free nucleus, a whole posterior capsule",
        "Notice each error at once, and put it right before going on" },

    patient = { age = 68, cataract = "NO3", pupil_mm = 8 },

    parts = {
        part "set_up" {},
        part "incision" {},
        part "capsulorhexis" {},
        part "hydrodissection" { begins_with = { ["capsulorhexis.diameter_mm"] = "rhexis.diameter_mm" } },
        part "phaco_quadrants" {
            accuracy = { time = 0.02 },
            begins_with = {
                ["capsulorhexis.diameter_mm"] = "rhexis.diameter_mm",
                ["hydrodissection.freed"] = "hydro.freed_share",
                ["capsule.hole_mm"] = "2 * sqrt(capsule.hole_mm2 / 3.14159)",
            },
        },
        part "cortex" {
            begins_with = { ["capsule.hole_mm"] = "2 * sqrt(capsule.hole_mm2 / 3.14159)" },
        },
        part "iol_injection" { opening = "capsulorhexis" },
        part "viscoelastic_removal" {},
        part "wound_closure" {
            begins_with = {
                ["wounds.main_tunnel_mm"] = "wounds.main_tunnel_mm",
                ["wounds.main_width_mm"] = "wounds.main_width_mm",
                ["wounds.main_inner_lip_mm"] = "wounds.main_inner_lip_mm",
                ["wounds.main_peel_mm"] = "wounds.main_peel_mm",
                ["wounds.main_burn"] = "wound.burn_share",
            },
        },
    },

    scoring = osacss.all,
    reference = { time_s = 750, path_mm = 1308, entries = 16 },  -- way and entries: what the parts give, added up
}
