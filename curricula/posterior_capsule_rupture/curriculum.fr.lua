-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["the hyaloid is broken too: vitreous is in the chamber and in the wound"] =
        "la hyaloïde est rompue aussi : du vitré est dans la chambre et dans l'incision",
    ["The posterior capsule is torn"] = "La capsule postérieure est déchirée",
    ["The lens is out, and a round clear edge shows in the reflex: a hole in the posterior capsule. Whatever lets the "
        .. "pressure fall now makes the hole larger and lets the vitreous come. Keep the chamber up, lay viscoelastic "
        .. "over the hole, and only then come out. What has come forward all the same is made white, and cut away."] =
        "Le cristallin est enlevé, et un bord rond et net apparaît dans la lueur : un trou de la capsule postérieure. "
            .. "Tout ce qui fait maintenant chuter la pression agrandit le trou et laisse venir le vitré. Maintenez la "
            .. "chambre, déposez du viscoélastique sur le trou, et ne sortez qu'ensuite. Ce qui est venu en avant "
            .. "malgré tout est marqué à la triamcinolone, puis coupé.",
    ["Leave the tip in when the capsule tears, and aspirate nothing"] =
        "Laisser la pointe dans l'œil quand la capsule se déchire, et ne rien aspirer",
    ["Cover the hole with viscoelastic through the side port before the tip leaves"] =
        "Couvrir le trou de viscoélastique par la contre-incision avant que la pointe ne sorte",
    ["Take vitreous out of the chamber by cutting it before it is sucked in, and see that none is left"] =
        "Retirer le vitré de la chambre en le coupant avant de l'aspirer, et vérifier qu'il n'en reste pas",
    ["Bottle down"] = "Flacon baissé",
    ["the bottle is lowered to 50 cm above the eye"] = "le flacon est abaissé à 50 cm au-dessus de l'œil",
    ["Bottle at 50."] = "Flacon à 50.",
    ["Keep the chamber up"] = "Maintenir la chambre",
    ["Tip in with irrigation on (pedal 1), as it was when you saw the edge. No aspiration, no movement towards the "
        .. "hole."] =
        "La pointe dans l'œil, irrigation ouverte (pédale en 1), là où elle était quand vous avez vu le bord. Pas "
            .. "d'aspiration, pas de mouvement vers le trou.",
    ["Viscoelastic over the hole"] = "Viscoélastique sur le trou",
    ["Cannula through the side port, its end before the hole. Press until the hole is covered and the chamber is full "
        .. "of viscoelastic."] =
        "La canule par la contre-incision, l'extrémité devant le trou. Injectez jusqu'à ce que le trou soit couvert et "
            .. "la chambre pleine de viscoélastique.",
    ["Come out"] = "Sortir",
    ["Now the tip may leave: the chamber stays as it is."] =
        "La pointe peut maintenant sortir : la chambre reste telle quelle.",
    ["Is there vitreous?"] = "Y a-t-il du vitré ?",
    ["Triamcinolone through the side port. If white strands show, cover the hole again and cut: pedal 2 cuts, pedal 3 "
        .. "cuts and aspirates. Then look once more."] =
        "Triamcinolone par la contre-incision. Si des mèches blanches apparaissent, couvrez de nouveau le trou et "
            .. "coupez : la pédale en 2 coupe, en 3 elle coupe et aspire. Puis regardez encore une fois.",
    ["Vitreous"] = "Issue de vitré",
}
