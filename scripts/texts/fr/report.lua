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
    ["easy"] = "facile",
    ["hard"] = "difficile",
    ["Time"] = "Durée",
    ["not scored"] = "non noté",
    ["of %s"] = "sur %s",
    ["rests on %d of %d items"] = "repose sur %d critères sur %d",
    ["like virtual surgeons of group %s"] = "comme les chirurgiens virtuels du groupe %s",
    ["like virtual surgeons of groups %s"] = "comme les chirurgiens virtuels des groupes %s",
    [" and "] = " et ",
    [" (with a mouse)"] = " (à la souris)",
    [" (with a gamepad)"] = " (à la manette)",
    [" (with tracked instruments)"] = " (avec des instruments suivis)",
    ["no comparison: with aids"] = "sans comparaison : avec des aides",
    ["no comparison: no cohort of people with this device"] =
        "sans comparaison : pas de cohorte de personnes avec cet appareil",
    ["With aids: "] = "Avec des aides : ",
    ["Such an attempt counts for no gate, and its score is not compared."] =
        "Un tel essai ne compte pour aucun seuil, et sa note n'est pas comparée.",
    ["went back to try again"] = "retour en arrière pour réessayer",
    ["simulated time ran slower than the clock"] = "le temps simulé a couru moins vite que l'horloge",
    ["an expert's way was shown"] = "la voie d'un expert était montrée",
    ["warnings were shown"] = "des avertissements étaient montrés",
    ["an instructor changed something"] = "un instructeur a changé quelque chose",
    ["once"] = "une fois",
    ["%d times"] = "%d fois",
    ["no comparison: begun in the middle"] = "sans comparaison : commencé en cours de route",
    ["no comparison: virtual surgeons have not done it for one"] =
        "sans comparaison : aucun chirurgien virtuel n'a servi de référence",
    ["no comparison: the exercise has changed since virtual surgeons did it"] =
        "sans comparaison : l'exercice a changé depuis que des chirurgiens virtuels l'ont fait",
    ["no comparison: judged by another rubric"] = "sans comparaison : jugé selon une autre grille",
    ["no comparison: not the exercise as virtual surgeons did it"] =
        "sans comparaison : l'exercice n'est pas celui qu'ont fait les chirurgiens virtuels",
    ["no comparison: not completed"] = "sans comparaison : non accompli",
    ["no comparison: too few items"] = "sans comparaison : trop peu de critères",
    ["no comparison: other items than virtual surgeons were scored on"] =
        "sans comparaison : d'autres critères que ceux des chirurgiens virtuels",
    ["no comparison: this exercise does not tell beginners from experts"] =
        "sans comparaison : cet exercice ne distingue pas débutants et experts",

    -- report: in short
    ["In short"] = "En bref",
    ["Parts of the operation that were not begun: "] = "Parties de l'opération non commencées : ",
    ["The only step was completed."] = "La seule étape a été accomplie.",
    ["All %d steps were completed."] = "Les %d étapes ont toutes été accomplies.",
    ["The only step that was begun was completed."] = "La seule étape commencée a été accomplie.",
    ["All %d steps that were begun were completed."] = "Les %d étapes commencées ont toutes été accomplies.",
    ["No step was begun."] = "Aucune étape n'a été commencée.",
    ["The only step was not completed."] = "La seule étape n'a pas été accomplie.",
    ["None of the %d steps was completed."] = "Aucune des %d étapes n'a été accomplie.",
    ["One of %d steps was completed%s."] = "Une étape sur %d a été accomplie%s.",
    ["%d of %d steps were completed%s."] = "%d étapes sur %d ont été accomplies%s.",
    ["This operation was begun in the middle, with %s."] =
        "Cette opération a été commencée en cours de route, avec %s.",
    ["This exercise was begun in the middle: %s."] = "Cet exercice a été commencé en cours de route : %s.",
    ["What came before is not judged, and the score is not compared."] =
        "Ce qui précède n'est pas jugé, et la note n'est pas comparée.",
    ["; not completed: "] = " ; non accomplie : ",
    ["; these were not completed: "] = " ; non accomplies : ",
    ["%s began with a round opening of the bag: what was torn before could not be its opening."] =
        "%s a commencé avec une ouverture ronde du sac : ce qui avait été déchiré ne pouvait être la sienne.",
    ["Errors: "] = "Erreurs : ",
    ["The exercise began with: "] = "L'exercice a commencé par : ",
    ["%d of %d put right"] = "%d sur %d corrigées",
    ["%d times; "] = "%d fois ; ",
    ["given at the start"] = "donnée au départ",
    ["%s: given at the start, not judged."] = "%s : donné au départ, non jugé.",
    ["%s: not judged, for simulated time ran slower than the clock."] =
        "%s : non jugé, car le temps simulé a été plus lent que l'horloge.",
    ["%s: not judged, for what it was operated with does not show it."] =
        "%s : non jugé, car ce avec quoi on a opéré ne le montre pas.",
    ["Given up"] = "Abandon",
    ["\"%s\" was not done: go on with it before the instruments leave for good."] =
        "« %s » n'a pas été fait : poursuivez avant de retirer les instruments pour de bon.",
    ["No error was made."] = "Aucune erreur.",
    ["One error was made, and put right."] = "Une erreur, corrigée.",
    ["One error was made, and not put right."] = "Une erreur, non corrigée.",
    ["%d errors were made, and all put right."] = "%d erreurs, toutes corrigées.",
    ["%d errors were made, and none put right."] = "%d erreurs, aucune corrigée.",
    ["%d errors were made, and one of them put right."] = "%d erreurs, dont une corrigée.",
    ["%d errors were made, and %d of them put right."] = "%d erreurs, dont %d corrigées.",
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
    ["Grey lines: another part of the operation begins."] =
        "Traits gris : une autre partie de l'opération commence.",
    ["%s: %s"] = "%s : %s",
    ["; "] = " ; ",

    -- report: background
    ["Patient, machine and simulation"] = "Patient, machine et simulation",
    ["Goals of the exercise"] = "Buts de l'exercice",
    ["Machine"] = "Machine",
    ["%s, version %s"] = "%s, version %s",
    ["Chance"] = "Hasard",
    ["seed %s"] = "graine %s",
    ["Steps of time"] = "Pas de temps",
    ["%s, %s ms each on average, %s ms for all but 1 %%, %s repeated"] =
        "%s, %s ms chacun en moyenne, %s ms pour tous sauf 1 %%, répétitions : %s",
    ["Computing time"] = "Temps de calcul",
    ["%s s per simulated second"] = "%s s par seconde simulée",
    ["What was simulated"] = "Ce qui a été simulé",
    ["How finely it was simulated"] = "Finesse de la simulation",
    ["Mesh"] = "Maillage",
    ["Quantity"] = "Grandeur",
    ["Expected error"] = "Erreur attendue",
    ["Error that it may have"] = "Erreur admise",
    ["Measured error"] = "Erreur mesurée",
    ["%s, as the exercise says"] = "%s, selon l'exercice",
    ["Measured against steps of %s ms%s over %s of %s s."] =
        "Mesurée par rapport à des pas de %s ms%s sur %s des %s s.",
    [" and %s"] = " et %s",
    ["After %s s a tear, crack or grip differs (%s)."] =
        "Après %s s, une déchirure, une fissure ou une prise diffère (%s).",
    ["Steps of %s ms. By the tables of the program that costs %s s of computing time per simulated second."] =
        "Pas de %s ms. D'après les tables du programme, cela coûte %s s de calcul par seconde simulée.",
    ["force out of balance on the implant"] = "force non équilibrée sur l'implant",
    ["force on the instrument"] = "force sur l'instrument",
    ["depth to which what touches overlaps"] = "profondeur d'interpénétration au contact",
    ["way of the tear"] = "trajet de la déchirure",
    ["length of the tear"] = "longueur de la déchirure",
    ["volume taken out"] = "volume enlevé",
    ["triangles of the bag"] = "triangles du sac",
    ["triangles of the capsule"] = "triangles de la capsule",
    ["triangles of the implant"] = "triangles de l'implant",
    ["tetrahedra"] = "tétraèdres",
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
    ["Comparison: this exercise was completed %d times by virtual surgeons of group %s; the score falls nearer to "
        .. "theirs than to those of the others."] =
        "Comparaison : cet exercice a été accompli %d fois par des chirurgiens virtuels du groupe %s ; la note est "
            .. "plus proche des leurs que de celles des autres.",
    ["Group a stands for fewer than 50 operations, d for over 500; what they are is a model, not people."] =
        "Le groupe a représente moins de 50 opérations, le groupe d plus de 500 ; ce sont des modèles, non des "
            .. "personnes.",
    ["It "] = "Elle ",
    ["not clinically validated"] = "non validé cliniquement",
    ["At"] = "Moment",
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
    ["Of what happened often, only the first pictures are here."] =
        "De ce qui s'est répété, seules les premières images sont ici.",
    ["The other %d of %d lies in %s, beside this page."] = "La dernière (%d sur %d) est dans %s, à côté de cette page.",
    ["The other %d of %d lie in %s, beside this page."] = "Les %d autres, sur %d, sont dans %s, à côté de cette page.",

    -- comparison
    ["Compared with earlier attempts"] = "Comparaison avec les essais précédents",
    ["Compared with earlier attempts and with others"] = "Comparaison avec les essais précédents et avec les autres",
    ["Attempt %d."] = "Essai %d.",
    ["Compared with others"] = "Comparaison avec les autres",
    ["The best so far, with %s %% of the scale."] = "Le meilleur jusqu'ici, avec %s %% de l'échelle.",
    ["As good as the best so far, with %s %% of the scale."] =
        "Aussi bon que le meilleur jusqu'ici, avec %s %% de l'échelle.",
    ["The best so far had %s %% of the scale, this one %s %%."] =
        "Le meilleur jusqu'ici avait %s %% de l'échelle, celui-ci %s %%.",
    ["%s %% of the scale for what was done: not completed, and not compared."] =
        "%s %% de l'échelle pour ce qui a été fait : non terminé, et non comparé.",
    ["The first that was completed, with %s %% of the scale."] = "Le premier terminé, avec %s %% de l'échelle.",
    ["This attempt has %s %% of the scale."] = "Cet essai a %s %% de l'échelle.",
    ["The cohort has %s of the scale."] = "La cohorte a %s de l'échelle.",
    ["The cohort (%s) has %s of the scale."] = "La cohorte (%s) a %s de l'échelle.",
    ["%d trainee"] = "%d interne",
    ["%d trainees"] = "%d internes",
    ["%s: %s %% of the scale"] = "%s : %s %% de l'échelle",
    [", not completed"] = ", non accompli",
    ["not completed"] = "non accompli",
    ["now"] = "maintenant",
    ["this attempt"] = "cet essai",
    ["passed"] = "réussi",
    ["not passed"] = "non réussi",
    ["cohort, mean and SD"] = "cohorte, moyenne et écart type",
    ["%s to 5 points"] = "%s à 5 points",
    ["Now"] = "Maintenant",
    ["Last time"] = "La dernière fois",
    ["Cohort"] = "Cohorte",
    ["%s to 5 points: orange now"] = "%s à 5 points : orange maintenant",
    [", grey before"] = ", gris avant",
    [", blue cohort"] = ", bleu cohorte",
    ["Shares of the scale: 0 % if every item has its least points, 100 % if every one has its most."] =
        "Parts de l'échelle : 0 % si chaque critère a le moins de points possible, 100 % si chacun en a le plus.",
    ["Exercises and rubrics change: only attempts at the same version compare exactly."] =
        "Exercices et grilles changent : seuls les essais d'une même version se comparent exactement.",

    -- time line
    ["Errors, and how long until put right"] = "Erreurs, et temps jusqu'à la correction",
    ["Time line of steps and errors"] = "Étapes et erreurs dans le temps",
    ["Way seen from above"] = "Trajet vu d'en haut",
}
