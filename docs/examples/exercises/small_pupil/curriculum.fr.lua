-- SPDX-License-Identifier: GPL-3.0-or-later
return {
    ["Rhexis in a small pupil"] = "Rhexis dans une petite pupille",
    ["Keep the tear inside the pupil"] = "Garder la déchirure dans la pupille",
    ["Stain when the red reflex is lost"] = "Colorer quand la lueur pupillaire est perdue",
    ["Pierce the capsule"] = "Percer la capsule",
    ["No red reflex: the capsule is stained with trypan blue. Pierce it near the middle."] =
        "Pas de lueur pupillaire : la capsule est colorée au bleu trypan. Percez-la près du centre.",
    ["Tear round"] = "Déchirer en rond",
    ["What you tear must stay in the pupil: grasp close to the tip of the tear, pull inwards."] =
        "La déchirure doit rester dans la pupille : saisissez près de sa pointe, tirez vers le centre.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Tear under the iris"] = "Déchirure sous l'iris",
    ["The tip of the tear cannot be seen any more."] = "La pointe de la déchirure ne se voit plus.",
    ["Iris touched"] = "Iris touché",
    ["Draw the tip back to the middle of the pupil."] = "Ramenez la pointe au milieu de la pupille.",
    ["Tip out of sight"] = "Pointe hors de vue",
    ["Work where you can see."] = "Travaillez là où vous voyez.",
    ["A white cataract, a pupil of 5 mm: a round opening that stays inside what can be seen."] =
        "Cataracte blanche, pupille de 5 mm : une ouverture ronde qui reste dans ce qui se voit.",
    ["Stop. Fill with viscoelastic, let go, grasp close to the tip, pull to the middle."] =
        "Arrêtez. Remplissez de viscoélastique, lâchez, saisissez près de la pointe, tirez vers le centre.",
    ["pupil of 6 mm"] = "pupille de 6 mm",
    ["pupil of 4.5 mm, smaller opening"] = "pupille de 4,5 mm, ouverture plus petite",
}
