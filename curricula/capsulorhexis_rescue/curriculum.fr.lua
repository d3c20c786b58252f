-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Rescue of a capsulorhexis"] = "Rattrapage d'un capsulorhexis",
    ["The tear has left the planned circle, for the chamber was shallow, and is on its way to the zonules. Stop, fill "
        .. "the chamber, bring the tear back to the circle, and close it."] =
        "La déchirure a quitté le cercle prévu, car la chambre était étroite, et file vers la zonule. Arrêtez, "
            .. "remplissez la chambre, ramenez la déchirure sur le cercle, et fermez-le.",
    ["Fill the chamber before anything is pulled at"] = "Remplir la chambre avant toute traction",
    ["Turn the tear back: hold the flap close to its end, pull backwards, then to the middle"] =
        "Faire revenir la déchirure : tenir le lambeau près de son extrémité, tirer en arrière, puis vers le centre",
    ["Close the opening in one piece"] = "Fermer l'ouverture d'un seul tenant",
    ["Fill the chamber"] = "Remplir la chambre",
    ["Do not pull. Bring the cannula over the lens and press, until the chamber is deep again."] =
        "Ne tirez pas. Amenez la canule au-dessus du cristallin et appuyez, jusqu'à ce que la chambre soit de nouveau "
            .. "profonde.",
    ["Bring the tear back"] = "Ramener la déchirure",
    ["Lay the flap flat, hold it close to the end of the tear, pull back along the way it came and then to the "
        .. "middle."] =
        "Dépliez le lambeau à plat, tenez-le près de l'extrémité de la déchirure, tirez en arrière le long du trajet "
            .. "déjà fait, puis vers le centre.",
    ["Close the circle"] = "Fermer le cercle",
    ["Lead the flap round as in every capsulorhexis, and fill again before the chamber gets shallow."] =
        "Menez le lambeau en rond comme dans tout capsulorhexis, et remplissez de nouveau avant que la chambre ne "
            .. "s'aplatisse.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Take the flap out with the forceps."] = "Retirez le lambeau à la pince.",
    ["Pulled in a shallow chamber"] = "Traction dans une chambre étroite",
}
