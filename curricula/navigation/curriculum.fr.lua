-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Holding still and finding the way"] = "Stabilité et orientation",
    ["A basic skill: hold the tip of a blunt probe still at four places of the anterior chamber, lead it round a "
        .. "circle, and leave, without touching iris or cornea."] =
        "Un geste de base : tenez immobile la pointe mousse d'une sonde en quatre endroits de la chambre antérieure, "
            .. "faites-lui suivre un cercle, et sortez, sans toucher l'iris ni la cornée.",
    ["Steady the hand"] = "Stabiliser la main",
    ["Know where the tip is in all three directions"] = "Savoir où est la pointe dans les trois directions",

    -- of the places in targets.lua
    ["Hold the tip: middle"] = "Tenir la pointe : au centre",
    ["Bring the tip to 0 mm right, 0 mm away and 3 mm over the lens equator, and hold it still."] =
        "Amenez la pointe au centre de la pupille, 3 mm au-dessus de l'équateur du cristallin, et tenez-la immobile.",
    ["Hold the tip: right"] = "Tenir la pointe : à droite",
    ["Bring the tip to 2 mm right, 0 mm away and 3 mm over the lens equator, and hold it still."] =
        "Amenez la pointe 2 mm à droite du centre, 3 mm au-dessus de l'équateur du cristallin, et tenez-la immobile.",
    ["Hold the tip: far"] = "Tenir la pointe : au loin",
    ["Bring the tip to 0 mm right, 2 mm away and 3 mm over the lens equator, and hold it still."] =
        "Amenez la pointe 2 mm au-delà du centre, 3 mm au-dessus de l'équateur du cristallin, et tenez-la immobile.",
    ["Hold the tip: left"] = "Tenir la pointe : à gauche",
    ["Bring the tip to -2 mm right, 0 mm away and 3 mm over the lens equator, and hold it still."] =
        "Amenez la pointe 2 mm à gauche du centre, 3 mm au-dessus de l'équateur du cristallin, et tenez-la immobile.",

    ["Lead the tip round the circle"] = "Faire suivre le cercle à la pointe",
    ["From the left, once round against the clock: near side, right, far side, left."] =
        "En partant de la gauche, un tour dans le sens antihoraire : près de vous, à droite, au loin, à gauche.",
    ["Leave the eye"] = "Sortir de l'œil",
    ["Out the way you came."] = "Ressortez par où vous êtes venu.",
    ["Path left"] = "Trajet quitté",
    ["The tip is inside or outside the ring that it has to follow, or too high or too low."] =
        "La pointe est en dedans ou en dehors du cercle à suivre, ou trop haut ou trop bas.",
    ["Stop, look, and go back to the circle the shortest way before you go on."] =
        "Arrêtez, regardez, et revenez au cercle par le plus court avant de continuer.",
}
