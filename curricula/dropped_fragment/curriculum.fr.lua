-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["A piece has gone into the vitreous"] = "Un fragment est tombé dans le vitré",
    ["The posterior capsule is open, and a quarter of the nucleus lies behind it, dim and small. Whatever goes after "
        .. "it pulls on the vitreous. Keep tip and vacuum away from the depth, lay viscoelastic over the hole so that "
        .. "nothing else follows, and come out: the piece is taken out from behind, later."] =
        "La capsule postérieure est ouverte, et un quadrant du noyau se trouve derrière elle, pâle et petit. Tout ce "
            .. "qui le poursuit tire sur le vitré. Tenez la pointe et le vide loin de la profondeur, déposez du "
            .. "viscoélastique sur le trou pour que rien d'autre ne suive, et sortez : on enlèvera le fragment plus "
            .. "tard, par l'arrière.",
    ["Know a piece that has sunk, and let it lie"] = "Reconnaître un fragment tombé, et l'y laisser",
    ["Keep the other pieces and the vitreous where they are with viscoelastic"] =
        "Retenir les autres fragments et le vitré en place par du viscoélastique",
    ["Leave a chamber that stays up"] = "Laisser une chambre qui tient",
    ["Retina surgeon called"] = "Chirurgien de la rétine appelé",
    ["the patient is referred: the piece is taken out from behind"] =
        "le patient est adressé : le fragment sera enlevé par l'arrière",
    ["They take the patient today."] = "Le patient est pris en charge aujourd'hui.",
    ["Keep the chamber up"] = "Maintenir la chambre",
    ["Tip in with irrigation on (pedal 1), in the plane of the iris. No aspiration, not towards the piece."] =
        "La pointe dans l'œil, irrigation ouverte (pédale en 1), dans le plan de l'iris. Pas d'aspiration, pas de "
            .. "mouvement vers le fragment.",
    ["Viscoelastic over the hole"] = "Viscoélastique sur le trou",
    ["Cannula through the side port, before the hole, until it is covered and the chamber is full."] =
        "La canule par la contre-incision, devant le trou : injectez jusqu'à ce qu'il soit couvert et la chambre "
            .. "pleine.",
    ["Come out"] = "Sortir",
    ["The tip leaves a chamber that stays up."] = "La pointe quitte une chambre qui tient.",
    ["Refer the patient"] = "Adresser le patient",
    ["Say that the retina surgeon is to be called; the rest is done from behind."] =
        "Dites qu'il faut appeler le chirurgien de la rétine ; le reste se fait par l'arrière.",
    ["Piece chased"] = "Fragment poursuivi",
    ["The tip goes down through the hole after a piece that gets dimmer."] =
        "La pointe descend à travers le trou, à la poursuite d'un fragment qui pâlit.",
    ["Stop: pedal to 1, tip up to the plane of the iris. Through the vitreous nobody reaches it without pulling on the "
        .. "retina."] =
        "Arrêtez : pédale en 1, la pointe remontée dans le plan de l'iris. À travers le vitré, nul ne l'atteint sans "
            .. "tirer sur la rétine.",
}
