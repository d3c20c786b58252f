-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Ultrasound without flow"] = "Ultrasons sans flux",
    ["Viscoelastic has set in the tip, and the wound lies tight around the sleeve: nothing flows, and what does not "
        .. "flow does not cool. Find it out before ultrasound burns the wound, come out, have the tip cleared, and go "
        .. "on."] =
        "Du viscoélastique s'est figé dans la pointe, et l'incision serre le manchon : rien ne coule, et ce qui ne "
            .. "coule pas ne refroidit pas. Découvrez-le avant que les ultrasons ne brûlent l'incision, sortez, faites "
            .. "déboucher la pointe, et continuez.",
    ["Try the flow in pedal position 2 before every first ultrasound"] =
        "Essayer le flux en position 2 de la pédale avant toute première émission d'ultrasons",
    ["Know a blocked tip by the panel and by the milky cloud, and let go of ultrasound at once"] =
        "Reconnaître une pointe bouchée à l'écran et au nuage laiteux, et arrêter aussitôt les ultrasons",
    ["Have the tip cleared outside of the eye, and see that it flows before going on"] =
        "Faire déboucher la pointe hors de l'œil, et vérifier que le liquide coule avant de continuer",
    ["the line of the infusion is kinked instead"] = "c'est la tubulure d'irrigation qui est coudée",
    ["Enter the eye and come to the lens"] = "Entrer dans l'œil et approcher le cristallin",
    ["In through the main incision with irrigation on (pedal 1). Then pedal 2: look whether the panel shows flow."] =
        "Entrez par l'incision principale, irrigation ouverte (pédale en 1). Puis pédale en 2 : voyez si l'écran "
            .. "indique un débit.",
    ["Find out that nothing flows"] = "Découvrir que rien ne coule",
    ["The panel shows no flow in pedal position 2: no ultrasound. Pedal up, and out of the eye."] =
        "L'écran n'indique aucun débit en position 2 de la pédale : pas d'ultrasons. Lâchez la pédale, et sortez de "
            .. "l'œil.",
    ["Tip and line are cleared"] = "Pointe et tubulure débouchées",
    ["Sculpt with flow"] = "Sculpter avec flux",
    ["In again, pedal 2 first: the panel shows flow. Then ultrasound."] =
        "Rentrez, pédale en 2 d'abord : l'écran indique un débit. Ensuite les ultrasons.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Pedal 1, tip over the lens, and out through the wound."] =
        "Pédale en 1, la pointe au-dessus du cristallin, et sortez par l'incision.",
}
