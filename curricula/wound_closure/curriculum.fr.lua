-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Closing the wounds"] = "Fermeture des incisions",
    ["The implant is in. Swell the lips of the wound with saline, bring the eye to 15 to 25 mmHg, then press on "
        .. "the lip with a sponge and look whether anything comes. If it does: hydrate, then suture, then test "
        .. "again."] =
        "L'implant est en place. Gonflez les lèvres de l'incision au sérum, amenez l'œil à 15 à 25 mmHg, puis "
            .. "appuyez sur la lèvre à l'éponge et regardez si quelque chose sort. Si oui : hydratez, puis "
            .. "suturez, puis essayez de nouveau.",
    ["Hydrate the stroma until it is white"] = "Hydrater le stroma jusqu'à ce qu'il soit blanc",
    ["Leave an eye of 15 to 25 mmHg"] = "Laisser un œil à 15 à 25 mmHg",
    ["Test every wound, and suture the one that leaks"] = "Essayer chaque incision, et suturer celle qui fuit",
    ["a short tunnel, which leaks"] = "un tunnel court, qui fuit",
    ["a burnt wound, which only stitches close"] = "une incision brûlée, que seuls des points ferment",
    ["Descemet's membrane hangs off at the inner lip"] = "la membrane de Descemet pend à la lèvre interne",
    ["Hydrate"] = "Hydrater",
    ["The end of the cannula into the stroma beside the tunnel; press until it is white."] =
        "L'extrémité de la canule dans le stroma à côté du tunnel ; injectez jusqu'à ce qu'il soit blanc.",
    ["Pressure"] = "Pression",
    ["The end into the chamber; fill it until it feels firm, 15 to 25 mmHg."] =
        "L'extrémité dans la chambre ; remplissez-la jusqu'à ce que l'œil soit ferme, 15 à 25 mmHg.",
    ["Test"] = "Essai",
    ["Press on the outer lip with the sponge. Nothing may come. If it does: hydrate, suture, test again."] =
        "Appuyez sur la lèvre externe à l'éponge. Rien ne doit sortir. Sinon : hydratez, suturez, essayez de "
            .. "nouveau.",
}
