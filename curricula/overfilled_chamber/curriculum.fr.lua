-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Overfilled chamber"] = "Chambre trop remplie",
    ["Too much viscoelastic was pressed into the chamber: the eye is hard, and the iris bulges towards the "
        .. "wounds. Let some out past the lip of the side port until the eye is soft."] =
        "Trop de viscoélastique a été injecté : l'œil est dur, et l'iris bombe vers les incisions. Laissez-en sortir "
            .. "par la lèvre de la contre-incision jusqu'à ce que l'œil soit souple.",
    ["Feel that an eye is too hard before anything is cut"] =
        "Sentir qu'un œil est trop dur avant de couper quoi que ce soit",
    ["Let viscoelastic out by pressing on the lip of a wound, a little at a time"] =
        "Laisser sortir le viscoélastique en appuyant sur la lèvre d'une incision, petit à petit",
    ["Leave the chamber full: what comes out by itself at a low pressure is little"] =
        "Laisser la chambre pleine : à basse pression, il en sort peu spontanément",
    ["pressure to which the eye must be let down"] = "pression à laquelle l'œil doit être ramené",
    ["Let the pressure out"] = "Faire tomber la pression",
    ["Spatula into the side port, just through it. Press its lip aside, let go, and look: viscoelastic comes while "
        .. "the lip stands open."] =
        "Spatule dans la contre-incision, juste au travers. Écartez la lèvre, relâchez, et regardez : le "
            .. "viscoélastique sort tant que la lèvre est ouverte.",
    ["Leave the eye soft"] = "Laisser l'œil souple",
    ["Back to the middle of the wound, and out."] = "Retour au milieu de l'incision, et dehors.",
}
