-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: pages about stored attempts.

return {
    -- curve
    ["Learning curves of %s"] = "Courbes d'apprentissage de %s",
    ["Scores of all attempts"] = "Notes de tous les essais",
    ["pass mark"] = "seuil de réussite",
    ["the gate opened"] = "passage acquis",
    ["not completed"] = "non terminé",
    ["below the pass mark"] = "sous le seuil",
    ["a critical error was not put right"] = "une erreur critique n'a pas été corrigée",
    ["with aids"] = "avec des aides",
    ["it began at a later moment"] = "commencé à un moment ultérieur",
    ["in another mode than the gate asks for"] = "dans un autre mode que celui qui est demandé",
    ["an error of the exercise's script ended it"] = "interrompu par une erreur du script de l'exercice",
    ["%s: %s %%, %s"] = "%s : %s %%, %s",
    [", passed"] = ", réussi",
    ["%d of %d passes in a row"] = "réussites de suite : %d sur %d",
    ["closed until these are passed: %s"] = "fermé jusqu'à la réussite de : %s",
    ["✓ passed, ○ open, – closed; under it, attempts and the best score. The framed lesson comes next."] =
        "✓ réussi, ○ ouvert, – fermé ; au-dessous, le nombre d'essais et la meilleure note. La leçon encadrée vient "
            .. "ensuite.",
    ["Nothing is stored yet."] = "Rien n'est enregistré pour l'instant.",
    ["Cataract surgery, from the first touch to the whole operation"] =
        "Chirurgie de la cataracte, du premier geste à l'opération entière",
    ["attempt"] = "essai",
    ["First %s %%, best %s %%."] = "Premier essai %s %%, meilleur %s %%.",
    ["First %s %%, none completed yet."] = "Premier essai %s %%, aucun terminé pour l'instant.",
    ["The gate opened after %d attempt and %s of operating."] = "Passage acquis après %d essai et %s d'opération.",
    ["The gate opened after %d attempts and %s of operating."] = "Passage acquis après %d essais et %s d'opération.",
    ["The gate is closed: it opens after %d pass, of at least %s %%."] =
        "Passage non acquis : il le sera après %d réussite, d'au moins %s %%.",
    ["The gate is closed: it opens after %d passes in a row, of at least %s %% each."] =
        "Passage non acquis : il le sera après %d réussites de suite, d'au moins %s %% chacune.",
    ["Shares of the scale: 0 % if every item has its least points, 100 % if every one has its most."] =
        "Parts de l'échelle : 0 % si chaque critère a le minimum, 100 % si chacun a le maximum.",
    ["Not clinically validated."] = "Non validé cliniquement.",

    -- form
    ["Rating %d of %d"] = "Évaluation %d sur %d",
    ["Watch the replay of this exercise to its end."] = "Regardez l'enregistrement de cet exercice jusqu'à la fin.",
    ["Watch all parts of the operation, one after the other."] =
        "Regardez toutes les parties de l'opération, l'une après l'autre.",
    ["Give each item of OSACSS 1 to 5 points. 2 and 4 lie between the descriptions. N/A: it was not to be seen, "
        .. "or is no part of what you watched."] =
        "Donnez à chaque critère OSACSS 1 à 5 points. 2 et 4 sont entre les descriptions. S.\u{A0}o. : on ne pouvait "
            .. "pas le voir, ou il ne fait pas partie de ce que vous avez regardé.",
    ["Items that this exercise does not judge (%d, set to N/A): open them where you have something to say."] =
        "Critères que cet exercice ne juge pas (%d, mis à s.\u{A0}o.) : ouvrez-les si vous avez un avis.",
    ["Save, and send the file to who gave you this form."] =
        "Enregistrez, et envoyez le fichier à qui vous a donné ce formulaire.",
    ["If the video does not play here, open %s, which lies beside this page, in any player."] =
        "Si la vidéo ne se lit pas ici, ouvrez %s, à côté de cette page, dans un lecteur.",
    ["Part %d of %d"] = "Partie %d sur %d",
    ["N/A"] = "S.\u{A0}o.",
    ["Comment"] = "Remarque",
    ["Comment on %s"] = "Remarque sur %s",
    ["Comment on the whole"] = "Remarque sur l'ensemble",
    ["On the whole"] = "Dans l'ensemble",
    ["Save answers"] = "Enregistrer les réponses",
    ["All that is open: N/A"] = "Tout le reste : s.\u{A0}o.",
    ["1 item left"] = "1 critère restant",
    ["%d items left"] = "%d critères restants",
    ["All items answered"] = "Tous les critères ont une réponse",

    -- agreement
    ["Agreement of simulator and raters"] = "Accord entre simulateur et évaluateurs",
    ["%d rated attempt"] = "%d essai évalué",
    ["%d rated attempts"] = "%d essais évalués",
    ["%d rater: %s."] = "%d évaluateur : %s.",
    ["%d raters: %s."] = "%d évaluateurs : %s.",
    ["Left out of the correlation among raters, because of too few ratings: %s."] =
        "Hors de la corrélation entre évaluateurs, faute d'évaluations : %s.",
    ["ICC(2,1), ICC(2,k): two-way random effects, absolute agreement (Shrout and Fleiss 1979). Bias: simulator "
        .. "minus mean of the raters, with limits that hold 95 % of the differences if they are normal (Bland and "
        .. "Altman 1986). The scores of the simulator are not clinically validated."] =
        "ICC(2,1), ICC(2,k) : effets aléatoires à deux facteurs, accord absolu (Shrout et Fleiss 1979). Biais : "
            .. "simulateur moins moyenne des évaluateurs, avec les limites qui contiennent 95 % des différences si "
            .. "elles sont normales (Bland et Altman 1986). Les notes du simulateur ne sont pas validées "
            .. "cliniquement.",
    ["By item"] = "Par critère",
    ["By exercise"] = "Par exercice",
    ["Points: 1 to 5 of an item, 20 to 100 of the total."] = "Points : 1 à 5 par critère, 20 à 100 pour le total.",
    ["Bias, points"] = "Biais, points",
    ["95 % limits, points"] = "Limites à 95 %, points",
    ["mean of simulator and raters [points]"] = "moyenne du simulateur et des évaluateurs [points]",
    ["difference [points]"] = "différence [points]",
    ["Attempts"] = "Essais",
    ["Raters: ICC(2,1)"] = "Évaluateurs : ICC(2,1)",
    ["Simulator and raters: ICC(2,1)"] = "Simulateur et évaluateurs : ICC(2,1)",
    ["Raters among themselves, total"] = "Évaluateurs entre eux, total",
    ["Raters"] = "Évaluateurs",
    ["Simulator minus raters"] = "Simulateur moins évaluateurs",
    ["Differences against means"] = "Différences selon les moyennes",
    ["+1.96 SD %s"] = "+1,96 ET %s",
    ["−1.96 SD %s"] = "−1,96 ET %s",
    ["bias %s"] = "biais %s",
    ["%d of mean %s, difference %s"] = "%d de moyenne %s, différence %s",
    ["total"] = "total",
    ["Mean points per item × 20"] = "Moyenne des points par critère × 20",
    ["nothing that both have scored"] = "rien que tous deux aient noté",
    ["only one attempt that both have scored"] = "un seul essai que tous deux aient noté",
    ["nothing that all have scored"] = "rien que tous aient noté",
    ["only one attempt that all have scored"] = "un seul essai que tous aient noté",
    ["too few raters: two at least"] = "trop peu d'évaluateurs : deux au moins",
    ["too few judges"] = "trop peu de juges",
    ["the attempts do not differ"] = "les essais ne diffèrent pas",
    ["all scores are the same"] = "toutes les notes sont les mêmes",
}
