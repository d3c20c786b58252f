-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: the items G1 to G6 of OSACSS and their measures.

return {
    -- G1
    ["Wound neutrality and minimising eye rolling and corneal distortion"] =
        "Neutralité de l'incision, sans rotation de l'œil ni déformation de la cornée",
    ["the wound and the rolling of the eye are not simulated."] =
        "l'incision et la rotation de l'œil ne sont pas simulées.",
    ["Roll of the eye while instruments were in it (RMS)"] = "Rotation de l'œil avec des instruments dedans (RMS)",
    ["Turn the instrument about its wound: the wound is the pivot and stays where it is."] =
        "Tournez l'instrument autour de son incision : elle est le pivot et ne bouge pas.",
    ["Shaft off the middle of its wound (mean)"] = "Écart de la tige au milieu de son incision (moyenne)",
    ["When the tip goes to one side, the hand goes to the other."] =
        "Quand la pointe va d'un côté, la main va de l'autre.",
    ["Most that the cornea was bent beside a wound"] = "Flexion maximale de la cornée à côté d'une incision",
    ["Look for folds of the cornea at the wound, and ease the hand."] =
        "Guettez les plis de la cornée à l'incision, et relâchez la main.",
    ["By which a wound was stretched"] = "Élargissement d'une incision",
    ["Do not lever an instrument in its wound."] = "Ne faites pas levier dans l'incision.",

    -- G2 to G6
    ["Prolapse of the iris (0: none, 1: put back, 2: left in the wound)"] =
        "Prolapsus de l'iris (0 : aucun, 1 : remis en place, 2 : laissé dans l'incision)",
    ["Lower the pressure before an instrument leaves; lower it through the side port, and stroke over the lip."] =
        "Baissez la pression avant de sortir un instrument ; baissez-la par la contre-incision, et massez la lèvre.",
    ["Damage of the prolapsed iris by pushes"] = "Lésions de l'iris prolabé par les poussées",
    ["Never push a prolapsed iris back through the wound."] =
        "Ne repoussez jamais un iris prolabé par l'incision.",
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
}
