-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Capsulorhexis"] = "Capsulorhexis",
    ["Fill the chamber with viscoelastic, pierce the anterior capsule with the cystotome and cut the "
        .. "beginning of a flap, then take hold of it with the forceps and tear it round, so that the opening is "
        .. "a circle a little smaller than the optic of the implant."] =
        "Remplissez la chambre de viscoélastique, percez la capsule antérieure au kystitome et amorcez un "
            .. "lambeau, puis saisissez-le à la pince et déchirez-le en rond : l'ouverture doit être un cercle un "
            .. "peu plus petit que l'optique de l'implant.",
    ["Fill the chamber before the capsule is opened, so that it lies flat"] =
        "Remplir la chambre avant d'ouvrir la capsule, pour qu'elle soit plane",
    ["Take hold of the flap near the end of the tear, again and again, and lead it round"] =
        "Reprendre sans cesse le lambeau près de l'extrémité de la déchirure, et le mener en rond",
    ["See a tear that runs outwards while it can still be put right"] =
        "Voir filer une déchirure en dehors tant qu'elle peut encore être corrigée",
    ["Fill the chamber"] = "Remplir la chambre",
    ["Bring the cannula over the lens and press, until the chamber is deep and the capsule lies flat."] =
        "Amenez la canule au-dessus du cristallin et appuyez, jusqu'à ce que la chambre soit profonde et la "
            .. "capsule plane.",
    ["Pierce the capsule and begin the flap"] = "Percer la capsule et amorcer le lambeau",
    ["With the cystotome: through the capsule a millimetre from its middle, outwards to the planned "
        .. "circle, and a quarter of the way round along it."] =
        "Au kystitome : percez la capsule à un millimètre de son centre, allez en dehors jusqu'au cercle "
            .. "prévu, et suivez-le sur un quart de tour.",
    ["Tear the flap round"] = "Déchirer le lambeau en rond",
    ["With the forceps: fold the flap over, take hold of it near the end of the tear, lead it round in the "
        .. "plane of the capsule, and take hold anew before the tear is far from the jaws."] =
        "À la pince : rabattez le lambeau, saisissez-le près de l'extrémité de la déchirure, menez-le en rond "
            .. "dans le plan de la capsule, et reprenez-le avant que la déchirure ne s'éloigne des mors.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Take the flap out with the forceps. Compare the opening with the plan before you leave."] =
        "Retirez le lambeau à la pince. Comparez l'ouverture au plan avant de sortir.",
    ["Opening recorded"] = "Ouverture notée",
    ["size and place of the opening go on record, and lens and place of the optic are chosen by them"] =
        "la taille et la place de l'ouverture sont notées, l'implant et la place de l'optique choisis d'après elles",
    ["On record: the lens is chosen by it."] = "C'est noté : l'implant est choisi en conséquence.",
    ["Underfilled"] = "Chambre insuffisamment remplie",
    ["Weak zonules declared"] = "Zonule fragile signalée",
    ["the zonules are weak: hooks or a ring before the nucleus is touched"] =
        "la zonule est fragile : crochets ou anneau avant de toucher au noyau",
    ["Hooks and a ring are laid out."] = "Les crochets et un anneau sont préparés.",
    ["Wrinkles at the puncture"] = "Plis à la ponction",
    ["Spokes run out from the needle, and the lens sinks before the capsule is pierced."] =
        "Des plis rayonnent autour de l'aiguille, et le cristallin s'enfonce avant que la capsule ne soit percée.",
    ["Wrinkles at the puncture tell of weak zonules: say so, and have hooks or a ring ready before the nucleus is "
        .. "touched."] =
        "Des plis à la ponction trahissent une zonule fragile : signalez-le, et faites préparer des crochets ou un "
            .. "anneau avant de toucher au noyau.",
    ["Tear runs out"] = "La déchirure file",
    ["The leading edge drifts outwards, and the flap hides where it hangs."] =
        "Le front de déchirure dérive en dehors, et le lambeau cache son attache.",
    ["Stop. Fill the chamber, unfold the flap so that it lies flat, take hold of it close to the tear, "
        .. "pull back along the way it came, in the plane of the capsule, and then to the middle."] =
        "Arrêtez. Remplissez la chambre, dépliez le lambeau à plat, saisissez-le près de la déchirure, tirez "
            .. "en arrière le long du trajet déjà fait, dans le plan de la capsule, puis vers le centre.",
    ["Opening too small"] = "Ouverture trop petite",
    ["Beside the pupil and the marks on the forceps the opening is narrow."] =
        "Comparée à la pupille et aux repères de la pince, l'ouverture est étroite.",
    ["A narrow rim splits under the tip or the implant. Cut from the rim outwards, take hold of the new flap, "
        .. "and lead it round in a spiral to the planned circle."] =
        "Un bord étroit se fend sous la sonde ou l'implant. Incisez à partir du bord, saisissez le nouveau "
            .. "lambeau, et menez-le en spirale jusqu'au cercle prévu.",
    ["Opening too large"] = "Ouverture trop grande",
    ["The rim is close to the edge of the pupil, and will not lie before the optic."] =
        "Le bord est proche de celui de la pupille, et ne recouvrira pas l'optique.",
    ["Have it recorded: the rim does not hold the optic all round. Choose the lens and where its optic goes by "
        .. "that."] =
        "Faites-le noter : le bord ne tient pas l'optique sur tout son tour. Choisissez l'implant et la place de "
            .. "son optique en conséquence.",
    ["Opening off-centre"] = "Ouverture décentrée",
    ["The rim is nearer to the pupil's edge on one side than on the other."] =
        "Le bord est plus près de celui de la pupille d'un côté que de l'autre.",
    ["Where the rim is near the middle, cut it outwards and lead a second flap along the planned circle. Where "
        .. "that would make the opening too wide, have it recorded and place the optic by it."] =
        "Là où le bord est près du centre, incisez-le en dehors et menez un second lambeau le long du cercle "
            .. "prévu. Si l'ouverture en devenait trop grande, faites-le noter et placez l'optique en conséquence.",
    ["Needle too deep"] = "Aiguille trop profonde",
    ["White shreds of cortex rise around the needle."] =
        "Des lambeaux blancs de cortex montent autour de l'aiguille.",
    ["Too deep: lift the needle until only its point is under the capsule."] =
        "Trop profond : remontez l'aiguille jusqu'à ce que seule sa pointe soit sous la capsule.",
    ["wide pupil, chamber already filled"] = "pupille large, chambre déjà remplie",
    ["narrow pupil, no hints"] = "pupille étroite, sans conseils",
}
