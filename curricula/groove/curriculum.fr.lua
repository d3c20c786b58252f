-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Sculpting a groove"] = "Sculpture d'un sillon",
    ["The capsule is open and the nucleus turns freely. Sculpt one groove with the phaco tip: at least 4 mm long and "
        .. "so deep that the red reflex glows in it, without touching the posterior capsule or the iris and without "
        .. "pushing the lens."] =
        "La capsule est ouverte et le noyau tourne librement. Sculptez un sillon à la pointe de phaco : long d'au "
            .. "moins 4 mm et assez profond pour que la lueur pupillaire y rougeoie, sans toucher la capsule "
            .. "postérieure ni l'iris et sans pousser le cristallin.",
    ["Judge depth by the red reflex"] = "Juger la profondeur à la lueur pupillaire",
    ["Match speed and ultrasound power, so that the tip cuts and does not push"] =
        "Accorder vitesse et puissance des ultrasons, pour que la pointe coupe sans pousser",
    ["Ultrasound on the forward stroke only"] = "N'émettre d'ultrasons qu'en avançant",
    ["Enter the eye and come to the lens"] = "Entrer dans l'œil et approcher le cristallin",
    ["Go in through the incision with irrigation on (pedal 1), and bring the tip to the front of the lens, on your own "
        .. "side of its centre."] =
        "Entrez par l'incision, irrigation ouverte (pédale en 1), et amenez la pointe à l'avant du cristallin, en deçà "
            .. "de son centre, de votre côté.",
    ["Sculpt the groove"] = "Sculpter le sillon",
    ["Stroke away from yourself with ultrasound (pedal 3), come back without it. Take a thin layer each time. Stop "
        .. "when the groove glows red."] =
        "Passez en vous éloignant, avec ultrasons (pédale en 3), et revenez sans. Enlevez chaque fois une couche fine. "
            .. "Arrêtez quand le sillon rougeoie.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Back to pedal 1, lift the tip over the lens and draw it out through the incision."] =
        "Revenez en pédale 1, relevez la pointe au-dessus du cristallin et sortez-la par l'incision.",
    ["Groove too deep"] = "Sillon trop profond",
    ["The reflex in the groove is bright, and the plate at its floor feels soft."] =
        "La lueur est vive dans le sillon, et la lame qui en fait le fond paraît molle.",
    ["Too deep: let go to pedal 1 and lift the tip straight up. Go on elsewhere, not here."] =
        "Trop profond : revenez en pédale 1 et relevez la pointe tout droit. Continuez ailleurs, pas ici.",
    ["Pushing the lens"] = "Cristallin poussé",
    ["The whole lens moves away from the tip."] = "Tout le cristallin s'éloigne de la pointe.",
    ["You push more than you cut: stop, let the lens come back, then stroke more slowly or with more power."] =
        "Vous poussez plus que vous ne coupez : arrêtez, laissez revenir le cristallin, puis passez plus lentement ou "
            .. "avec plus de puissance.",
}
