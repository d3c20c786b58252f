-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: pages about stored attempts.

return {
    -- curve
    ["Learning curves of %s"] = "Courbes d'apprentissage de %s",
    ["Scores of all attempts"] = "Notes de tous les essais",
    ["pass"] = "réussite",
    [", passed"] = ", réussi",
    ["attempt"] = "essai",
    ["First %s %%, best %s %%."] = "Premier essai %s %%, meilleur %s %%.",
    ["The gate opened after %d attempts and %s of operating."] = "Passage acquis après %d essais et %s d'opération.",
    ["The gate is closed: it opens after %d passes in a row, of at least %s %% each."] =
        "Passage non acquis : il le sera après %d réussites de suite, d'au moins %s %% chacune.",
    ["Shares of the scale: 0 % if every item has its least points, 100 % if every one has its most. Filled: passed."] =
        "Parts de l'échelle : 0 % si chaque critère a le minimum, 100 % si chacun a le maximum. Plein : réussi.",
    ["Not clinically validated."] = "Non validé cliniquement.",

    -- form
    ["Rating %d of %d"] = "Évaluation %d sur %d",
    ["Watch the whole operation, then give each item of OSACSS 1 to 5 points. 2 and 4 lie between the "
        .. "descriptions. N/A: it was not to be seen, or is no part of this exercise. Save, and send the file to "
        .. "who gave you this form."] =
        "Regardez toute l'opération, puis donnez à chaque critère OSACSS 1 à 5 points. 2 et 4 sont entre les "
            .. "descriptions. S. o. : on ne pouvait pas le voir, ou ne fait pas partie de l'exercice. Enregistrez, "
            .. "et envoyez le fichier à qui vous a donné ce formulaire.",
    ["N/A"] = "S. o.",
    ["Comment"] = "Remarque",
    ["Comment on %s"] = "Remarque sur %s",
    ["Comment on the whole"] = "Remarque sur l'ensemble",
    ["On the whole"] = "Dans l'ensemble",
    ["Save answers"] = "Enregistrer les réponses",
    ["All that is open: N/A"] = "Tout le reste : s. o.",
    ["%d items left"] = "%d critères restants",
    ["All items answered"] = "Tous les critères ont une réponse",

    -- agreement
    ["Agreement of simulator and raters"] = "Accord entre simulateur et évaluateurs",
    ["%d rated attempts, %d raters: %s."] = "%d essais évalués, %d évaluateurs : %s.",
    ["Left out of the correlation among raters, because of too few ratings: %s."] =
        "Écarté de la corrélation entre évaluateurs, faute d'évaluations : %s.",
    ["ICC(2,1), ICC(2,k): two-way random effects, absolute agreement (Shrout and Fleiss 1979). Bias: simulator "
        .. "minus mean of the raters, with limits that hold 95 % of the differences if they are normal (Bland and "
        .. "Altman 1986). The scores of the simulator are not clinically validated."] =
        "ICC(2,1), ICC(2,k) : effets aléatoires à deux facteurs, accord absolu (Shrout et Fleiss 1979). Biais : "
            .. "simulateur moins moyenne des évaluateurs, avec les limites qui contiennent 95 % des différences si "
            .. "elles sont normales (Bland et Altman 1986). Les notes du simulateur ne sont pas validées "
            .. "cliniquement.",
    ["By item"] = "Par critère",
    ["Raters: ICC(2,1)"] = "Évaluateurs : ICC(2,1)",
    ["Simulator and raters: ICC(2,1)"] = "Simulateur et évaluateurs : ICC(2,1)",
    ["Bias"] = "Biais",
    ["95 % limits"] = "Limites à 95 %",
    ["Raters among themselves, total"] = "Évaluateurs entre eux, total",
    ["Raters"] = "Évaluateurs",
    ["Simulator minus raters"] = "Simulateur moins évaluateurs",
    ["Differences against means"] = "Différences selon les moyennes",
    ["mean of simulator and raters"] = "moyenne du simulateur et des évaluateurs",
    ["bias %s"] = "biais %s",
    ["%d of mean %s, difference %s"] = "%d de moyenne %s, différence %s",
    ["Total"] = "Total",
    ["nothing that both have scored"] = "rien que tous deux aient noté",
    ["only one attempt that both have scored"] = "un seul essai que tous deux aient noté",
    ["too few raters: two at least"] = "trop peu d'évaluateurs : deux au moins",
    ["too few judges"] = "trop peu de juges",
    ["the attempts do not differ"] = "les essais ne diffèrent pas",
    ["all scores are the same"] = "toutes les notes sont les mêmes",
}
