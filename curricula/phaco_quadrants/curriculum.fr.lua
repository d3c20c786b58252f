-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Removing the quarters"] = "Ablation des quadrants",
    ["A laser has cut the lens into quarters. Take them out one after the other: bury the tip in a quarter, let "
        .. "the vacuum build up and hold it, draw it to the middle of the pupil, and emulsify it there, away from "
        .. "the posterior capsule."] =
        "Un laser a coupé le cristallin en quadrants. Enlevez-les l'un après l'autre : enfoncez la pointe dans un "
            .. "quadrant, laissez monter le vide qui le retient, amenez-le au milieu de la pupille, et "
            .. "émulsifiez-le là, loin de la capsule postérieure.",
    ["Let vacuum hold a piece, and draw it to a safe place before emulsifying"] =
        "Laisser le vide retenir un fragment, et l'amener en lieu sûr avant de l'émulsifier",
    ["Keep the chamber deep when an occlusion breaks"] = "Garder la chambre profonde quand une occlusion cède",
    ["Recognise a capsule that is held, and let go before pulling"] =
        "Reconnaître une capsule aspirée, et la relâcher avant de tirer",
    ["Enter the eye and come to the lens"] = "Entrer dans l'œil et approcher le cristallin",
    ["Go in through the main incision with irrigation on (pedal 1): the chamber deepens. Bring the tip to the "
        .. "front of the lens."] =
        "Entrez par l'incision principale, irrigation ouverte (pédale en 1) : la chambre s'approfondit. Amenez la "
            .. "pointe à l'avant du cristallin.",
    ["Take out the quarters"] = "Enlever les quadrants",
    ["Bury the tip with a touch of ultrasound, go back to pedal 2 and wait for the vacuum. Draw the piece to the "
        .. "middle and up, then pulse. When it clears, be at pedal 1 before the capsule comes."] =
        "Enfoncez la pointe avec un peu d'ultrasons, revenez en pédale 2 et attendez le vide. Amenez le fragment "
            .. "au centre et en haut, puis pulsez. Quand il passe, soyez en pédale 1 avant que la capsule n'arrive.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Pedal 1, tip over the lens, and out through the wound with irrigation on."] =
        "Pédale en 1, la pointe au-dessus du cristallin, et sortez par l'incision, irrigation ouverte.",
}
