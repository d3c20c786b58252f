-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["The main wound was cut too short and comes out too near to the iris. When the tip left under pressure, the iris "
        .. "came after it. Pushed back, it comes again, and worse. Let the pressure out through the side port, and "
        .. "stroke over the lip of the wound."] =
        "L'incision principale est trop courte et débouche trop près de l'iris. Quand la pointe est sortie sous "
            .. "pression, l'iris l'a suivie. Repoussé, il revient, et c'est pire. Faites tomber la pression par la "
            .. "contre-incision, et massez la lèvre de l'incision.",
    ["Know a prolapse by the pupil that peaks towards the wound, and push nothing back"] =
        "Reconnaître un prolapsus à la pupille étirée en pointe vers l'incision, et ne rien repousser",
    ["Lower the pressure through the side port by pressing on its lip"] =
        "Baisser la pression par la contre-incision, en appuyant sur sa lèvre",
    ["Stroke over the outer lip until the iris has slipped back"] =
        "Masser la lèvre externe jusqu'à ce que l'iris soit rentré",
    ["Let the pressure out"] = "Faire tomber la pression",
    ["Spatula into the side port, just through it. Press its lip aside until fluid runs out and the eye is soft. Leave "
        .. "the iris alone."] =
        "Spatule dans la contre-incision, juste au travers. Écartez la lèvre jusqu'à ce que du liquide s'écoule et que "
            .. "l'œil soit souple. Laissez l'iris tranquille.",
    ["Stroke the iris home"] = "Faire rentrer l'iris en massant",
    ["Out of the side port. Stroke over the outer lip of the main wound, to and fro, without going in."] =
        "Sortez de la contre-incision. Massez la lèvre externe de l'incision principale, en va-et-vient, sans entrer.",
    ["See that it stays"] = "Vérifier qu'il reste en place",
    ["Instruments away. The pupil is round again."] = "Instruments retirés. La pupille est de nouveau ronde.",
}
