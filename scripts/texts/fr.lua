-- SPDX-License-Identifier: GPL-3.0-or-later
-- French words of the engine, of the OSACSS items of capsulorhexis and implant, and of the report. Keys are the English
-- texts, letter for letter.

return {
    -- engine
    ["Step \"%s\" completed."] = "Étape « %s » accomplie.",
    ["Step \"%s\" not completed."] = "Étape « %s » non accomplie.",
    ["Error: %s."] = "Erreur : %s.",
    ["Put right after %.1f s: %s."] = "Corrigé après %.1f s : %s.",
    ["End of the exercise."] = "Fin de l'exercice.",
    ["Before the first step."] = "Avant le premier instant.",
    ["Asked and declared"] = "Demandé et déclaré",
    ["At the end."] = "À la fin.",

    -- rubric: reasons
    ["a near miss, put right at once"] = "erreur évitée de justesse, corrigée aussitôt",
    ["put right"] = "corrigée",
    ["not put right in time"] = "non corrigée à temps",
    ["not put right yet"] = "pas encore corrigée",
    [" and once more"] = " et une fois de plus",
    [" and %d times more"] = " et %d fois de plus",
    ["%s at %.1f s%s, %s: at most %d points."] = "%s à %.1f s%s, %s : %d points au plus.",
    ["5 points at %s, 3 at %s, 1 at %s"] = "5 points à %s, 3 à %s, 1 à %s",
    ["%s to %s"] = "%s à %s",
    ["%s or %s"] = "%s ou %s",
    ["%s: %s (%s)"] = "%s : %s (%s)",
    ["All measures in the range for full points."] = "Toutes les mesures valent le maximum de points.",
    ["Not scored: "] = "Non noté : ",
    ["nothing that this attempt showed tells of it."] = "rien dans cet essai ne permet d'en juger.",
    ["needs teaching"] = "à former",
    ["supervised"] = "sous supervision",
    ["independent"] = "autonome",
    ["scores like surgeons with fewer than 50 operations"] = "note de chirurgiens ayant moins de 50 opérations",
    ["scores like surgeons with 50 to 249 operations"] = "note de chirurgiens ayant 50 à 249 opérations",
    ["scores like surgeons with 250 operations or more"] = "note de chirurgiens ayant 250 opérations ou plus",

    -- rubric: items
    ["Prolapse of the iris (0: none, 1: put back, 2: left in the wound)"] =
        "Prolapsus de l'iris (0 : aucun, 1 : remis en place, 2 : laissé dans l'incision)",
    ["Lower the pressure before an instrument leaves; lower it through the side port, and stroke over the lip."] =
        "Baissez la pression avant de sortir un instrument ; baissez-la par la contre-incision, et massez la lèvre.",
    ["Damage of the prolapsed iris by pushes"] = "Lésions de l'iris prolabé par les poussées",
    ["Never push a prolapsed iris back through the wound."] =
        "Ne repoussez jamais un iris prolabé par l'incision.",
    ["Times that the implant jammed in the nozzle"] = "Blocages de l'implant dans la buse",
    ["Stop when the plunger gets heavy; do not force an implant through."] =
        "Arrêtez quand le piston devient dur ; ne forcez pas le passage d'un implant.",
    ["Longest time that the pupil was out of focus"] = "Plus longue durée pendant laquelle la pupille était floue",
    ["Refocus with the foot as soon as the edge of the pupil blurs, not at the next pause."] =
        "Refaites la mise au point au pied dès que le bord de la pupille devient flou, sans attendre une pause.",
    ["nothing here comes near the cornea."] = "rien ici n'approche la cornée.",
    ["Touches of the back of the cornea by the probe"] = "Contacts de la sonde avec la face postérieure de la cornée",
    ["Stay well below the dome of the cornea."] = "Restez bien au-dessous du dôme de la cornée.",
    ["Burn of the wound (0: none, 1: shrunk as far as it goes)"] =
        "Brûlure de l'incision (0 : aucune, 1 : rétraction maximale)",
    ["Never give ultrasound without flow: stop when the mouth stays shut."] =
        "Jamais d'ultrasons sans flux : arrêtez quand l'embout reste obstrué.",
    ["Time with a tip under the iris, where it cannot be seen"] =
        "Temps avec une extrémité sous l'iris, là où on ne la voit pas",
    ["Work where you see: inside the edge of the pupil."] =
        "Travaillez là où vous voyez : en dedans du bord pupillaire.",
    ["Times that the iris was drawn into the tip"] = "Aspirations de l'iris dans l'embout",
    ["Let go of the pedal at once: pulling tears the iris, ultrasound eats it."] =
        "Lâchez aussitôt la pédale : tirer déchire l'iris, les ultrasons le détruisent.",
    ["Length of the iris's edge that was torn"] = "Longueur du bord de l'iris déchirée",
    ["Set the iris free by the pedal, never by pulling."] = "Libérez l'iris par la pédale, jamais en tirant.",
    ["Fewer and straighter movements; do not search with the tip."] =
        "Des gestes moins nombreux et plus directs ; ne cherchez pas avec l'extrémité.",
    ["Movements, as a multiple of what an expert needs"] = "Nombre de gestes, rapporté à celui d'un expert",
    ["Know the next two movements before you begin the first."] =
        "Connaissez les deux gestes suivants avant de commencer le premier.",
    ["Time in which all instruments rested for more than 2 s"] =
        "Temps pendant lequel tous les instruments sont restés immobiles plus de 2 s",
    ["Plan before you go in; inside, go on."] = "Préparez-vous avant d'entrer ; à l'intérieur, avancez.",
    ["Jerk of the tips without tremor (RMS), as a multiple of an expert's"] =
        "À-coups des extrémités sans le tremblement (RMS), rapportés à ceux d'un expert",
    ["Begin and end every movement gently."] = "Commencez et terminez chaque geste en douceur.",
    ["Entries into the eye, as a multiple of what an expert needs"] =
        "Entrées dans l'œil, rapportées à celles d'un expert",
    ["Leave the instrument in the eye until its step is finished."] =
        "Laissez l'instrument dans l'œil jusqu'à la fin de son étape.",
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
        "Faites tourner la traction avec la déchirure, peu à la fois.",
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
    ["Implant upside down in the end"] = "Implant à l'envers à la fin",
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
    ["Eye positioned centrally within microscope view"] = "Œil centré dans le champ du microscope",
    ["the microscope is not moved."] = "le microscope n'est pas mobile.",
    ["Distance of the pupil from the middle of the field, share of its radius"] =
        "Distance de la pupille au centre du champ, en part de son rayon",
    ["Bring the eye into the middle before you go in, and again when it has left it."] =
        "Centrez l'œil avant d'entrer, et de nouveau quand il s'est écarté.",
    ["Time with all of the pupil in view"] = "Temps avec toute la pupille dans le champ",
    ["Move the microscope as soon as an edge of the pupil leaves the field."] =
        "Déplacez le microscope dès qu'un bord de la pupille sort du champ.",
    ["Time with the pupil in focus"] = "Temps avec la pupille au point",
    ["Focus on the edge of the pupil before you go in."] = "Faites le point sur le bord de la pupille avant d'entrer.",
    ["Conjunctival and corneal tissue handling"] = "Respect de la conjonctive et de la cornée",
    ["Ultrasound within 1 mm of the corneal endothelium"] = "Ultrasons à moins de 1 mm de l'endothélium cornéen",
    ["Wait with ultrasound until the tip is well below the cornea."] =
        "N'émettez d'ultrasons que la pointe bien au-dessous de la cornée.",
    ["Touches of the back of the cornea"] = "Contacts avec la face postérieure de la cornée",
    ["Go in flat along the tunnel, then down to the lens."] =
        "Entrez à plat dans le tunnel, puis descendez vers le cristallin.",
    ["Touches of the back of the cornea by implant, injector or hook"] =
        "Contacts de l'implant, de l'injecteur ou du crochet avec la face postérieure de la cornée",
    ["Let the implant unfold deep in the bag, and keep the hook low."] =
        "Laissez l'implant se déplier au fond du sac, et gardez le crochet bas.",
    ["Intraocular spatial awareness"] = "Perception de l'espace intraoculaire",
    ["Touches of the iris"] = "Contacts avec l'iris",
    ["Look at the shaft and at the pupil's edge as well as at the tip."] =
        "Regardez la tige et le bord de la pupille autant que la pointe.",
    ["Touches of the posterior capsule with the tip"] = "Contacts de la pointe avec la capsule postérieure",
    ["Stop deepening while there is still a plate of lens."] =
        "Cessez de creuser tant qu'il reste une lame de cristallin.",
    ["Time with the tip in safe distance of iris and posterior capsule"] =
        "Temps avec la pointe à distance sûre de l'iris et de la capsule postérieure",
    ["Keep the working tip in the middle of the pupil, and judge its depth by the reflex."] =
        "Gardez la pointe au milieu de la pupille, et jugez sa profondeur à la lueur pupillaire.",
    ["Times that an instrument pressed on the back of the bag"] = "Appuis d'un instrument sur le fond du sac",
    ["Judge the depth by the optic: stay at its front."] = "Jugez la profondeur à l'optique : restez devant elle.",
    ["Least distance from the posterior capsule while aspirating"] =
        "Distance minimale à la capsule postérieure pendant l'aspiration",
    ["Let go to pedal position 1 whenever you are unsure of the depth."] =
        "Revenez en position 1 de la pédale dès que vous doutez de la profondeur.",
    ["Iris protection"] = "Protection de l'iris",
    ["Turn back before the pupil's edge, and keep the shaft above the iris."] =
        "Faites demi-tour avant le bord de la pupille, et gardez la tige au-dessus de l'iris.",
    ["Time in touch with the iris"] = "Temps de contact avec l'iris",
    ["When you touch the iris, stop and draw back at once."] = "Si vous touchez l'iris, arrêtez et reculez aussitôt.",
    ["Overall speed and fluidity of procedure"] = "Rapidité et fluidité de l'ensemble",
    ["Time, as a multiple of what an expert needs"] = "Temps, en multiple de celui d'un expert",
    ["Plan the next stroke while the tip comes back."] = "Préparez le geste suivant pendant le retour de la pointe.",
    ["Way of the tip, as a multiple of what an expert needs"] = "Trajet de la pointe, en multiple de celui d'un expert",
    ["Fewer and straighter strokes; do not search with the tip."] =
        "Des gestes moins nombreux et plus droits ; ne cherchez pas avec la pointe.",
    ["Way of the instruments, as a multiple of what an expert needs"] =
        "Trajet des instruments, en multiple de celui d'un expert",
    ["Fewer grasps and straighter ways between them."] = "Moins de prises, et des trajets plus droits entre elles.",
    ["Turn the implant in one sweep, and do not search with the hook."] =
        "Tournez l'implant d'un seul geste, et ne cherchez pas avec le crochet.",
    ["Entries of the injector into the eye"] = "Entrées de l'injecteur dans l'œil",
    ["Leave the injector in the eye until the implant is out of it."] =
        "Laissez l'injecteur dans l'œil jusqu'à ce que l'implant en soit sorti.",
    ["Entries into the eye"] = "Entrées dans l'œil",
    ["Leave the instrument in the eye until the step is finished."] =
        "Laissez l'instrument dans l'œil jusqu'à la fin de l'étape.",

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
    ["All %d steps were completed."] = "Les %d étapes ont toutes été accomplies.",
    ["%d of %d steps were completed%s."] = "%d étapes sur %d ont été accomplies%s.",
    ["; not completed: "] = " ; non accomplies : ",
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

    -- report: charts of capsulorhexis and implant
    ["Gap between instrument and iris"] = "Écart entre instrument et iris",
    ["gap"] = "écart",
    ["End of the tear: how far from the middle"] = "Extrémité de la déchirure : distance au centre",
    ["distance"] = "distance",
    ["How far the tear has come round"] = "Avancée de la déchirure sur le tour",
    ["angle"] = "angle",
    ["degrees"] = "degrés",
    ["How full the chamber is"] = "Remplissage de la chambre",
    ["viscoelastic"] = "viscoélastique",
    ["Pull of the forceps"] = "Traction de la pince",
    ["force"] = "force",
    ["How far the implant is out, and how far it is unfolded"] = "Sortie et dépliement de l'implant",
    ["out of the nozzle"] = "sorti de la buse",
    ["unfolded"] = "déplié",
    ["How far the implant lies from the bag's axis"] = "Distance de l'implant à l'axe du sac",
    ["How far the implant is tilted"] = "Inclinaison de l'implant",
    ["tilt"] = "inclinaison",
    ["How far the edge of the opening is stretched, of its length"] =
        "Étirement du bord de l'ouverture, rapporté à sa longueur",
    ["most stretched eighth"] = "huitième le plus étiré",
    ["Force on the plunger"] = "Force sur le piston",
    ["Brightness of the red reflex"] = "Éclat de la lueur pupillaire",
    ["0 dark, 1 full"] = "0 sombre, 1 plein",
    ["at the tip"] = "à la pointe",
    ["over the pupil"] = "sur la pupille",
    ["Way of the tear"] = "Trajet de la déchirure",
    ["Way of the tip"] = "Trajet de la pointe",
    ["%s, seen from above (the surgeon sits below)"] = "%s, vu d'en haut (le chirurgien est en bas)",
    ["with ultrasound"] = "avec ultrasons",
    ["without"] = "sans",
    ["led by the forceps"] = "menée à la pince",
    ["cut"] = "coupée",
    ["optic"] = "optique",
    ["planned"] = "prévu",
}
