-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Cracking the nucleus"] = "Fracture du noyau",
    ["A groove runs through the firm nucleus, four fifths of its thickness deep. Bring both instruments to its floor, "
        .. "part its walls, and go on near each of its ends until the nucleus is in two halves."] =
        "Un sillon parcourt le noyau ferme, profond des quatre cinquièmes de son épaisseur. Amenez les deux "
            .. "instruments au fond, écartez-en les parois, et poursuivez près de chacun de ses bouts jusqu'à ce que "
            .. "le noyau soit en deux moitiés.",
    ["Place both tips in the lower third of the groove before parting"] =
        "Placer les deux pointes dans le tiers inférieur du sillon avant d'écarter",
    ["Part the walls by equal and opposite movements, so that the nucleus splits and is not pushed"] =
        "Écarter les parois par des gestes égaux et opposés, pour que le noyau se fende sans être poussé",
    ["Look whether the split is complete, and go back where it is not"] =
        "Vérifier que la fracture est complète, et revenir là où elle ne l'est pas",
    ["Enter the eye with both instruments"] = "Entrer dans l'œil avec les deux instruments",
    ["Irrigation on (pedal 1). Phaco tip through the main incision, spatula through the side port, both over the "
        .. "groove."] =
        "Irrigation ouverte (pédale en 1). La pointe de phaco par l'incision principale, la spatule par la "
            .. "contre-incision, toutes deux au-dessus du sillon.",
    ["Both tips into the lower third of the groove"] = "Amener les deux pointes dans le tiers inférieur du sillon",
    ["Side by side, down to the floor of the groove, near one of its ends. The higher the tips, the less they open the "
        .. "floor."] =
        "Côte à côte, jusqu'au fond du sillon, près d'un de ses bouts. Plus les pointes sont hautes, moins elles "
            .. "ouvrent le fond.",
    ["Part the walls until the nucleus splits"] = "Écarter les parois jusqu'à ce que le noyau se fende",
    ["Move the tips apart, evenly and slowly, and watch the floor: the split runs ahead of the tips. Close, lift, and "
        .. "part again near the other end."] =
        "Écartez les pointes, régulièrement et lentement, et regardez le fond : la fracture court devant les pointes. "
            .. "Rapprochez, relevez, et écartez de nouveau près de l'autre bout.",
    ["Look whether the split is complete"] = "Vérifier que la fracture est complète",
    ["Both tips over the lens, pedal 1, two seconds: does the red reflex shine through from end to end?"] =
        "Les deux pointes au-dessus du cristallin, pédale en 1, deux secondes : la lueur pupillaire passe-t-elle d'un "
            .. "bout à l'autre ?",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Pedal 1, tips over the lens, and out through the wounds."] =
        "Pédale en 1, les pointes au-dessus du cristallin, et sortez par les incisions.",
}
