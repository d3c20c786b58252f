-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Sculpting a cross"] = "Sculpture d'une croix",
    ["The capsule is open and the nucleus turns freely. Sculpt a groove, turn the nucleus by a quarter with the second "
        .. "instrument, and sculpt another groove across the first: each at least 4 mm long and so deep that the red "
        .. "reflex glows in it, without touching posterior capsule or iris and without pushing the lens."] =
        "La capsule est ouverte et le noyau tourne librement. Sculptez un sillon, tournez le noyau d'un quart de tour "
            .. "au second instrument, et sculptez un autre sillon en travers du premier : chacun long d'au moins 4 mm "
            .. "et assez profond pour que la lueur pupillaire y rougeoie, sans toucher la capsule postérieure ni "
            .. "l'iris et sans pousser le cristallin.",
    ["Judge depth by the red reflex"] = "Juger la profondeur à la lueur pupillaire",
    ["Turn the nucleus by its groove, with little load on the zonules"] =
        "Tourner le noyau par son sillon, en chargeant peu la zonule",
    ["Work with two instruments through two wounds"] = "Travailler à deux instruments par deux incisions",
    ["Enter the eye and come to the lens"] = "Entrer dans l'œil et approcher le cristallin",
    ["Go in through the main incision with irrigation on (pedal 1), and bring the tip to the front of the lens, on "
        .. "your own side of its centre."] =
        "Entrez par l'incision principale, irrigation ouverte (pédale en 1), et amenez la pointe à l'avant du "
            .. "cristallin, en deçà de son centre, de votre côté.",
    ["Sculpt the first groove"] = "Sculpter le premier sillon",
    ["Stroke away from yourself with ultrasound (pedal 3), come back without it. Take a thin layer each time. Stop "
        .. "when the groove glows red."] =
        "Passez en vous éloignant, avec ultrasons (pédale en 3), et revenez sans. Enlevez chaque fois une couche fine. "
            .. "Arrêtez quand le sillon rougeoie.",
    ["Turn the nucleus by a quarter"] = "Tourner le noyau d'un quart de tour",
    ["Back to pedal 1. Bring the spatula in through the side port, put its end into the groove near the far end, and "
        .. "push the wall sideways along an arc: the lens must turn, not shift."] =
        "Revenez en pédale 1. Introduisez la spatule par la contre-incision, mettez-en l'extrémité dans le sillon près "
            .. "du bout éloigné, et poussez la paroi de côté suivant un arc : le cristallin doit tourner, sans se "
            .. "déplacer.",
    ["Sculpt the second groove"] = "Sculpter le second sillon",
    ["The same again. In the middle, where the first groove is, nothing is left to sculpt: keep the tip from dropping "
        .. "in."] =
        "De même. Au milieu, où passe le premier sillon, il ne reste rien à sculpter : empêchez la pointe d'y tomber.",
    ["Look at the depth"] = "Contrôler la profondeur",
    ["Pedal 1, tip over the lens, and look for two seconds: both grooves glow evenly from end to end, or you go back "
        .. "to the one that does not."] =
        "Pédale en 1, la pointe au-dessus du cristallin, et regardez deux secondes : les deux sillons luisent "
            .. "uniformément d'un bout à l'autre, sinon revenez à celui qui reste terne.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Pedal 1, tips over the lens, and out through the wounds."] =
        "Pédale en 1, les pointes au-dessus du cristallin, et sortez par les incisions.",
    ["Groove too deep"] = "Sillon trop profond",
    ["The reflex in the groove is bright, and the plate at its floor feels soft."] =
        "La lueur est vive dans le sillon, et la lame qui en fait le fond paraît molle.",
    ["Too deep: let go to pedal 1 and lift the tip straight out of the groove, well over the lens. Look before you go "
        .. "on, and go on elsewhere."] =
        "Trop profond : revenez en pédale 1 et sortez la pointe tout droit du sillon, bien au-dessus du cristallin. "
            .. "Regardez avant de continuer, et continuez ailleurs.",
    ["Groove too shallow"] = "Sillon trop peu profond",
    ["The groove is dull where it ought to glow: the reflex hardly shines through its floor."] =
        "Le sillon est terne là où il devrait luire : la lueur traverse à peine le fond.",
    ["You come to turn the nucleus before the groove is deep enough: take the spatula away and deepen it, in thin "
        .. "layers, until the reflex glows."] =
        "Vous venez tourner le noyau avant que le sillon ne soit assez profond : retirez la spatule et "
            .. "approfondissez-le, en couches fines, jusqu'à ce que la lueur rougeoie.",
    ["Groove askew"] = "Sillon oblique",
    ["The second groove does not cross the first at a right angle: one quarter becomes wide, the next narrow."] =
        "Le second sillon ne croise pas le premier à angle droit : un quadrant devient large, le suivant étroit.",
    ["The grooves are not across each other: lift the tip, turn the nucleus until the first groove lies across, and "
        .. "sculpt there."] =
        "Les sillons ne se croisent pas à angle droit : relevez la pointe, tournez le noyau jusqu'à ce que le premier "
            .. "sillon soit en travers, et sculptez là.",
    ["The whole lens moves away from the instrument."] = "Tout le cristallin s'éloigne de l'instrument.",
    ["You push more than you cut or turn: stop, lift the tip out of the lens and let it come back; then more slowly, "
        .. "or with more power."] =
        "Vous poussez plus que vous ne coupez ou ne tournez : arrêtez, sortez la pointe du cristallin et laissez-le "
            .. "revenir ; puis plus lentement, ou avec plus de puissance.",
    ["The edge of the pupil shows the rim of the bag, the reflex becomes uneven."] =
        "Le bord du sac apparaît derrière celui de la pupille, la lueur devient inégale.",
    ["The zonules carry the load: take the instruments off the lens. Push along the groove's wall at a right angle to "
        .. "it, and not down."] =
        "La zonule porte la charge : retirez les instruments du cristallin. Poussez la paroi du sillon "
            .. "perpendiculairement à elle, et pas vers le bas.",
    ["Spatula on the capsule"] = "Spatule sur la capsule",
    ["The edge of the capsulorhexis dents, or folds run from the instrument."] =
        "Le bord du capsulorhexis se déforme, ou des plis partent de l'instrument.",
    ["The spatula presses on the capsule: stop, and lift it straight up. Work inside the opening of the capsule."] =
        "La spatule appuie sur la capsule : arrêtez, et relevez-la tout droit. Travaillez en dedans de l'ouverture "
            .. "capsulaire.",
    ["Iris touched: stop, lift the tip over the lens to the middle of the pupil, and look at the shaft."] =
        "Iris touché : arrêtez, relevez la pointe au-dessus du cristallin, au milieu de la pupille, et regardez la "
            .. "tige.",
}
