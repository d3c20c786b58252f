-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Irrigation and aspiration of cortex"] = "Irrigation-aspiration du cortex",
    ["The nucleus has left the bag, and cortex hangs in grey-white tags all round, from fornix to back. The tip "
        .. "holds a tag in the fornix, draws it towards the middle so that it comes off the capsule, and aspirates "
        .. "it there. A mouth that looks down takes the posterior capsule instead."] =
        "Le noyau a quitté le sac, et le cortex pend en lambeaux gris-blanc sur tout le tour, du cul-de-sac au "
            .. "fond. La pointe saisit un lambeau dans le cul-de-sac, le tire vers le centre pour le détacher de "
            .. "la capsule, et l'y aspire. Un orifice qui regarde en bas prend la capsule postérieure à la place.",
    ["Hold cortex in the fornix with the mouth up, and strip it along the capsule"] =
        "Saisir le cortex dans le cul-de-sac, orifice en haut, et le détacher le long de la capsule",
    ["Go all round until next to none is left"] = "Faire tout le tour jusqu'à ce qu'il n'en reste presque rien",
    ["Let go of a posterior capsule that was drawn in, before it tears"] =
        "Relâcher une capsule postérieure aspirée, avant qu'elle ne se déchire",
    ["Go in"] = "Entrer",
    ["Irrigation on (pedal 1), the mouth up, and through the incision to the middle of the bag."] =
        "Irrigation ouverte (pédale en 1), l'orifice en haut, et par l'incision jusqu'au milieu du sac.",
    ["Strip and aspirate"] = "Détacher et aspirer",
    ["Under the rim to the fornix, pedal 2, and when the tag is held, draw it to the middle. Go round."] =
        "Sous le bord jusqu'au cul-de-sac, pédale en 2, et le lambeau tenu, tirez-le vers le centre. Faites le "
            .. "tour.",
    ["Come out"] = "Sortir",
    ["Straight out through the incision, irrigation on."] = "Tout droit par l'incision, irrigation ouverte.",
}
