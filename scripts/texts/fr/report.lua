-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: the report of an attempt.

return {
    -- report: head
    ["rhexis: report of an exercise"] = "rhexis : compte rendu d'un exercice",
    ["Exercise"] = "Exercice",
    ["virtual surgeon of group A (fewer than 50 operations)"] =
        "chirurgien virtuel du groupe A (moins de 50 opérations)",
    ["virtual surgeon of group B"] = "chirurgien virtuel du groupe B",
    ["virtual surgeon of group C"] = "chirurgien virtuel du groupe C",
    ["virtual surgeon of group D (over 500 operations)"] = "chirurgien virtuel du groupe D (plus de 500 opérations)",
    ["virtual novice (fewer than 50 operations)"] = "débutant virtuel (moins de 50 opérations)",
    ["virtual expert (over 500 operations)"] = "expert virtuel (plus de 500 opérations)",
    ["trainee"] = "interne",
    ["%s years"] = "%s ans",
    ["nuclear cataract NO%s"] = "cataracte nucléaire NO%s",
    ["white cortex"] = "cortex blanc",
    ["hazy cortex"] = "cortex voilé",
    ["pupil %s mm"] = "pupille de %s mm",
    ["right eye"] = "œil droit",
    ["left eye"] = "œil gauche",
    ["%s, at %s degrees; the nose lies %s, above lies %s"] = "%s, à %s degrés ; nez %s, haut %s",
    ["surgeon right-handed"] = "chirurgien droitier",
    ["surgeon left-handed"] = "chirurgien gaucher",
    ["nasal"] = "nasale",
    ["upper nasal"] = "nasale supérieure",
    ["above"] = "supérieure",
    ["upper temporal"] = "temporale supérieure",
    ["temporal"] = "temporale",
    ["lower temporal"] = "temporale inférieure",
    ["below"] = "inférieure",
    ["lower nasal"] = "nasale inférieure",
    ["to the right"] = "à droite",
    ["away, to the right"] = "au loin à droite",
    ["away"] = "au loin",
    ["away, to the left"] = "au loin à gauche",
    ["to the left"] = "à gauche",
    ["near, to the left"] = "près de lui à gauche",
    ["near"] = "près de lui",
    ["near, to the right"] = "près de lui à droite",
    ["teaching (hints and advice said)"] = "apprentissage (avec conseils)",
    ["exam (no hints)"] = "examen (sans conseils)",
    ["Objectives:"] = "Objectifs :",
    ["By"] = "Par",
    ["Patient"] = "Patient",
    ["Incision"] = "Incision",
    ["Level"] = "Niveau",
    ["Mode"] = "Mode",
    ["Time"] = "Durée",
    ["not scored"] = "non noté",
    ["of %s"] = "sur %s",
    ["not completed"] = "non accompli",

    -- report: in short
    ["In short"] = "En bref",
    ["Parts of the operation that were not begun: "] = "Parties de l'opération non commencées : ",
    ["All %d steps were completed."] = "Les %d étapes ont toutes été accomplies.",
    ["%d of %d steps were completed%s."] = "%d étapes sur %d ont été accomplies%s.",
    ["; not completed: "] = " ; non accomplies : ",
    ["“%s” began with a round opening of the bag: what was torn before could not be its opening."] =
        "« %s » a commencé avec une ouverture ronde du sac : ce qui avait été déchiré ne pouvait être la sienne.",
    ["No error was made."] = "Aucune erreur.",
    ["One error was made, and put right."] = "Une erreur, corrigée.",
    ["%d errors were made, and all put right."] = "%d erreurs, toutes corrigées.",
    ["One error happened; %d put right."] = "Une erreur, dont %d corrigée.",
    ["%d errors happened; %d put right."] = "%d erreurs, dont %d corrigées.",
    ["The exercise was stopped by a mistake in its script:"] =
        "L'exercice a été arrêté par une faute dans son script :",
    ["Next time:"] = "La prochaine fois :",

    -- report: what happened
    ["What happened when"] = "Déroulement",
    ["Green: step completed. Grey: not completed."] = "Vert : étape accomplie. Gris : non accomplie.",
    ["near miss"] = "évitée de justesse",
    ["not put right"] = "non corrigée",
    ["at %s"] = "à %s",
    [" after %s"] = " après %s",
    ["yes"] = "oui",
    ["no"] = "non",
    ["Measured then: "] = "Mesuré alors : ",
    ["What the exercise let follow: "] = "Suite voulue par l'exercice : ",
    ["%s set to %s"] = "%s réglé à %s",
    ["What shows it:"] = "Ce qui la révèle :",
    ["What to do:"] = "Que faire :",
    ["Video"] = "Vidéo",
    ["If it does not play here, open %s, which lies beside this page, in any player."] =
        "Si elle ne se lit pas ici, ouvrez %s, à côté de cette page, dans un lecteur.",
    ["Over time"] = "Au cours du temps",
    ["Dashed lines: errors (red: critical, brown: minor). Red ground: danger. Grey ground: every second step."] =
        "Tirets : erreurs (rouge : critique, brun : mineure). Fond rouge : danger. Fond gris : une étape sur deux.",

    -- report: background
    ["Patient, machine and simulation"] = "Patient, machine et simulation",
    ["Goals of the exercise"] = "Buts de l'exercice",
    ["Machine"] = "Machine",
    ["%s, version %s"] = "%s, version %s",
    ["Chance"] = "Hasard",
    ["seed %s"] = "graine %s",
    ["Steps of time"] = "Pas de temps",
    ["%s, %s ms each on average, %s ms for all but 1 %%, %s repeated"] =
        "%s, %s ms chacun en moyenne, %s ms pour tous sauf 1 %%, %s répétés",
    ["Computing time"] = "Temps de calcul",
    ["%s s per simulated second"] = "%s s par seconde simulée",
    ["What was simulated"] = "Ce qui a été simulé",
    ["Part"] = "Partie",
    ["Elements"] = "Éléments",
    ["Curriculum %s"] = "Exercice %s",

    -- report: scores
    ["Score, item by item"] = "Note, critère par critère",
    ["Item"] = "Critère",
    ["Why"] = "Pourquoi",
    ["Points"] = "Points",
    ["Measure"] = "Mesure",
    ["Value"] = "Valeur",
    ["Ground for the thresholds"] = "Origine des seuils",
    ["of 5"] = "sur 5",
    ["Band: "] = "Palier : ",
    ["The cuts are where the groups of Saleh et al. 2007 part."] =
        "Les limites sont celles qui séparent les groupes de Saleh et coll. 2007.",
    ["not clinically validated"] = "non validé cliniquement",
    ["At"] = "À",
    ["What would have been better"] = "Ce qui aurait été mieux",
    ["N/A, not scored"] = "Sans objet, non noté",
    ["proposal"] = "proposition",
    ["published"] = "publié",
    ["partly published"] = "publié en partie",
    ["This level reads: "] = "Ce niveau signifie : ",
    ["Each item has %s to 5 points."] = "Chaque critère vaut de %s à 5 points.",
    ["These scores have not been validated clinically."] = "Ces notes n'ont pas été validées cliniquement.",
    ["Thresholds marked “proposal” have no published ground; an item that this exercise does not show (N/A) is left "
        .. "out, and the scale shrinks to the others."] =
        "Les seuils marqués « proposition » n'ont pas de fondement publié ; un critère que cet exercice ne montre pas "
        .. "(sans objet) est laissé de côté, et l'échelle se réduit aux autres.",

    -- report: pictures
    ["Pictures"] = "Images",
    ["Of what happened often, only the first pictures are here. The other %d of %d lie in %s, beside this page."] =
        "De ce qui s'est répété, seules les premières images sont ici. Les %d autres, sur %d, sont dans %s, à côté.",

    -- comparison
    ["Compared with earlier attempts"] = "Comparaison avec les essais précédents",
    ["Compared with earlier attempts and with others"] = "Comparaison avec les essais précédents et avec les autres",
    ["Attempt %d."] = "Essai %d.",
    ["The best so far, with %s %% of its points."] = "Le meilleur jusqu'ici, avec %s %% de ses points.",
    ["As good as the best so far, with %s %% of its points."] =
        "Aussi bon que le meilleur jusqu'ici, avec %s %% de ses points.",
    ["The best so far had %s %% of its points, this one %s %%."] =
        "Le meilleur jusqu'ici avait %s %% de ses points, celui-ci %s %%.",
    ["The cohort has %s."] = "La cohorte a %s.",
    ["The cohort (%s) has %s."] = "La cohorte (%s) a %s.",
    ["%s: %s of %s points"] = "%s : %s points sur %s",
    ["now"] = "maintenant",
    ["this attempt"] = "cet essai",
    ["passed"] = "réussi",
    ["not passed"] = "non réussi",
    ["cohort, mean and SD"] = "cohorte, moyenne et écart type",
    ["1 to 5 points"] = "1 à 5 points",
    ["Now"] = "Maintenant",
    ["Last time"] = "La dernière fois",
    ["Cohort"] = "Cohorte",
    ["1 to 5 points: orange now, grey before, blue cohort"] =
        "1 à 5 points : orange maintenant, gris avant, bleu cohorte",
    ["Shares of the points that could be earned. Exercises and rubrics change: only attempts at the same version "
        .. "compare exactly."] =
        "Parts des points possibles. Exercices et grilles changent : seuls les essais d'une même version se "
            .. "comparent exactement.",

    -- time line
    ["Errors, and how long until put right"] = "Erreurs, et temps jusqu'à la correction",
    ["Time line of steps and errors"] = "Étapes et erreurs dans le temps",
    ["Way seen from above"] = "Trajet vu d'en haut",
}
