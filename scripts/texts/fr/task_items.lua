-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: the items T1 to T14 of OSACSS and their measures.

return {
    -- T1
    ["Draping"] = "Champ opératoire",
    ["draping is not simulated in this exercise."] = "la pose du champ n'est pas simulée dans cet exercice.",
    ["Lashes under the drape when you said that you were ready"] = "Cils sous le champ quand vous vous êtes dit prêt",
    ["Lead the drape along both margins, into the corners."] =
        "Menez le champ le long des deux bords palpébraux, jusque dans les angles.",
    ["Microscope centred and focused by then (1: yes)"] = "Microscope centré et mis au point à ce moment (1 : oui)",
    ["Centre the pupil and focus before you begin."] =
        "Centrez la pupille et faites la mise au point avant de commencer.",
    ["Pedal tested by then (1: yes)"] = "Pédale essayée à ce moment (1 : oui)",
    ["Press the pedal to 1, 2 and 3 with the tip in the air."] = "Enfoncez la pédale en 1, 2 et 3, la pointe en l'air.",
    ["Settings confirmed by then (1: yes)"] = "Réglages confirmés à ce moment (1 : oui)",
    ["Have power, vacuum, flow and bottle read out."] =
        "Faites lire à voix haute puissance, vide, débit et hauteur de flacon.",
    ["Side of the eye confirmed by then (1: yes)"] = "Côté de l'œil confirmé à ce moment (1 : oui)",
    ["Say which eye it is before you touch it."] = "Dites de quel œil il s'agit avant d'y toucher.",

    -- T2
    ["Incision and paracentesis"] = "Incision et paracentèse",
    ["the incision is already made."] = "l'incision est déjà faite.",
    ["Length of the main incision's tunnel"] = "Longueur du tunnel de l'incision principale",
    ["About as long as it is wide: 2 mm."] = "À peu près aussi long que large : 2 mm.",
    ["Difference of its width from that of the blade"] = "Écart entre sa largeur et celle de la lame",
    ["In until the shoulders of the blade are through, and straight back."] =
        "Avancez jusqu'à ce que les épaules de la lame soient passées, puis reculez tout droit.",
    ["Planes of its tunnel"] = "Plans de son tunnel",
    ["First along the slope of the cornea, then level into the chamber."] =
        "D'abord le long de la pente de la cornée, puis à plat dans la chambre.",
    ["What comes through it at 20 mmHg"] = "Ce qui en sort à 20 mmHg",
    ["A tunnel as long as it is wide shuts itself."] = "Un tunnel aussi long que large se ferme tout seul.",
    ["Touches of iris or lens by a blade"] = "Contacts d'une lame avec l'iris ou le cristallin",
    ["Level with the iris as soon as the point is in the chamber."] =
        "Parallèlement à l'iris dès que la pointe est dans la chambre.",
    ["Angle of the side port from the main incision"] = "Angle entre la contre-incision et l'incision principale",
    ["The side port belongs 60 to 100 degrees from the main incision."] =
        "La contre-incision se place à 60 à 100 degrés de l'incision principale.",

    -- T6
    ["Hydrodissection: visible fluid wave and free nuclear rotation"] =
        "Hydrodissection : onde de fluide visible et rotation libre du noyau",
    ["hydrodissection is not simulated."] = "l'hydrodissection n'est pas simulée.",
    ["Posterior capsule that the wave has passed in the end"] =
        "Part de la capsule postérieure parcourue par l'onde à la fin",
    ["Inject close under the rim, and again at another quadrant, until the front has crossed."] =
        "Injectez juste sous le bord, puis dans un autre quadrant, jusqu'à ce que le front soit passé.",
    ["How far the nucleus was turned"] = "Rotation du noyau",
    ["Turn it by half a turn before you go on: only then is it free."] =
        "Tournez-le d'un demi-tour avant de continuer : alors seulement il est libre.",
    ["Greatest strain of a zonule"] = "Étirement maximal d'une fibre zonulaire",
    ["Do not force a nucleus to turn that adheres."] = "Ne forcez pas la rotation d'un noyau qui adhère.",
    ["Saline that was injected"] = "Sérum injecté",
    ["Little and well placed: look where the end of the cannula lies before you press."] =
        "Peu et bien placé : regardez où se trouve l'extrémité de la canule avant d'appuyer.",
    ["Time with the nucleus pushed forward"] = "Temps pendant lequel le noyau est poussé en avant",
    ["Press the nucleus back after each injection."] = "Repoussez le noyau en arrière après chaque injection.",
    ["Greatest strain of the posterior capsule, of what it bears"] =
        "Étirement maximal de la capsule postérieure, rapporté à ce qu'elle supporte",
    ["Stop as soon as the nucleus comes forward."] = "Arrêtez dès que le noyau avance.",

    -- T7
    ["Phaco probe and second instrument: insertion into the eye"] =
        "Sonde de phaco et second instrument : introduction dans l'œil",
    ["the wound is not simulated."] = "l'incision n'est pas simulée.",
    ["Attempts to bring the phaco probe in"] = "Tentatives d'introduire la sonde de phaco",
    ["Come to the wound slowly and along its tunnel."] = "Abordez l'incision lentement et dans l'axe de son tunnel.",
    ["Attempts to bring the second instrument in"] = "Tentatives d'introduire le second instrument",
    ["Leave the second instrument in the eye until the step that needs it is finished."] =
        "Laissez le second instrument dans l'œil jusqu'à la fin de l'étape qui le demande.",
    ["Touches of the iris before the first cut"] = "Contacts avec l'iris avant le premier passage",
    ["Lower the tip only when it has passed the edge of the pupil."] =
        "N'abaissez la pointe qu'une fois passé le bord de la pupille.",
    ["Times that the second instrument pressed on the capsule"] = "Appuis du second instrument sur la capsule",
    ["Keep the end of the second instrument inside the capsule's opening."] =
        "Gardez l'extrémité du second instrument en dedans de l'ouverture capsulaire.",
    ["Most of the chamber's depth that was lost before the first cut"] =
        "Perte maximale de profondeur de la chambre avant le premier passage",
    ["Let the irrigation run before the tip goes in, and do not press on the lip of the wound."] =
        "Faites couler l'irrigation avant d'entrer, et n'appuyez pas sur la lèvre de l'incision.",

    -- T8
    ["Phaco probe and second instrument: effective use and stability"] =
        "Sonde de phaco et second instrument : emploi efficace et stabilité",
    ["Ultrasound given with the tip in safe distance of iris, cornea and posterior capsule"] =
        "Ultrasons émis à distance sûre de l'iris, de la cornée et de la capsule postérieure",
    ["Let go of pedal position 3 before the tip leaves the lens's middle."] =
        "Quittez la position 3 de la pédale avant que la pointe ne quitte le centre du cristallin.",
    ["Ultrasound given while the tip touched no lens"] = "Ultrasons émis sans contact avec le cristallin",
    ["Give ultrasound only on the forward stroke and only in contact: it heats the wound and harms the endothelium."] =
        "N'émettez d'ultrasons qu'en avançant et au contact : ils chauffent l'incision et lèsent l'endothélium.",
    ["Least distance of the working tip from the corneal endothelium"] =
        "Distance minimale de la pointe active à l'endothélium cornéen",
    ["Work deeper, in the plane of the iris or behind it."] =
        "Travaillez plus profond, dans le plan de l'iris ou en arrière de lui.",
    ["Trembling of the tip (6 to 12 Hz)"] = "Tremblement de la pointe (6 à 12 Hz)",
    ["Rest the hand on the patient's forehead and steady the handpiece with the second hand."] =
        "Appuyez la main sur le front du patient et stabilisez la pièce à main avec l'autre main.",
    ["Trembling of the probe (6 to 12 Hz)"] = "Tremblement de la sonde (6 à 12 Hz)",
    ["Rest the hand on the patient's forehead, and hold the instrument near its tip."] =
        "Appuyez la main sur le front du patient, et tenez l'instrument près de sa pointe.",
    ["Change of the chamber's depth (standard deviation, share of its depth)"] =
        "Variation de la profondeur de la chambre (écart type, en part de sa profondeur)",
    ["Change the pedal gradually, and hold the probe so that the wound is not pried open."] =
        "Bougez la pédale progressivement, et tenez la sonde sans écarter l'incision.",
    ["Times that ultrasound was given far from any lens"] = "Émissions d'ultrasons loin du cristallin",
    ["Feel for the steps of the pedal: position 3 only with the tip at the lens."] =
        "Sentez les crans de la pédale : position 3 seulement la pointe au cristallin.",

    -- T9
    ["Nucleus: sculpting or primary chop"] = "Noyau : sculpture ou chop primaire",
    ["Depth of the groove as a share of the lens's thickness there"] =
        "Profondeur du sillon, en part de l'épaisseur du cristallin à cet endroit",
    ["Go on in thin layers until the reflex in the groove glows red."] =
        "Continuez en couches fines jusqu'à ce que la lueur rougeoie dans le sillon.",
    ["Stop when the reflex in the groove glows evenly: the last tenth cracks by itself."] =
        "Arrêtez quand la lueur est égale dans le sillon : le dernier dixième se fend tout seul.",
    ["Length of the groove"] = "Longueur du sillon",
    ["Begin each stroke nearer to yourself and end it nearer to the far edge of the pupil."] =
        "Commencez chaque passage plus près de vous et finissez-le plus près du bord opposé de la pupille.",
    ["Depth of the shallower groove as a share of the lens's thickness there"] =
        "Profondeur du sillon le moins profond, en part de l'épaisseur du cristallin à cet endroit",
    ["Go on in thin layers until both grooves glow alike."] =
        "Continuez en couches fines jusqu'à ce que les deux sillons luisent de même.",
    ["Stop when the reflex in the groove glows evenly."] = "Arrêtez quand la lueur est égale dans le sillon.",
    ["Angle between the grooves, off a right angle"] = "Angle entre les sillons, écart à l'angle droit",
    ["Turn the nucleus until the first groove lies across, and keep it there while you sculpt."] =
        "Tournez le noyau jusqu'à ce que le premier sillon soit en travers, et gardez-le ainsi pendant la "
            .. "sculpture.",
    ["Ultrasound energy (CDE) over what this nucleus needs"] =
        "Énergie ultrasonore (CDE), rapportée à ce que ce noyau demande",
    ["Give ultrasound on the forward stroke only, and no more than the nucleus asks for."] =
        "N'émettez d'ultrasons qu'en avançant, et pas plus que le noyau n'en demande.",
    ["Least distance of the working tip from the posterior capsule"] =
        "Distance minimale de la pointe active à la capsule postérieure",
    ["Follow the curve of the posterior capsule: shallower towards both ends of the groove."] =
        "Suivez la courbe de la capsule postérieure : moins profond vers les deux bouts du sillon.",
    ["Most that the lens was pushed"] = "Déplacement maximal du cristallin",
    ["Slow the stroke or give more power, so that the tip cuts and does not push."] =
        "Ralentissez ou donnez plus de puissance, pour que la pointe coupe sans pousser.",
    ["Time that the lens shut the mouth of the tip while it sculpted, in stretches of a second and more"] =
        "Temps d'occlusion de l'embout par le cristallin pendant la sculpture, par périodes d'une seconde et plus",
    ["Shave with half of the mouth free: a shut mouth holds the nucleus and pulls it."] =
        "Rabotez l'orifice à demi libre : obstrué, il retient le noyau et le tire.",

    -- T10
    ["Nucleus: rotation and manipulation"] = "Noyau : rotation et manipulation",
    ["the probe does not turn the nucleus."] = "la sonde ne tourne pas le noyau.",
    ["no phaco probe goes into the eye."] = "aucune sonde de phacoémulsification n'entre dans l'œil.",
    ["Turn of the nucleus"] = "Rotation du noyau obtenue",
    ["Push the wall of the groove farther from the middle of the lens, until the groove lies across."] =
        "Poussez la paroi du sillon plus loin du centre du cristallin, jusqu'à ce que le sillon soit en travers.",
    ["Most that a zonule was stretched by the second instrument"] =
        "Étirement maximal d'une zonule par le second instrument",
    ["Push along an arc about the middle of the lens, not straight across and not down."] =
        "Poussez suivant un arc autour du centre du cristallin, ni en travers ni vers le bas.",
    ["Most that the lens was shifted by the second instrument"] =
        "Déplacement maximal du cristallin par le second instrument",
    ["Turn the lens, do not shift it: push at a right angle to the line to its middle."] =
        "Tournez le cristallin sans le déplacer : poussez perpendiculairement à la ligne qui mène à son centre.",
    ["Greatest force on the posterior capsule"] = "Force maximale sur la capsule postérieure",
    ["Let the nucleus swim: lift it a little while it turns."] =
        "Laissez flotter le noyau : soulevez-le un peu pendant qu'il tourne.",

    -- T11
    ["Nucleus: cracking or chopping with safe phaco of segments"] =
        "Noyau : fracture ou chop et phaco sûre des segments",
    ["the nucleus is not divided."] = "le noyau n'est pas divisé.",
    ["no groove is sculpted."] = "aucun sillon n'est sculpté.",
    ["Nucleus that still bridges the groove"] = "Noyau qui ponte encore le sillon",
    ["Go back with both tips into the lower third, next to where the halves still hang together."] =
        "Revenez des deux pointes dans le tiers inférieur, là où les moitiés tiennent encore.",
    ["Parting done with both tips in the lower third of the groove"] =
        "Écartement fait des deux pointes dans le tiers inférieur du sillon",
    ["Put both tips on the floor of the groove before you part its walls."] =
        "Posez les deux pointes au fond du sillon avant d'en écarter les parois.",
    ["Part of the lens that was left"] = "Part du cristallin laissée",
    ["Go on until the bag is empty: draw the next piece to the middle as soon as one has cleared."] =
        "Continuez jusqu'à ce que le sac soit vide : amenez au centre le fragment suivant dès qu'un autre a "
            .. "disparu.",
    ["Losses of more than 30 % of the chamber's depth within a second"] =
        "Pertes de plus de 30 % de la profondeur de la chambre en une seconde",
    ["Ease the pedal as a piece is about to clear; less vacuum or a higher bottle."] =
        "Relâchez la pédale quand un fragment va passer ; moins de vide, ou le flacon plus haut.",
    ["Ultrasound at least 1.5 mm from the cornea and 1 mm from the capsule"] =
        "Ultrasons à au moins 1,5 mm de la cornée et 1 mm de la capsule",
    ["Draw the piece to the plane of the iris before emulsifying it."] =
        "Amenez le fragment dans le plan de l'iris avant de l'émulsifier.",
    ["Times that the capsule was in the tip"] = "Aspirations de la capsule dans l'embout",
    ["Keep the mouth turned away from the capsule while vacuum is high."] =
        "Gardez l'orifice détourné de la capsule tant que le vide est fort.",
    ["Growth of a hole in the posterior capsule, share of its first area"] =
        "Agrandissement d'un trou de la capsule postérieure, en part de sa surface initiale",
    ["Nothing may let the pressure fall: cover the hole before the tip leaves."] =
        "Rien ne doit faire chuter la pression : couvrez le trou avant que la pointe ne sorte.",
    ["Vitreous left in chamber and wound in the end"] = "Vitré laissé dans la chambre et l'incision à la fin",
    ["Cut until triamcinolone shows none, also in the wound."] =
        "Coupez jusqu'à ce qu'il ne reste plus de vitré marqué à la triamcinolone, dans l'incision non plus.",
    ["Time with vitreous in a mouth that did not cut"] = "Temps avec du vitré dans un orifice qui ne coupait pas",
    ["Cut before you aspirate."] = "Coupez avant d'aspirer.",
    ["Time with the instrument in the eye"] = "Temps avec l'instrument dans l'œil",
    ["Hold, draw and emulsify without letting go in between."] =
        "Saisissez, attirez et émulsifiez sans lâcher entre-temps.",

    -- T12
    ["Irrigation and aspiration with adequate removal of cortex"] =
        "Irrigation et aspiration, avec ablation suffisante du cortex",
    ["cortex is not aspirated."] = "le cortex n'est pas aspiré.",
    ["Cortex left in the end, of the bag's area"] = "Cortex laissé à la fin, en part de la surface du sac",
    ["Go round the whole fornix, the part under the incision last."] =
        "Faites tout le tour du cul-de-sac, la partie sous l'incision en dernier.",
    ["Times that the posterior capsule was drawn in"] = "Aspirations de la capsule postérieure",
    ["Keep the mouth up and in sight."] = "Gardez l'orifice en haut et visible.",
    ["The posterior capsule is open in the end (1: yes)"] = "Capsule postérieure ouverte à la fin (1 : oui)",
    ["Pedal up as soon as folds run to the tip."] = "Lâchez la pédale dès que des plis convergent vers la pointe.",
    ["Time with the mouth down and more than 50 mmHg"] = "Temps l'orifice en bas avec plus de 50 mmHg",
    ["Turn the mouth up before you press the pedal."] = "Tournez l'orifice vers le haut avant d'appuyer sur la pédale.",
    ["Strip along the capsule, not away from it."] = "Détachez le cortex le long de la capsule, sans tirer sur elle.",
    ["Time with the tip in the eye"] = "Temps avec la pointe dans l'œil",
    ["Hold, strip and aspirate in one movement, sector after sector."] =
        "Saisissez, détachez et aspirez d'un seul geste, secteur après secteur.",

    -- T14
    ["Wound closure"] = "Fermeture des incisions",
    ["What comes through the wounds at 20 mmHg in the end"] = "Ce qui sort des incisions à 20 mmHg à la fin",
    ["Hydrate, then suture, until nothing comes."] = "Hydratez, puis suturez, jusqu'à ce que rien ne sorte.",
    ["The same, with 0.28 N on the outer lips"] = "De même, avec 0,28 N sur les lèvres externes",
    ["Press on the lip as a finger would: a wound that opens then needs more."] =
        "Appuyez sur la lèvre comme le ferait un doigt : une incision qui s'ouvre alors demande davantage.",
    ["Pressure of the eye in the end"] = "Pression de l'œil à la fin",
    ["Fill the eye until it feels firm, not hard."] = "Remplissez l'œil jusqu'à ce qu'il soit ferme, pas dur.",
    ["The wound was tested after its last change (1: yes)"] =
        "Incision essayée après la dernière retouche (1 : oui)",
    ["Press on the lip and look, every time."] = "Appuyez sur la lèvre et regardez, chaque fois.",
    ["Viscoelastic left in the end"] = "Viscoélastique laissé à la fin",
    ["Aspirate behind the optic as well, and round the angle."] =
        "Aspirez aussi derrière l'optique, et tout autour de l'angle.",

    -- T3, T4, T5, T13
    ["Times that the implant jammed in the nozzle"] = "Blocages de l'implant dans la buse",
    ["Stop when the plunger gets heavy; do not force an implant through."] =
        "Arrêtez quand le piston devient dur ; ne forcez pas le passage d'un implant.",
    ["Viscoelastic: use and safe insertion"] = "Viscoélastique : emploi et injection sans risque",
    ["viscoelastic is not simulated."] = "le viscoélastique n'est pas simulé.",
    ["Chamber filled with viscoelastic when the capsule was opened"] =
        "Remplissage de la chambre par le viscoélastique à l'ouverture de la capsule",
    ["Fill until the chamber is deep and the capsule flat, before you open it."] =
        "Remplissez jusqu'à ce que la chambre soit profonde et la capsule plane, avant de l'ouvrir.",
    ["Least filling while the capsule was being torn"] = "Remplissage minimal pendant la déchirure de la capsule",
    ["Every instrument lets some out: fill again before the chamber gets shallow."] =
        "Chaque instrument en laisse sortir : remplissez de nouveau avant que la chambre ne s'aplatisse.",
    ["Greatest pressure in the eye"] = "Pression maximale dans l'œil",
    ["Press more gently, and stop when the chamber is full."] =
        "Appuyez plus doucement, et arrêtez quand la chambre est pleine.",
    ["Times that the cannula touched the capsule or the cornea"] = "Contacts de la canule avec la capsule ou la cornée",
    ["Keep the end of the cannula in the middle of the chamber's depth."] =
        "Gardez l'extrémité de la canule à mi-profondeur de la chambre.",
    ["Capsulorhexis: commencement of flap and follow-through"] = "Capsulorhexis : amorce du lambeau et poursuite",
    ["the capsule is already open."] = "la capsule est déjà ouverte.",
    ["Distance of the puncture from where it belongs, 0.9 mm from the middle"] =
        "Écart de la ponction par rapport à sa place, à 0,9 mm du centre",
    ["Look for the middle of the pupil before you pierce."] = "Repérez le centre de la pupille avant de ponctionner.",
    ["Punctures of the capsule"] = "Ponctions de la capsule",
    ["Once through, keep the needle's point under the capsule until the cut is done."] =
        "La capsule percée, gardez la pointe de l'aiguille dessous jusqu'à la fin de l'incision.",
    ["Deepest that the needle was in the cortex"] = "Profondeur maximale de l'aiguille dans le cortex",
    ["Only the point of the needle goes under the capsule."] = "Seule la pointe de l'aiguille passe sous la capsule.",
    ["Most that a zonule was stretched"] = "Étirement maximal d'une zonule",
    ["Pull in the plane of the capsule, no harder than it tears."] =
        "Tirez dans le plan de la capsule, pas plus fort qu'il ne faut pour la déchirer.",
    ["Capsulorhexis: formation and circular completion"] = "Capsulorhexis : réalisation et fermeture du cercle",
    ["Mean diameter of the opening"] = "Diamètre moyen de l'ouverture",
    ["Lead the flap farther out: the opening is too small to work through."] =
        "Menez le lambeau plus en dehors : l'ouverture est trop petite pour y travailler.",
    ["Lead the flap farther in: the rim must cover the edge of the implant."] =
        "Menez le lambeau plus en dedans : le bord doit recouvrir celui de l'implant.",
    ["Roundness of the opening (1: a circle)"] = "Rondeur de l'ouverture (1 : un cercle)",
    ["Turn the direction of the pull with the tear, a little at a time."] =
        "Faites tourner la traction avec la déchirure, petit à petit.",
    ["Distance of the opening's middle from the axis"] = "Distance du centre de l'ouverture à l'axe",
    ["Compare the tear with the edge of the pupil all the way round."] =
        "Comparez la déchirure au bord de la pupille sur tout le tour.",
    ["Part of the circle over which the rim covers the optic"] = "Part du cercle où le bord recouvre l'optique",
    ["Keep the tear within 3 mm of the middle everywhere."] = "Gardez partout la déchirure à moins de 3 mm du centre.",
    ["Tears that ran out to the zonules"] = "Déchirures parties vers la zonule",
    ["Stop and fill the chamber as soon as the tear turns outwards."] =
        "Arrêtez et remplissez la chambre dès que la déchirure file en dehors.",
    ["Times that the forceps took hold"] = "Prises de la pince",
    ["Take hold near the tear, and lead it as far as the jaws reach before you take hold anew."] =
        "Saisissez près de la déchirure, et menez-la aussi loin que possible avant de reprendre.",
    ["Time from the puncture to the closed circle"] = "Temps de la ponction au cercle fermé",
    ["Work without haste, but without pauses: know the next grasp before you let go."] =
        "Travaillez sans hâte mais sans pause : prévoyez la prise suivante avant de lâcher.",
    ["Time with the forceps outside the pupil"] = "Temps de la pince hors de la pupille",
    ["Keep the jaws over the red reflex, where you see the capsule."] =
        "Gardez les mors sur la lueur pupillaire, là où vous voyez la capsule.",
    ["Lens insertion, rotation and final position of the implant"] =
        "Insertion, rotation et position finale de l'implant",
    ["no implant is inserted."] = "aucun implant n'est posé.",
    ["Haptics that lie in the bag in the end"] = "Haptiques dans le sac à la fin",
    ["Turn the implant with the hook until the trailing haptic slips under the rim."] =
        "Tournez l'implant au crochet jusqu'à ce que l'haptique arrière glisse sous le bord.",
    ["Implant upside down in the end (1: yes)"] = "Implant à l'envers à la fin (1 : oui)",
    ["Watch how the leading haptic comes out, and turn the injector before the optic follows."] =
        "Regardez sortir la première haptique, et tournez l'injecteur avant que l'optique ne suive.",
    ["Distance of the optic's middle from the bag's axis in the end"] =
        "Distance finale du centre de l'optique à l'axe du sac",
    ["Push the optic to the middle, and see that it stays there when you let go."] =
        "Poussez l'optique au centre, et vérifiez qu'elle y reste quand vous lâchez.",
    ["Tilt of the optic in the bag in the end"] = "Inclinaison finale de l'optique dans le sac",
    ["Look whether both haptics lie in the bag's fold, and none on the optic."] =
        "Vérifiez que les deux haptiques sont dans le pli du sac, et aucune sur l'optique.",
    ["Most that an eighth of the bag's opening was stretched, over its length"] =
        "Étirement maximal d'un huitième du bord de l'ouverture, rapporté à sa longueur",
    ["Lead the haptic under the rim; do not press the optic or the nozzle against it."] =
        "Menez l'haptique sous le bord ; n'y appuyez ni l'optique ni la buse.",
    ["Times that the cornea or the posterior capsule was touched"] =
        "Contacts avec la cornée ou la capsule postérieure",
    ["Keep implant and instruments in the plane of the opening."] =
        "Gardez implant et instruments dans le plan de l'ouverture.",
    ["Least filling of the chamber while the implant came out"] =
        "Remplissage minimal de la chambre pendant la sortie de l'implant",
    ["Fill bag and chamber before you bring the injector in."] =
        "Remplissez sac et chambre avant d'introduire l'injecteur.",
}
