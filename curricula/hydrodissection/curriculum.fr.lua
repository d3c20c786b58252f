-- SPDX-License-Identifier: GPL-3.0-or-later
-- The exercise in French. Keys are the English texts, letter for letter.

return {
    ["Hydrodissection"] = "Hydrodissection",
    ["The capsule is open, and the cortex adheres to it all round. Saline that is injected under the rim runs as a "
        .. "wave over the back of the bag and parts the two. What cannot come out past the nucleus pushes it "
        .. "forward, and at last bursts the posterior capsule. A nucleus that turns is free."] =
        "La capsule est ouverte, et le cortex y adhère sur tout le tour. Le sérum injecté sous le bord court en "
            .. "onde sur le fond du sac et les sépare. Ce qui ne peut ressortir le long du noyau le pousse en "
            .. "avant, et finit par rompre la capsule postérieure. Un noyau qui tourne est libre.",
    ["Bring the cannula under the rim, close to the capsule, and see the wave cross the red reflex"] =
        "Amener la canule sous le bord, près de la capsule, et voir l'onde traverser la lueur pupillaire",
    ["Press the nucleus back between injections, so that no fluid stays trapped"] =
        "Repousser le noyau entre les injections, pour que rien ne reste piégé",
    ["Turn the nucleus before going on, and never by force"] = "Tourner le noyau avant de continuer, jamais de force",
    ["The wave"] = "L'onde",
    ["Cannula under the rim, its end close to the capsule. Inject gently until the dark front has crossed the red "
        .. "reflex; stop when the nucleus comes forward."] =
        "La canule sous le bord, l'extrémité près de la capsule. Injectez doucement jusqu'à ce que le front sombre "
            .. "ait traversé la lueur ; arrêtez quand le noyau avance.",
    ["Let the fluid out"] = "Faire sortir le liquide",
    ["Press on the middle of the nucleus until it lies back."] =
        "Appuyez au centre du noyau jusqu'à ce qu'il revienne en arrière.",
    ["Turn the nucleus"] = "Tourner le noyau",
    ["Press the end of the cannula on the nucleus beside the middle and draw it round. It must turn without its bag."] =
        "Appuyez l'extrémité de la canule sur le noyau à côté du centre et entraînez-le. Il doit tourner sans son "
            .. "sac.",
    ["Come out"] = "Sortir",
    ["Straight out through the incision."] = "Tout droit par l'incision.",
}
