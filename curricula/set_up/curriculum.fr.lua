-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Draping and set-up"] = "Champ opératoire et préparation",
    ["Lead the edge of the drape along both margins until no lash sticks out, open the lids with the speculum, "
        .. "centre and focus the microscope, test the pedal with the tip in the air, confirm the settings of the "
        .. "machine and the side of the eye, and say that you are ready. The order is yours."] =
        "Menez le bord du champ le long des deux bords palpébraux jusqu'à ce qu'aucun cil ne dépasse, ouvrez les "
            .. "paupières au blépharostat, centrez et mettez au point le microscope, essayez la pédale la pointe "
            .. "en l'air, confirmez les réglages de la machine et le côté de l'œil, et dites que vous êtes prêt. "
            .. "L'ordre est à votre choix.",
    ["Keep every lash out of the field"] = "Garder tous les cils hors du champ opératoire",
    ["See that microscope, pedal and machine do what they are to do before the eye is open"] =
        "Vérifier que microscope, pédale et machine font ce qu'ils doivent avant d'ouvrir l'œil",
    ["Confirm the side and the settings aloud"] = "Confirmer à voix haute le côté et les réglages",
    ["Settings confirmed"] = "Réglages confirmés",
    ["power, vacuum, flow and bottle are read out"] = "puissance, vide, débit et flacon sont lus à voix haute",
    ["Side confirmed"] = "Côté confirmé",
    ["this is the eye that was consented to"] = "c'est bien l'œil du consentement",
    ["Ready to begin"] = "Prêt à commencer",
    ["the checklist is done"] = "la liste de contrôle est faite",
    ["Make ready"] = "Préparer",
    ["Drape over all lashes, lids open, microscope on the pupil, pedal 1, 2 and 3 with the tip in the air, "
        .. "settings and side said aloud. Then say that you are ready."] =
        "Le champ sur tous les cils, paupières ouvertes, microscope sur la pupille, pédale en 1, 2 et 3 la pointe "
            .. "en l'air, réglages et côté dits à voix haute. Puis dites que vous êtes prêt.",
    ["Lashes uncovered"] = "Cils découverts",
    ["Lashes stick out beside the drape."] = "Des cils dépassent à côté du champ.",
    ["Not ready yet: lashes carry germs into the wound. Lead the drape over them once more."] =
        "Pas encore prêt : les cils portent des germes dans l'incision. Repassez le champ sur eux.",
    ["Pedal not tested"] = "Pédale non essayée",
    ["Nobody has seen the infusion run."] = "Personne n'a vu couler l'irrigation.",
    ["Tip in the air, pedal to 1, 2 and 3: infusion runs, the pump draws, ultrasound sounds."] =
        "La pointe en l'air, pédale en 1, 2 et 3 : l'irrigation coule, la pompe aspire, les ultrasons s'entendent.",
}
