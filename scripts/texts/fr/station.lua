-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: what the trainee's window says (bindings/station).

return {
    -- controls
    ["The tip of the hand that moves is where the cursor is"] = "La pointe de la main active suit le curseur",
    ["The tip of the hand that moves, to the right"] = "Pointe de la main active, vers la droite",
    ["The same, away from you"] = "De même, en s'éloignant de vous",
    ["The same, up to the microscope"] = "De même, vers le microscope",
    ["Rolls its instrument between the fingers, against the clock"] =
        "Roule son instrument entre les doigts, dans le sens inverse des aiguilles",
    ["The tip of the hand that moves, up by a little"] = "Pointe de la main active, un peu plus haut",
    ["Closes the jaws, presses the syringe, pushes the plunger, holds the hook"] =
        "Ferme les mors, presse la seringue, pousse le piston, tient le crochet",
    ["Draws back a plunger or lets go of a hook, which stay where they were left"] =
        "Retire un piston ou lâche un crochet, qui restent où on les laisse",
    ["The tip of the leading hand, to the right"] = "Pointe de la main principale, vers la droite",
    ["Rolls its instrument"] = "Roule son instrument",
    ["Squeezes with the leading hand"] = "Serre avec la main principale",
    ["The tip of the other hand, to the right"] = "Pointe de l'autre main, vers la droite",
    ["Squeezes with the other hand"] = "Serre avec l'autre main",
    ["All movements a fifth as fast, as long as it is held"] =
        "Tous les mouvements cinq fois plus lents, tant qu'on la tient",
    ["The cursor moves the other hand"] = "Le curseur mène l'autre main",
    ["Takes the next instrument of the stand into the hand that moves"] =
        "Prend l'instrument suivant de la table dans la main active",
    ["Puts the instrument of the hand that moves down, where it is outside the eye"] =
        "Pose l'instrument de la main active, s'il est hors de l'œil",
    ["The hand goes on from where its instrument is, without going to meet it"] =
        "La main reprend là où est son instrument, sans le rejoindre",
    ["Presses the pedal, or lets it up, as long as it is held"] =
        "Enfonce la pédale, ou la relâche, tant qu'on la tient",
    ["The pedal, as far as it is pressed"] = "La pédale, selon son enfoncement",
    ["The foot goes off the pedal"] = "Le pied quitte la pédale",
    ["The foot goes to position 1, irrigation"] = "Pédale en position 1, irrigation",
    ["The foot goes to the end of position 2, aspiration"] = "Pédale à fond de position 2, aspiration",
    ["The foot goes to the end of position 3, ultrasound"] = "Pédale à fond de position 3, ultrasons",
    ["The microscope, to the right"] = "Microscope, vers la droite",
    ["The microscope, away from you"] = "Microscope, en s'éloignant de vous",
    ["Its focus, up"] = "Sa mise au point, vers le haut",
    ["Its zoom: larger"] = "Son grossissement : plus grand",
    ["Its light: brighter"] = "Sa lumière : plus forte",
    ["Chooses the next dial of the machine"] = "Choisit le réglage suivant de la machine",
    ["Turns the chosen dial up"] = "Augmente le réglage choisi",
    ["Chooses the next request to the staff"] = "Choisit la demande suivante à l'équipe",
    ["Asks the staff for what is chosen"] = "Demande à l'équipe ce qui est choisi",
    ["The clock stands still, or goes on"] = "Arrête le temps, ou le relance",
    ["Keeps this moment, to try again from"] = "Retient ce moment, pour y revenir",
    ["Goes back to the moment that was kept"] = "Revient au moment retenu",
    ["Shows, or hides, how an expert does it"] = "Montre, ou cache, le geste d'un expert",
    ["Shows, or hides, what each key and button does"] = "Montre, ou cache, ce que fait chaque touche",
    ["Ends the exercise; the report opens"] = "Termine l'exercice ; le rapport s'ouvre",
    ["Takes this instrument of the stand into the hand that moves"] =
        "Prend cet instrument de la table dans la main active",
    ["Chooses this dial of the machine"] = "Choisit ce réglage de la machine",
    ["Chooses this request to the staff"] = "Choisit cette demande à l'équipe",

    -- panels
    ["pedal"] = "pédale",
    ["leading hand"] = "main principale",
    ["other hand"] = "autre main",
    ["ask"] = "demander",
    ["%s pictures/s, at %s % of the size"] = "%s images/s, à %s % de la taille",
    ["%s pictures/s"] = "%s images/s",
    ["slow clock: %s %"] = "temps ralenti : %s %",
    ["Take with the leading hand"] = "Prendre de la main principale",
    ["Take with the other hand"] = "Prendre de l'autre main",
    ["Put down"] = "Poser",
    ["Other hand"] = "Autre main",
    ["The machine"] = "La machine",
    ["Ask the staff"] = "Demander à l'équipe",
    ["Right-handed"] = "Droitier",
    ["Left-handed"] = "Gaucher",
    ["Keep as mine"] = "Garder comme miennes",
    ["kept in %s"] = "gardé dans %s",
    ["read again: %s"] = "relu : %s",
    ["Press what shall work it; Escape leaves it as it is"] =
        "Pressez ce qui doit l'actionner ; Échap n'y change rien",
    ["Click what shall be worked otherwise"] = "Cliquez sur ce qui doit être actionné autrement",
    ["The clock stands."] = "Le temps est arrêté.",
    ["Go on"] = "Reprendre",
    ["Keep this moment"] = "Retenir ce moment",
    ["Try again from there"] = "Y revenir",
    ["Expert's way"] = "Geste d'expert",
    ["End the exercise"] = "Terminer l'exercice",
    ["Stand"] = "Table",
    ["Keys"] = "Touches",

    -- what cannot be done
    ["a stick is stuck: it counts as let go until it moves"] =
        "un manche est bloqué : il compte comme relâché jusqu'à ce qu'il bouge",
    ["an exam has no second try"] = "un examen n'a pas de second essai",
    ["an exam shows no ghost"] = "un examen ne montre pas de geste d'expert",
    ["first out of the eye, then another instrument"] = "d'abord hors de l'œil, ensuite un autre instrument",
    ["first out of the eye, then put it down"] = "d'abord hors de l'œil, ensuite le poser",
    ["there is no expert's way: rhexis train --ghost RUN, of rhexis run"] =
        "pas de geste d'expert : rhexis train --ghost ESSAI, de rhexis run",
    ["this moment is kept"] = "ce moment est retenu",
    ["the computer was away for a moment: the clock stands"] =
        "l'ordinateur s'est absenté un moment : le temps est arrêté",

    -- what hands learn first
    ["Take an instrument: %s"] = "Prenez un instrument : %s",
    ["The clock waits for your hand: bring the cursor to the tip, or press %s"] =
        "Le temps attend votre main : amenez le curseur sur la pointe, ou pressez %s",
    ["Go in through the wound: move the tip towards the middle of the eye"] =
        "Entrez par l'incision : menez la pointe vers le milieu de l'œil",
    ["Deeper and higher: the wheel"] = "Plus profond, plus haut : la molette",
    ["Deeper and higher: %s"] = "Plus profond, plus haut : %s",
    ["Irrigation on: %s; aspiration: %s"] = "Irrigation : %s ; aspiration : %s",
    ["Close the jaws, press or push: %s"] = "Fermez les mors, pressez ou poussez : %s",

    -- instruments that a tracking system sees
    ["the link is lost: %s"] = "la liaison est perdue : %s",
    ["no link yet: %s"] = "pas encore de liaison : %s",
    ["no pose has come yet"] = "aucune pose n'est encore arrivée",
    ["the clock of the tracking system was set"] = "l'horloge du système de suivi a été réglée",
    ["the tracking system says: %s"] = "le système de suivi dit : %s",
    ["%s is lost"] = "%s est perdu de vue",
    ["%s was seen to leap"] = "%s a été vu faire un saut",
    ["%s is not seen"] = "%s n'est pas vu",
    ["bring %s to where it is shown"] = "%s : ramenez l'instrument là où il est montré",
    ["%s degrees to turn"] = "tourner de %s degrés",
    ["no instrument is seen"] = "aucun instrument n'est vu",

    -- where the tip is to be
    ["%s mm higher"] = "%s mm plus haut",
    ["%s mm lower"] = "%s mm plus bas",

    -- the menu
    ["Lessons, in this order"] = "Leçons, dans cet ordre",
    ["Drills"] = "Exercices particuliers",
    ["as it is"] = "tel quel",
    ["Difficulty"] = "Difficulté",
    ["as the exercise says"] = "comme le dit l'exercice",
    ["Patient"] = "Patient",
    ["This machine"] = "Cette machine",
    ["%s pictures/s of this menu"] = "%s images/s de ce menu",
    ["gamepad: found"] = "manette : trouvée",
    ["gamepad: none"] = "manette : aucune",
    ["pedal: found"] = "pédale : trouvée",
    ["pedal: none; keys 0 to 3 and Space press it"] =
        "pédale : aucune ; les touches 0 à 3 et Espace la remplacent",
    ["Mouse and keys"] = "Souris et clavier",
    ["Gamepad"] = "Manette",
    ["Last time: %s"] = "La dernière fois : %s",
    ["not yet"] = "pas encore",
    ["Begin"] = "Commencer",
    ["Leave"] = "Quitter",
    ["In the exercise: F1 shows all keys; E takes an instrument, F brings the hand to it, the mouse moves its tip and "
        .. "the wheel its depth; 1, 2, 3 press the pedal; P stops the clock."] =
        "Dans l'exercice : F1 montre toutes les touches ; E prend un instrument, F y amène la main, la souris en mène "
        .. "la pointe et la molette la profondeur ; 1, 2, 3 enfoncent la pédale ; P arrête le temps.",
}
