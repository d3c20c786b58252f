-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Weak zonules"] = "Zonule fragile",
    ["Zonules are weak all round, and over two and a half clock hours they are lost: the lens lies aside. Lay "
        .. "viscoelastic over the gap, hold the bag there with hooks or put in a ring, lower bottle and flow, and then "
        .. "sculpt a groove without pushing, so that no more of them tear."] =
        "La zonule est fragile sur tout le tour, et perdue sur deux heures et demie d'horloge : le cristallin est "
            .. "décentré. Déposez du viscoélastique sur la brèche, tenez-y le sac par des crochets ou posez un anneau, "
            .. "baissez flacon et débit, puis sculptez un sillon sans pousser, pour qu'elle ne se déchire pas "
            .. "davantage.",
    ["See by the edge of the bag and by how the lens moves where it lacks its hold"] =
        "Voir, au bord du sac et aux mouvements du cristallin, où l'appui lui manque",
    ["Support the bag before any force is put on the lens"] = "Soutenir le sac avant toute force sur le cristallin",
    ["Sculpt with a low bottle and little force"] = "Sculpter flacon bas et avec peu de force",
    ["Viscoelastic over the gap"] = "Viscoélastique sur la brèche",
    ["Look where the lens lies aside. Cannula towards the gap, and press until it is covered."] =
        "Regardez de quel côté le cristallin est décentré. La canule vers la brèche, et injectez jusqu'à ce qu'elle "
            .. "soit couverte.",
    ["Hold the bag"] = "Soutenir le sac",
    ["Hooks round the edge of the opening over the gap, or a ring into the bag: a ring does for up to four clock "
        .. "hours."] =
        "Des crochets autour du bord de l'ouverture en regard de la brèche, ou un anneau dans le sac : un anneau "
            .. "suffit jusqu'à quatre heures d'horloge.",
    ["Sculpt a groove"] = "Sculpter un sillon",
    ["Low bottle, slow strokes, enough ultrasound: the tip cuts, it does not push."] =
        "Flacon bas, passages lents, assez d'ultrasons : la pointe coupe, elle ne pousse pas.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Pedal 1, tip over the lens, and out."] = "Pédale en 1, la pointe au-dessus du cristallin, et sortez.",
}
