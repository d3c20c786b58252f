-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Forceps: take, carry, let go"] = "Pince : saisir, porter, lâcher",
    ["Beads lie in a chamber full of viscoelastic. Go in with closed jaws, open them over a bead, close them on it, "
        .. "carry it to the tray in the middle of the pupil and let it go there, without touching iris or cornea. Come "
        .. "out with closed jaws."] =
        "Des perles reposent dans une chambre pleine de viscoélastique. Entrez mors fermés, ouvrez-les au-dessus d'une "
            .. "perle, fermez-les sur elle, portez-la au plateau, au milieu de la pupille, et lâchez-la là, sans "
            .. "toucher l'iris ni la cornée. Sortez mors fermés.",
    ["Open and close the jaws where it is safe"] = "Ouvrir et fermer les mors là où c'est sans danger",
    ["Take hold at the first try"] = "Saisir du premier coup",
    ["Carry without a jerk"] = "Porter sans à-coup",
    ["Take a bead"] = "Saisir une perle",
    ["Closed through the wound. Open over a bead, go down until it lies between the jaws, close."] =
        "Mors fermés à travers l'incision. Ouvrez au-dessus d'une perle, descendez jusqu'à ce qu'elle soit entre les "
            .. "mors, fermez.",
    ["All beads to the tray"] = "Porter toutes les perles au plateau",
    ["Lift, carry, open over the tray; then the next one."] =
        "Soulevez, portez, ouvrez au-dessus du plateau ; puis la suivante.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Jaws closed, out the way you came."] = "Mors fermés, ressortez par où vous êtes venu.",
    ["Bead dropped"] = "Perle tombée",
    ["The bead sinks beside the tray."] = "La perle tombe à côté du plateau.",
    ["Open the jaws, go back to the bead, take it again in its middle, and move without a jerk."] =
        "Ouvrez les mors, revenez à la perle, reprenez-la par son milieu, et déplacez-vous sans à-coup.",
    ["Jaws open in the wound"] = "Mors ouverts dans l'incision",
    ["The lips of the wound are pressed apart, viscoelastic comes out."] =
        "Les lèvres de l'incision s'écartent, du viscoélastique sort.",
    ["Close the jaws before you are in the wound, on the way in and on the way out."] =
        "Fermez les mors avant d'être dans l'incision, à l'entrée comme à la sortie.",
}
