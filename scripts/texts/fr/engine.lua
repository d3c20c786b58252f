-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: what the engine says, and the reasons that a rubric gives.

return {
    -- engine
    ["Step \"%s\" completed."] = "Étape « %s » accomplie.",
    ["Step \"%s\" not completed."] = "Étape « %s » non accomplie.",
    ["Error: %s."] = "Erreur : %s.",
    ["Put right after %.1f s: %s."] = "Corrigé après %.1f s : %s.",
    ["During step \"%s\"."] = "Pendant l'étape « %s ».",
    ["End of the exercise."] = "Fin de l'exercice.",
    ["Before the first step."] = "Avant la première étape.",
    ["Asked and declared"] = "Demandé et déclaré",
    ["At the end."] = "À la fin.",

    -- rubric: reasons
    ["a near miss, put right at once"] = "erreur évitée de justesse, corrigée aussitôt",
    ["put right"] = "corrigée",
    ["not put right in time"] = "non corrigée à temps",
    ["not put right yet"] = "pas encore corrigée",
    [" and once more"] = " et une fois de plus",
    [" and %d times more"] = " et %d fois de plus",
    ["%s at %.1f s%s, %s: at most %d point."] = "%s à %.1f s%s, %s : %d point au plus.",
    ["%s at %.1f s%s, %s: at most %d points."] = "%s à %.1f s%s, %s : %d points au plus.",
    ["%s at %s%s, %s: at most %s point."] = "%s à %s%s, %s : %s point au plus.",
    ["%s at %s%s, %s: at most %s points."] = "%s à %s%s, %s : %s points au plus.",
    ["%d points at %s"] = "%d points pour %s",
    ["%d at %s"] = "%d pour %s",
    ["%s to %s"] = "%s à %s",
    ["%s or %s"] = "%s ou %s",
    ["%s: %s (%s)"] = "%s : %s (%s)",
    ["All measures in the range for full points."] = "Toutes les mesures valent le maximum de points.",
    ["Not scored: "] = "Non noté : ",
    ["Begun (1: yes)"] = "Commencé (1 : oui)",
    ["What this item judges was not begun"] = "Ce que cet item juge n'a pas été commencé",
    ["Go on to it: what is not done earns the least."] = "Allez jusque-là : ce qui n'est pas fait rapporte le minimum.",
    ["the least level of the rubric: not achieved"] = "le niveau le plus bas de la grille : non atteint",
    ["nothing that this attempt showed tells of it."] = "rien dans cet essai ne permet d'en juger.",
    ["what it was operated with does not show it."] = "ce avec quoi on a opéré ne le montre pas.",
    ["needs teaching"] = "à former",
    ["supervised"] = "sous supervision",
    ["independent"] = "autonome",
}
