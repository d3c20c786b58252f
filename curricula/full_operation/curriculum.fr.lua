-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Cataract operation"] = "Opération de la cataracte",
    ["The whole operation on one eye, from the drape to the closed wound: incisions, viscoelastic and the opening "
        .. "of the capsule, hydrodissection, the nucleus, which a laser has cut into quarters, cortex, an implant "
        .. "in the bag, viscoelastic out, wounds tight."] =
        "L'opération entière sur un seul œil, du champ opératoire à l'incision fermée : incisions, viscoélastique "
            .. "et ouverture de la capsule, hydrodissection, noyau, qu'un laser a coupé en quadrants, cortex, "
            .. "implant dans le sac, viscoélastique retiré, incisions étanches.",
}
