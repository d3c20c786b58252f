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
    ["Complete every part, and leave the eye tight, with the implant centred in the bag"] =
        "Accomplir chaque partie, et laisser l'œil étanche, avec l'implant centré dans le sac",
    ["Hand on to each part what it needs: a round opening, a free nucleus, a whole posterior capsule"] =
        "Laisser à chaque partie ce qu'il lui faut : une ouverture ronde, un noyau libre, "
            .. "une capsule postérieure intacte",
    ["Notice each error at once, and put it right before going on"] =
        "Remarquer chaque erreur aussitôt, et la réparer avant de continuer",
}
