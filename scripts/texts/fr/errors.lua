-- SPDX-License-Identifier: GPL-3.0-or-later
-- French: errors that several exercises share.

return {
    -- hydrodissection, cortex, viscoelastic
    ["No wave or no rotation"] = "Ni onde ni rotation",
    ["No dark front crosses the red reflex; the nucleus does not turn, or the whole bag turns with it."] =
        "Aucun front sombre ne traverse la lueur pupillaire ; le noyau ne tourne pas, ou tout le sac tourne avec "
            .. "lui.",
    ["Do not force it to turn. Bring the cannula under the rim at another quadrant, its end close to the capsule, "
        .. "lift it a little and inject steadily until the wave crosses. Then turn by 90 degrees."] =
        "Ne forcez pas la rotation. Amenez la canule sous le bord dans un autre quadrant, l'extrémité près de la "
            .. "capsule, soulevez-le un peu et injectez régulièrement jusqu'au passage de l'onde. Tournez ensuite "
            .. "de 90 degrés.",
    ["Capsular block"] = "Blocage capsulaire",
    ["The nucleus bulges forward, the pupil widens, the chamber gets shallow."] =
        "Le noyau bombe en avant, la pupille s'élargit, la chambre s'aplatit.",
    ["Stop injecting. Press gently on the middle of the nucleus until the trapped fluid has come out past it, and "
        .. "let viscoelastic out of the chamber, before you inject again."] =
        "Cessez d'injecter. Appuyez doucement au centre du noyau jusqu'à ce que le liquide piégé soit ressorti, et "
            .. "laissez sortir du viscoélastique de la chambre, avant d'injecter de nouveau.",
    ["Hydrorupture"] = "Rupture hydraulique",
    ["The widened pupil suddenly snaps smaller, the chamber deepens, and the nucleus tilts back."] =
        "La pupille élargie se resserre soudain, la chambre s'approfondit, et le noyau bascule en arrière.",
    ["Stop at once, and do not turn the nucleus. Viscoelastic under it until it lies level again; then bring it "
        .. "forward, or go on with low flow and a low bottle."] =
        "Arrêtez aussitôt, et ne tournez pas le noyau. Injectez du viscoélastique dessous jusqu'à ce qu'il soit de "
            .. "nouveau horizontal ; puis amenez-le en avant, ou continuez à bas débit, flacon bas.",
    ["Posterior capsule drawn in"] = "Capsule postérieure aspirée",
    ["Folds run like a star to the tip."] = "Des plis convergent en étoile vers la pointe.",
    ["Pedal up at once, and do not pull away. Turn the mouth up, so that you see it, before you aspirate again."] =
        "Lâchez aussitôt la pédale, sans tirer. Tournez l'orifice vers le haut, pour le voir, avant d'aspirer de "
            .. "nouveau.",
    ["Cortex left"] = "Cortex laissé",
    ["White tags hang in the fornix when the tip has left."] =
        "Des lambeaux blancs pendent dans le cul-de-sac quand la pointe est sortie.",
    ["Go in again. Hold each tag in the fornix, draw it towards the middle along the capsule, and aspirate it there."] =
        "Rentrez. Saisissez chaque lambeau dans le cul-de-sac, tirez-le vers le centre le long de la capsule, et "
            .. "aspirez-le là.",
    ["Viscoelastic left behind the implant"] = "Viscoélastique laissé derrière l'implant",
    ["The implant floats, and moves when it is touched."] = "L'implant flotte, et bouge quand on le touche.",
    ["Go in again, bring the tip behind the optic, or rock the optic with it, and aspirate until the implant lies "
        .. "still on the capsule. What is left raises the pressure in the days after."] =
        "Rentrez, passez la pointe derrière l'optique, ou faites-la basculer, et aspirez jusqu'à ce que l'implant "
            .. "repose immobile sur la capsule. Ce qui reste élève la pression les jours suivants.",

    -- wounds
    ["Tunnel too short"] = "Tunnel trop court",
    ["The lip gapes, fluid comes at the wound, the chamber gets shallow."] =
        "La lèvre bâille, du liquide sort de l'incision, la chambre s'aplatit.",
    ["The tunnel is too short. Hydrate it, then suture it, until it is tight; or close it and cut a new one two "
        .. "clock hours away."] =
        "Le tunnel est trop court. Hydratez-le, puis suturez-le, jusqu'à ce qu'il soit étanche ; ou fermez-le et "
            .. "faites-en un autre à deux heures de là.",
    ["Tunnel too long"] = "Tunnel trop long",
    ["Folds in the cornea over the tip, which is hard to lower."] =
        "Des plis de la cornée au-dessus de la pointe, qu'on a peine à abaisser.",
    ["The tunnel is too long: the tip will point at the cornea and fold it. Cut a new one two clock hours away, "
        .. "and leave this one shut."] =
        "Le tunnel est trop long : la pointe visera la cornée et la plissera. Faites-en un autre à deux heures de "
            .. "là, et laissez celui-ci fermé.",
    ["Posterior entry"] = "Entrée postérieure",
    ["The iris lies at the inner lip at once."] = "L'iris se présente aussitôt à la lèvre interne.",
    ["You came in too far back. Out with the blade, do not push the iris; close this wound with a suture, and cut "
        .. "a new one two clock hours away."] =
        "Vous êtes entré trop en arrière. Sortez la lame sans pousser l'iris ; fermez cette incision d'un point, "
            .. "et faites-en une autre à deux heures de là.",
    ["Descemet's membrane peeled"] = "Membrane de Descemet décollée",
    ["A clear curled flap at the inner lip."] = "Un lambeau transparent et enroulé à la lèvre interne.",
    ["You push Descemet's membrane off. Draw back, come in again with the tip turned down, and lay the flap flat "
        .. "with viscoelastic under it."] =
        "Vous décollez la membrane de Descemet. Reculez, rentrez la pointe tournée vers le bas, et appliquez le "
            .. "lambeau à plat avec du viscoélastique dessous.",
    ["Leak"] = "Fuite",
    ["Fluid comes at the lip, the eye gets soft and the chamber shallow."] =
        "Du liquide sort à la lèvre, l'œil devient mou et la chambre étroite.",
    ["The wound leaks. Hydrate its stroma on both sides; if it leaks still, suture it. Then press on the lip and "
        .. "look again."] =
        "L'incision fuit. Hydratez-en le stroma des deux côtés ; si elle fuit encore, suturez-la. Puis appuyez sur "
            .. "la lèvre et regardez de nouveau.",
    ["Suprachoroidal bleeding"] = "Hémorragie suprachoroïdienne",
    ["The eye hardens, the chamber gets shallow, the reflex darkens."] =
        "L'œil durcit, la chambre s'aplatit, la lueur s'assombrit.",
    ["Bleeding behind the choroid: everything out, and close the wounds at once. The pressure of a closed eye "
        .. "stops it."] =
        "Saignement derrière la choroïde : tout dehors, et fermez aussitôt les incisions. La pression d'un œil "
            .. "fermé l'arrête.",

    -- phaco
    ["Chamber collapse"] = "Effondrement de la chambre",
    ["Iris and capsule rush forward, the cornea folds."] =
        "L'iris et la capsule se précipitent en avant, la cornée se plisse.",
    ["The chamber is empty: pedal to 1, bottle up, and look whether the tubing or the wound leaks."] =
        "La chambre est vide : pédale en 1, flacon plus haut, et voyez si la tubulure ou l'incision fuit.",
    ["Surge"] = "Surge",
    ["The iris and the capsule bounce as the piece clears."] =
        "L'iris et la capsule rebondissent quand le fragment passe.",
    ["Surge: pedal to 1 at once and let the chamber fill. Less vacuum, or a higher bottle, before you go on."] =
        "Surge : pédale en 1 aussitôt, et laissez la chambre se remplir. Moins de vide, ou le flacon plus haut, "
            .. "avant de continuer.",
    ["Capsule in the tip"] = "Capsule dans l'embout",
    ["The capsule is in the tip: let go of the pedal, and do not pull away while it is held."] =
        "La capsule est dans l'embout : lâchez la pédale, et ne tirez pas tant qu'elle est retenue.",
    ["Infusion off"] = "Irrigation arrêtée",
    ["Nothing flows through the bottle's drip chamber, and the chamber does not deepen."] =
        "Rien ne coule dans la chambre compte-gouttes du flacon, et la chambre ne s'approfondit pas.",
    ["Ultrasound without flow heats the wound: let go of ultrasound at once, open the infusion, and see that it "
        .. "flows before you go on."] =
        "Les ultrasons sans flux chauffent l'incision : arrêtez-les aussitôt, ouvrez l'irrigation, et vérifiez "
            .. "qu'elle coule avant de continuer.",
    ["Wound burn"] = "Brûlure de l'incision",
    ["The edge of the wound turns white, milky fluid stands at the tip."] =
        "Le bord de l'incision blanchit, un liquide laiteux stagne à la pointe.",
    ["The wound burns: ultrasound off at once, and let cool fluid through: infusion open, tip free. Look why "
        .. "nothing flowed before you go on, and close the wound with a suture in the end."] =
        "L'incision brûle : arrêtez aussitôt les ultrasons et laissez passer du liquide frais, irrigation ouverte, "
            .. "pointe libre. Cherchez pourquoi rien ne coulait avant de continuer, et fermez l'incision d'un "
            .. "point à la fin.",
    ["Capsule torn"] = "Capsule déchirée",
    ["The chamber deepens suddenly, the pupil widens for a moment, a round clear edge shows."] =
        "La chambre s'approfondit soudain, la pupille s'élargit un instant, un bord rond et net apparaît.",
    ["The posterior capsule is torn: stay in with irrigation only, no vacuum, no ultrasound; fill the chamber, "
        .. "then leave. Do not chase what sinks."] =
        "La capsule postérieure est déchirée : restez avec l'irrigation seule, ni vide ni ultrasons ; remplissez "
            .. "la chambre, puis sortez. Ne poursuivez pas ce qui tombe.",
    ["Dropped piece"] = "Fragment tombé",
    ["A piece grows dim and small, and tumbles away behind the capsule."] =
        "Un fragment pâlit, rapetisse et bascule derrière la capsule.",
    ["The piece is in the vitreous: do not chase it. Irrigation only, tip up and out of the depth; it is taken out "
        .. "from behind, later."] =
        "Le fragment est dans le vitré : ne le poursuivez pas. Irrigation seule, la pointe en haut et hors de la "
            .. "profondeur ; on l'enlèvera plus tard, par l'arrière.",

    -- capsulorhexis
    ["The chamber is shallow, the lens comes forward, and the capsule is domed."] =
        "La chambre est étroite, le cristallin avance et la capsule est bombée.",
    ["Fill the chamber before you go on: a domed capsule tears outwards."] =
        "Remplissez la chambre avant de continuer : une capsule bombée se déchire en dehors.",
    ["Overfilled"] = "Chambre trop remplie",
    ["The eye is hard, the iris bulges towards the wound."] = "L'œil est dur, l'iris bombe vers l'incision.",
    ["Too much: stop pressing, and let some out through the wound before you go on."] =
        "Trop : cessez d'appuyer, et laissez-en sortir par l'incision avant de continuer.",
    ["Edge lost"] = "Bord perdu",
    ["The end of the tear is gone behind the iris."] = "L'extrémité de la déchirure a disparu derrière l'iris.",
    ["Do not pull on: let go and fill the chamber. Then begin again from the other end of the cut and lead the new "
        .. "tear into the old one, gently, without pressing fluid under the edge."] =
        "Ne tirez plus : lâchez et remplissez la chambre. Repartez ensuite de l'autre bout de l'incision et menez "
            .. "doucement la nouvelle déchirure dans l'ancienne, sans injecter de liquide sous le bord.",

    -- cracking
    ["Incomplete split"] = "Fracture incomplète",
    ["The halves hang together: the bright line in the floor of the groove stops before its ends."] =
        "Les moitiés tiennent encore : la ligne brillante au fond du sillon s'arrête avant ses bouts.",
    ["The split is not complete: go back with both tips into the lower third, next to where the halves still hang "
        .. "together, and part again."] =
        "La fracture n'est pas complète : revenez des deux pointes dans le tiers inférieur, là où les moitiés tiennent "
            .. "encore, et écartez de nouveau.",
    ["Tips too shallow"] = "Pointes trop hautes",
    ["The walls lean outwards above, the floor stays shut."] = "Les parois s'écartent en haut, le fond reste fermé.",
    ["The tips are too high: close them, go down to the lower third of the groove, then part."] =
        "Les pointes sont trop hautes : rapprochez-les, descendez dans le tiers inférieur du sillon, puis écartez.",
    ["Pushing the nucleus"] = "Noyau poussé",
    ["The whole lens moves away from the instruments."] = "Tout le cristallin s'éloigne des instruments.",
    ["You push the nucleus instead of parting it: let go, let it come back, and part with both tips at the same place, "
        .. "by the same amount."] =
        "Vous poussez le noyau au lieu de le fendre : lâchez, laissez-le revenir, et écartez des deux pointes au même "
            .. "endroit, autant l'une que l'autre.",
    ["Zonules overstrained"] = "Zonule trop étirée",
    ["The edge of the bag shows, the reflex becomes uneven."] = "Le bord du sac apparaît, la lueur devient inégale.",
    ["The zonules carry the load: close the tips and take them off the lens. Part in the middle of the groove's width, "
        .. "not to one side and not down."] =
        "La zonule porte la charge : rapprochez les pointes et retirez-les du cristallin. Écartez au milieu de la "
            .. "largeur du sillon, ni d'un côté ni vers le bas.",
    ["Capsule struck"] = "Capsule heurtée",
    ["The floor gives way under a tip, folds run from it."] = "Le fond cède sous une pointe, des plis en partent.",
    ["A tip is on the posterior capsule: lift it straight up, at once. Judge the floor by its reflex before you go "
        .. "down."] =
        "Une pointe est sur la capsule postérieure : relevez-la tout droit, aussitôt. Jugez le fond à sa lueur avant "
            .. "de descendre.",
    ["The posterior capsule is torn: irrigation only, second instrument out, chamber full, then leave. Do not part any "
        .. "more."] =
        "La capsule postérieure est déchirée : irrigation seule, second instrument dehors, chambre pleine, puis "
            .. "sortez. N'écartez plus.",
    ["Iris touched: stop, lift the tip to the middle of the pupil, and look at the shaft."] =
        "Iris touché : arrêtez, relevez la pointe au milieu de la pupille, et regardez la tige.",

    -- vitreous
    ["Capsule torn, hyaloid intact"] = "Capsule déchirée, hyaloïde intacte",
    ["The chamber deepens suddenly, a round clear edge shows, pieces no longer come to the tip."] =
        "La chambre s'approfondit soudain, un bord rond et net apparaît, les fragments ne viennent plus à la pointe.",
    ["Stay in with the tip, aspirate nothing (pedal 0 or 1). Lay dispersive viscoelastic over the hole through the "
        .. "side port until the chamber is full, and only then come out. Bottle down, slowly."] =
        "Restez dans l'œil avec la pointe, n'aspirez rien (pédale en 0 ou 1). Déposez du viscoélastique dispersif sur "
            .. "le trou par la contre-incision jusqu'à ce que la chambre soit pleine, et ne sortez qu'ensuite. Baissez "
            .. "le flacon, lentement.",
    ["The pupil peaks towards the wound, pieces hang, white strands show after triamcinolone."] =
        "La pupille s'étire en pointe vers l'incision, des fragments restent suspendus, des mèches blanches "
            .. "apparaissent une fois le vitré marqué à la triamcinolone.",
    ["There is vitreous in the chamber: no more phaco. Cover the hole, make the vitreous white, and cut it away, "
        .. "cutting before you aspirate and fast; also what hangs in the wound. Look again with triamcinolone."] =
        "Il y a du vitré dans la chambre : plus de phaco. Couvrez le trou, marquez le vitré à la triamcinolone et "
            .. "coupez-le, à cadence élevée et avant d'aspirer ; de même ce qui pend dans l'incision. Contrôlez de "
            .. "nouveau à la triamcinolone.",
    ["Vitreous pulled"] = "Traction sur le vitré",
    ["Strands run to the tip, and the edge of the hole moves with it."] =
        "Des mèches convergent vers la pointe, et le bord du trou la suit.",
    ["You suck on vitreous that is not cut: pedal up at once, and do not draw back. Cut first, then aspirate: pedal 2 "
        .. "cuts, pedal 3 aspirates as well."] =
        "Vous aspirez du vitré qui n'est pas coupé : lâchez aussitôt la pédale, et ne reculez pas. Coupez d'abord, "
            .. "puis aspirez : la pédale en 2 coupe, en 3 elle aspire aussi.",

    -- zonules
    ["Zonular dialysis"] = "Désinsertion zonulaire",
    ["The edge of the bag shows, the lens tilts and wobbles, a bright crescent stands beside it."] =
        "Le bord du sac apparaît, le cristallin bascule et tremble, un croissant brillant se voit à côté.",
    ["Zonules tear: stop, pedal to 1, bottle and flow down. Lay viscoelastic over the gap, and hold the edge of the "
        .. "opening there with hooks. A ring does for a gap of up to four clock hours, not for more."] =
        "La zonule se déchire : arrêtez, pédale en 1, baissez flacon et débit. Déposez du viscoélastique sur la "
            .. "brèche, et tenez-y le bord de l'ouverture par des crochets. Un anneau suffit pour une brèche de quatre "
            .. "heures d'horloge au plus.",
    ["Bag not supported"] = "Sac non soutenu",
    ["The lens lies aside, and moves as a whole when the tip works on it."] =
        "Le cristallin est décentré, et bouge en bloc quand la pointe le travaille.",
    ["A wide arc of the bag has no hold: support it with hooks or a ring before you go on."] =
        "Un large arc du sac est sans appui : soutenez-le par des crochets ou un anneau avant de continuer.",
    ["Vitreous through the gap"] = "Issue de vitré par la brèche",
    ["The chamber fell, the pupil peaks towards the wound, strands beside the edge of the bag."] =
        "La chambre s'est affaissée, la pupille s'étire en pointe vers l'incision, des mèches à côté du bord du sac.",
    ["Vitreous came through the gap: no phaco, bottle down. Cut it away before the gap and in the wound, cutting "
        .. "before you aspirate, cover the gap before you come out, and look again with triamcinolone."] =
        "Du vitré est passé par la brèche : pas de phaco, flacon baissé. Coupez-le devant la brèche et dans "
            .. "l'incision, en coupant avant d'aspirer, couvrez la brèche avant de sortir, et contrôlez de nouveau à "
            .. "la triamcinolone.",

    -- the eye under the shafts
    ["Iris prolapse"] = "Prolapsus de l'iris",
    ["Iris lies in the wound, and the pupil peaks towards it."] =
        "L'iris est dans l'incision, et la pupille s'étire en pointe vers elle.",
    ["Do not push it back. Lower the pressure: press on the lip of the side port until fluid comes. Then stroke over "
        .. "the outer lip of the wound: the iris slips back when nothing presses it out."] =
        "Ne le repoussez pas. Baissez la pression : appuyez sur la lèvre de la contre-incision jusqu'à ce que du "
            .. "liquide sorte. Massez ensuite la lèvre externe de l'incision : l'iris rentre quand rien ne le pousse "
            .. "plus dehors.",
    ["Eye rolled"] = "Œil entraîné",
    ["The eye turns away under the microscope, the cornea folds at the wound."] =
        "L'œil tourne sous le microscope, la cornée se plisse à l'incision.",
    ["You carry the eye with the instrument: bring the shaft back to the middle of the wound, and turn it about the "
        .. "wound from there."] =
        "Vous entraînez l'œil avec l'instrument : ramenez la tige au milieu de l'incision, et de là tournez-la autour "
            .. "de l'incision.",

    -- iris and cornea
    ["Iris touched"] = "Iris touché",
    ["The pupil's edge moves with the instrument."] = "Le bord de la pupille suit l'instrument.",
    ["Iris touched: stop, draw the instrument back to the middle of the pupil, and look at the shaft."] =
        "Iris touché : arrêtez, ramenez l'instrument au milieu de la pupille, et regardez la tige.",
    ["Iris touched: stop, bring the instrument back to the middle of the pupil, and look at the shaft."] =
        "Iris touché : arrêtez, ramenez l'instrument au milieu de la pupille, et regardez la tige.",
    ["Iris in the tip"] = "Iris dans l'embout",
    ["The edge of the pupil runs into the tip."] = "Le bord de la pupille part dans l'embout.",
    ["Iris in the tip: let go of the pedal and wait until it slips off; do not pull."] =
        "Iris dans l'embout : lâchez la pédale et attendez qu'il s'en détache ; ne tirez pas.",
    ["Cornea touched"] = "Cornée touchée",
    ["Folds in the cornea around the tip."] = "Des plis de la cornée autour de la pointe.",
    ["Lower the tip at once: endothelium does not grow again."] =
        "Abaissez aussitôt la pointe : l'endothélium ne repousse pas.",
}
