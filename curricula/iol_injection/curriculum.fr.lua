-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Injecting the implant"] = "Injection de l'implant",
    ["The bag is empty and filled with viscoelastic, the implant lies folded in its injector. Bring the "
        .. "tip before the opening, push the leading haptic into the bag, let the optic unfold, turn the "
        .. "trailing haptic in with the hook, and leave the implant in the middle."] =
        "Le sac est vide et rempli de viscoélastique, l'implant est plié dans son injecteur. Amenez la buse "
            .. "devant l'ouverture, poussez la première haptique dans le sac, laissez l'optique se déplier, faites "
            .. "entrer l'haptique arrière au crochet, et laissez l'implant centré.",
    ["Keep chamber and bag filled while the implant comes out"] =
        "Garder chambre et sac remplis pendant la sortie de l'implant",
    ["Lead the first haptic under the far rim before the optic leaves the nozzle"] =
        "Mener la première haptique sous le bord opposé avant que l'optique ne quitte la buse",
    ["Put back a haptic that came out before the rim, hand over hand"] =
        "Remettre, prise après prise, une haptique restée devant le bord",
    ["See an implant that lies upside down or with a haptic outside before you leave"] =
        "Voir avant de sortir un implant à l'envers ou une haptique hors du sac",
    ["See that chamber and bag are filled"] = "Vérifier que chambre et sac sont remplis",
    ["Where the chamber is shallow, fill it with the cannula."] =
        "Si la chambre est étroite, remplissez-la à la canule.",
    ["Bring the tip before the opening"] = "Amener la buse devant l'ouverture",
    ["Injector through the main incision, its mouth through the opening, under the rim."] =
        "L'injecteur par l'incision principale, sa buse à travers l'ouverture, sous le bord.",
    ["Push the leading haptic into the bag"] = "Pousser la première haptique dans le sac",
    ["Slowly: the leading haptic comes first. Point it down, under the far rim."] =
        "Lentement : la première haptique sort d'abord. Dirigez-la vers le bas, sous le bord opposé.",
    ["Release the optic"] = "Libérer l'optique",
    ["Push on evenly. When the optic is half out, draw the mouth back to the near edge, still under the rim."] =
        "Poussez régulièrement. L'optique à demi sortie, reculez la buse vers le bord proche, toujours sous "
            .. "le bord.",
    ["Turn the trailing haptic in"] = "Faire entrer l'haptique arrière",
    ["If a haptic lies before the rim: lens forceps. Draw its arm in by its middle, then by its elbow "
        .. "until all of it is within the rim; press it down, and lead it back behind the rim."] =
        "Si une haptique reste devant le bord : pince à implant. Tirez le bras vers l'intérieur par son "
            .. "milieu, puis par son coude, jusqu'à ce qu'il soit tout entier en dedans du bord ; abaissez-le, et "
            .. "menez-le derrière le bord.",
    ["Centre the implant"] = "Centrer l'implant",
    ["Push the optic to the middle, let go, and look whether it stays there."] =
        "Poussez l'optique au centre, lâchez, et voyez si elle y reste.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Off the implant, straight up, and out through the wound."] =
        "Quittez l'implant, montez tout droit, et sortez par l'incision.",
    ["Injected without viscoelastic"] = "Injection sans viscoélastique",
    ["The chamber is shallow, the bag lies flat, and the implant comes near to the cornea."] =
        "La chambre est étroite, le sac est plat, et l'implant approche de la cornée.",
    ["Stop pushing, and fill bag and chamber before the implant comes out."] =
        "Cessez de pousser, et remplissez sac et chambre avant que l'implant ne sorte.",
    ["Implant jammed"] = "Implant bloqué",
    ["The plunger goes no farther, the nozzle widens."] = "Le piston n'avance plus, la buse s'élargit.",
    ["The implant is jammed: stop pushing, draw the plunger back a little, and take a wider cartridge."] =
        "L'implant est bloqué : cessez de pousser, reculez un peu le piston, et prenez une cartouche plus "
            .. "large.",
    ["Upside down"] = "À l'envers",
    ["Seen from the front the haptics leave the optic clockwise, like an S."] =
        "Vues de face, les haptiques quittent l'optique dans le sens horaire, comme un S.",
    ["The implant is upside down: turn it over under viscoelastic, without stretching the rim, or take it out."] =
        "L'implant est à l'envers : retournez-le sous viscoélastique, sans étirer le bord, ou retirez-le.",
    ["Haptic not in the bag"] = "Haptique hors du sac",
    ["A haptic lies in front of the rim, the optic is off the middle."] =
        "Une haptique est devant le bord, l'optique est décentrée.",
    ["A haptic is not in the bag: go back with lens forceps. Draw its arm into the opening hand over hand, "
        .. "until its elbow is within the rim, press it down, and lead it back behind the rim."] =
        "Une haptique n'est pas dans le sac : revenez avec la pince à implant. Tirez son bras dans "
            .. "l'ouverture, prise après prise, jusqu'à ce que son coude soit en dedans du bord, abaissez-le, et "
            .. "menez-le derrière le bord.",
    ["Haptic stuck to the optic"] = "Haptique collée à l'optique",
    ["A haptic stays folded on the optic, which is tilted."] =
        "Une haptique reste pliée sur l'optique, qui est inclinée.",
    ["The haptic sticks to the optic: take its arm with lens forceps, lift it off, and lead it behind the rim."] =
        "L'haptique colle à l'optique : prenez son bras à la pince à implant, décollez-le, et menez-le "
            .. "derrière le bord.",
    ["Rim overstretched"] = "Bord trop étiré",
    ["The edge of the opening is drawn out to an oval."] = "Le bord de l'ouverture s'étire en ovale.",
    ["You pull on the rim: let go, and come under it from the middle."] =
        "Vous tirez sur le bord : lâchez, et passez dessous en venant du centre.",
    ["Rim split"] = "Bord fendu",
    ["A notch in the edge of the opening, the optic tilts."] =
        "Une encoche dans le bord de l'ouverture, l'optique s'incline.",
    ["The rim has split: stop turning, take the load off it, and leave the haptics across the split."] =
        "Le bord est fendu : cessez de tourner, déchargez-le, et laissez les haptiques perpendiculaires à la "
            .. "fente.",
    ["Posterior capsule struck"] = "Capsule postérieure heurtée",
    ["Folds run from the end of the instrument across the back of the bag."] =
        "Des plis partent du bout de l'instrument sur le fond du sac.",
    ["You press on the posterior capsule: lift the instrument at once."] =
        "Vous appuyez sur la capsule postérieure : relevez aussitôt l'instrument.",
    ["A haptic or the optic shows at the back of the cornea."] =
        "Une haptique ou l'optique apparaît contre la face postérieure de la cornée.",
    ["Too high: lead the implant down, through the opening, before more of it unfolds."] =
        "Trop haut : menez l'implant vers le bas, à travers l'ouverture, avant qu'il ne se déplie davantage.",
}
