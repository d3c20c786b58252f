-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Removal of viscoelastic"] = "Ablation du viscoélastique",
    ["The implant lies in the bag amid viscoelastic. What is in front comes to the tip and is washed out; what "
        .. "lies behind the optic stays unless the tip goes there or rocks the optic. What is left raises the "
        .. "pressure in the days after."] =
        "L'implant repose dans le sac au milieu du viscoélastique. Ce qui est devant vient à la pointe et s'évacue "
            .. "; ce qui est derrière l'optique reste, à moins que la pointe n'y aille ou ne fasse basculer "
            .. "l'optique. Ce qui reste élève la pression les jours suivants.",
    ["Aspirate in front of the implant and round the angle"] = "Aspirer devant l'implant et tout autour de l'angle",
    ["Aspirate behind the optic, or rock it, until it lies still"] =
        "Aspirer derrière l'optique, ou la faire basculer, jusqu'à ce qu'elle repose immobile",
    ["Keep the posterior capsule out of the mouth"] = "Garder la capsule postérieure hors de l'orifice",
    ["In front of the implant"] = "Devant l'implant",
    ["Tip over the optic, mouth up, pedal 2."] = "La pointe au-dessus de l'optique, orifice en haut, pédale en 2.",
    ["Behind the implant"] = "Derrière l'implant",
    ["Past the edge of the optic, the mouth up, and aspirate there; or press its edge to rock it."] =
        "Au-delà du bord de l'optique, orifice en haut, et aspirez là ; ou appuyez sur son bord pour la faire "
            .. "basculer.",
    ["Come out"] = "Sortir",
    ["Straight out through the incision, irrigation on."] = "Tout droit par l'incision, irrigation ouverte.",
}
