-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Incision and side port"] = "Incision et contre-incision",
    ["Nothing is cut yet. Cut the side port for the other hand, then the main incision: in two planes, about as "
        .. "long as it is wide, so that the pressure of the eye shuts it. What is wrong now goes wrong for the "
        .. "whole operation."] =
        "Rien n'est encore incisé. Faites la contre-incision pour l'autre main, puis l'incision principale : en "
            .. "deux plans, à peu près aussi longue que large, pour que la pression de l'œil la ferme. Ce qui est "
            .. "mal fait ici se paie toute l'opération.",
    ["Cut a side port 60 to 100 degrees from the main incision"] =
        "Faire une contre-incision à 60 à 100 degrés de l'incision principale",
    ["Cut a tunnel of 2 mm in two planes, as wide as the blade"] =
        "Faire un tunnel de 2 mm en deux plans, large comme la lame",
    ["Know a bad tunnel, and close or leave it"] = "Reconnaître un mauvais tunnel, et le fermer ou le laisser",
    ["Side port"] = "Contre-incision",
    ["Small blade, to the side of the hand that it is for. Straight through the cornea, level with the iris."] =
        "La petite lame, du côté de la main à qui elle servira. Tout droit à travers la cornée, parallèlement à "
            .. "l'iris.",
    ["Main incision"] = "Incision principale",
    ["Keratome at the limbus: first within the cornea along its slope, then level, until the shoulders of the "
        .. "blade are through. Straight back, without moving sideways."] =
        "Le kératome au limbe : d'abord dans la cornée le long de sa pente, puis à plat, jusqu'à ce que les épaules "
            .. "de la lame soient passées. Tout droit en arrière, sans mouvement de côté.",
    ["Is it tight?"] = "Est-ce étanche ?",
    ["Everything out. Is there fluid at the lip? Then hydrate or suture it."] =
        "Tout dehors. Du liquide à la lèvre ? Alors hydratez ou suturez.",
}
