-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: the theatre's monitor, warnings, what an instructor lets happen, and the debriefing (bindings/theatre).

return {
    -- warnings
    ["The tear is about to run out"] = "La déchirure va filer vers la périphérie",
    ["Stop pulling: fill the chamber, take the flap close to the tear, and pull to the middle."] =
        "Cessez de tirer : remplissez la chambre, prenez le lambeau près de la déchirure et tirez vers le centre.",
    ["The posterior capsule is near"] = "La capsule postérieure est proche",
    ["Draw the tip up, pedal to 1, and look where the capsule is."] =
        "Remontez la pointe, pédale en 1, et regardez où est la capsule.",
    ["A surge is coming"] = "Un collapsus menace",
    ["Pedal to 1 before the piece clears, or raise the bottle."] =
        "Pédale en 1 avant que le fragment ne se libère, ou montez le flacon.",

    -- what an instructor lets happen
    ["Bleeding behind the choroid"] = "Saignement derrière la choroïde",
    ["The bottle runs empty"] = "Le flacon se vide",
    ["The infusion line is kinked"] = "La ligne d'infusion est coudée",
    ["The patient coughs"] = "Le patient tousse",
    ["The patient moves the head"] = "Le patient bouge la tête",
    ["The microscope is pushed: the red reflex is lost"] = "Le microscope est heurté : la lueur pupillaire est perdue",
    ["the monitor asks for what this station does not know: "] = "l'écran demande ce que ce poste ne connaît pas : ",
    ["the exercise has no level "] = "l'exercice n'a pas de niveau ",
    ["some of this level begins with the next attempt only"] =
        "une partie de ce niveau ne commence qu'au prochain essai",
    ["an exam does not warn"] = "un examen n'avertit pas",
    ["Warns, or does not, of what is about to go wrong"] = "Avertit, ou non, de ce qui va mal tourner",

    -- the monitor
    ["theatre's monitor"] = "écran de la salle",
    ["the attempt has ended"] = "l'essai est terminé",
    ["paused"] = "en pause",
    ["the clock waits for the hand"] = "le temps attend la main",
    ["no station at %s yet"] = "pas encore de poste à %s",
    ["nothing has come for %s s: the station is busy, suspended or gone"] =
        "rien n'est venu depuis %s s : le poste est occupé, suspendu ou parti",
    ["a station of another version speaks there"] = "un poste d'une autre version parle ici",
    ["heart, per min"] = "cœur, par min",
    ["pressure, mmHg"] = "pression, mmHg",
    ["saturation, %"] = "saturation, %",
    ["The machine"] = "La machine",
    ["none in this exercise"] = "aucune dans cet exercice",
    ["power"] = "puissance",
    ["vacuum"] = "vide",
    ["flow"] = "débit",
    ["tip shut"] = "embout bouché",
    ["chamber"] = "chambre",
    ["bottle"] = "flacon",
    ["no infusion"] = "pas d'infusion",
    ["Steps"] = "Étapes",
    ["Events and advice"] = "Événements et conseils",
    ["open"] = "en cours",
    ["not put right"] = "non corrigée",
    ["OSACSS so far"] = "OSACSS jusqu'ici",
    ["not scored"] = "non noté",
    ["Force of each hand, mN"] = "Force de chaque main, mN",
    ["no instrument in the eye"] = "aucun instrument dans l'œil",
    ["Force of instruments on the posterior capsule."] = "Force des instruments sur la capsule postérieure.",
    ["The station"] = "Le poste",
    ["keyboard and mouse"] = "clavier et souris",
    ["pad"] = "manette",
    ["there"] = "présent",
    ["gone"] = "parti",
    ["Instructor"] = "Instructeur",
    ["Go on"] = "Reprendre",
    ["Pause"] = "Pause",
    ["back %s s"] = "%s s en arrière",
    ["the trainee is warned too"] = "l'apprenant est averti aussi",
    ["Pin note"] = "Épingler",
    ["no station takes it"] = "aucun poste ne le prend",

    -- the debriefing
    ["What happened"] = "Ce qui est arrivé",
    ["error"] = "erreur",
    ["warning"] = "avertissement",
    ["note"] = "note",
    ["let happen"] = "provoqué",
    ["step"] = "étape",
    ["Play"] = "Lecture",
    ["How to get a 4"] = "Comment obtenir un 4",
    ["simulating ..."] = "simulation ...",
    ["the expert's way (yellow), yours (blue)"] = "la voie de l'expert (jaune), la vôtre (bleu)",
    ["Back to the microscope"] = "Retour au microscope",
    ["Space plays, left and right one second, N and B the next and the last mark, right button turns the camera, wheel "
        .. "zooms, R back, H the expert's way"] =
        "Espace lit, gauche et droite une seconde, N et B le repère suivant et le précédent, le bouton droit tourne la "
        .. "caméra, la molette agrandit, R ramène, H la voie de l'expert",

    -- the report
    ["Notes of the instructor"] = "Notes de l'instructeur",
    ["For 4 points: "] = "Pour 4 points : ",
    ["Without \"%s\", or with it put right at once."] = "Sans « %s », ou corrigée aussitôt.",
    ["%s: %s instead of %s."] = "%s : %s au lieu de %s.",
}
