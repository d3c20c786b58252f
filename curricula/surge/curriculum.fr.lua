-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Surge when an occlusion breaks"] = "Surge quand une occlusion cède",
    ["The nucleus lies in quarters. Vacuum is high, the tubing soft, the bottle not high enough: what the tubing has "
        .. "stored comes out of the eye as soon as the piece clears. Take a piece onto the tip, let the vacuum build "
        .. "up, and let go of it with the chamber deep."] =
        "Le noyau est en quadrants. Le vide est fort, la tubulure souple, le flacon pas assez haut : ce que la "
            .. "tubulure a emmagasiné est pris à l'œil dès que le fragment passe. Prenez un fragment à la pointe, "
            .. "laissez monter le vide, et relâchez-le dans une chambre profonde.",
    ["Know by the panel that the tip is shut, and what will follow when it opens"] =
        "Reconnaître à l'écran que l'embout est obstrué, et prévoir ce qui suivra quand il se libérera",
    ["Ease the pedal to 1 before the piece clears, or within half a second after it"] =
        "Revenir en pédale 1 avant que le fragment ne passe, ou dans la demi-seconde qui suit",
    ["See a chamber that empties, and fill it before anything else"] =
        "Voir une chambre qui se vide, et la remplir avant toute autre chose",
    ["Enter the eye and come to the lens"] = "Entrer dans l'œil et approcher le cristallin",
    ["In through the main incision with irrigation on (pedal 1): the chamber deepens."] =
        "Entrez par l'incision principale, irrigation ouverte (pédale en 1) : la chambre s'approfondit.",
    ["Take a piece onto the tip"] = "Prendre un fragment à la pointe",
    ["From the trench into the far right quarter with a touch of ultrasound, then pedal 2. Wait until the vacuum on "
        .. "the panel has built up."] =
        "De la tranchée, entrez dans le quadrant éloigné droit avec un peu d'ultrasons, puis pédale en 2. Attendez que "
            .. "le vide soit monté à l'écran.",
    ["Let it go with the chamber deep"] = "Le relâcher dans une chambre profonde",
    ["Pedal to 1, and wait until the panel shows that the vacuum is gone. Only then away from the piece."] =
        "Pédale en 1, et attendez que l'écran montre que le vide est tombé. Ne vous éloignez du fragment qu'ensuite.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Pedal 1, tip over the lens, and out through the wound."] =
        "Pédale en 1, la pointe au-dessus du cristallin, et sortez par l'incision.",
}
