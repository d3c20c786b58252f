-- SPDX-License-Identifier: GPL-3.0-or-later
-- The four groups of virtual surgeons, by the number of operations they stand for (groups of Saleh et al. 2007). They
-- follow the same plan and differ only in these numbers. The numbers were set before any study was run and are not
-- fitted to scores; the errors of size and of touch came later, before any run that has them was judged.
--
-- source "proposal": no measured figure was found; the values are a guess of the right order and direction.

local groups = {}

groups.names = { "a", "b", "c", "d" }
groups.meaning = {
    a = "fewer than 50 operations",
    b = "50 to 249 operations",
    c = "250 to 500 operations",
    d = "over 500 operations",
}
groups.aliases = { novice = "a", expert = "d" }

groups.parameters = {
    { name = "tremor_um", unit = "um", a = 200, b = 130, c = 70, d = 50,
        meaning = "trembling of the tip, 8 to 12 Hz, root mean square of the distance from the intended place",
        source = "Riviere 1997: 49 um holding still, 133 um while actuating; Wells et al.: 144 to 285 um in others; "
            .. "assignment to groups is a proposal" },
    { name = "reaction_s", unit = "s", a = 0.60, b = 0.48, c = 0.36, d = 0.25,
        meaning = "from what happens in the picture to what the hand or foot does about it",
        source = "range 0.25 to 0.6 s; assignment is a proposal" },
    { name = "lateral_error_mm", unit = "mm", a = 0.12, b = 0.08, c = 0.05, d = 0.04,
        meaning = "error in seeing a place, across the line of sight, each direction", source = "proposal" },
    { name = "depth_error_mm", unit = "mm", a = 0.45, b = 0.30, c = 0.18, d = 0.12,
        meaning = "error in seeing a place, along the line of sight", source = "proposal" },
    { name = "brightness_error", unit = "1", a = 0.30, b = 0.20, c = 0.12, d = 0.08,
        meaning = "relative error in judging the brightness of the reflex", source = "proposal" },
    { name = "aim_error", unit = "1", a = 0.08, b = 0.06, c = 0.04, d = 0.03,
        meaning = "spread of where a movement ends, as a share of its length, each direction",
        source = "noise grows with the motor command: Harris & Wolpert 1998; values are a proposal" },
    { name = "planning_error", unit = "1", a = 0.50, b = 0.30, c = 0.15, d = 0.10,
        meaning = "spread of chosen speed, power and thickness of a layer about the plan (of their logarithm), and "
            .. "of a chosen direction (15 degrees for 1)",
        source = "proposal" },
    { name = "lapses_per_min", unit = "1/min", a = 2.0, b = 1.0, c = 0.4, d = 0.2,
        meaning = "moments in which hand and foot go on without heeding what is seen", source = "proposal" },
    { name = "lapse_s", unit = "s", a = 1.0, b = 0.9, c = 0.7, d = 0.6,
        meaning = "length of such a moment", source = "proposal" },
    { name = "centring_mm", unit = "mm", a = 1.4, b = 1.1, c = 0.85, d = 0.7,
        meaning = "how far from the middle of the microscope's field this person leaves the eye, each direction",
        source = "Din 2016: novices about twice as far as experts; scale and the groups between are a proposal" },
    { name = "size_error", unit = "1", a = 0.16, b = 0.12, c = 0.08, d = 0.05,
        meaning = "relative error in judging how large or how full a thing is", source = "proposal" },
    { name = "palpation_error", unit = "1", a = 0.30, b = 0.25, c = 0.20, d = 0.15,
        meaning = "relative error in judging by touch how hard the eye is",
        source = "Birnbach & Leen 1998: at 5 to 40 mmHg an experienced examiner was within 5 mmHg always, an "
            .. "inexperienced one in 62 %; Heringer 2024 found no gain by experience; assignment is a proposal" },
}

--- People of one group differ: each parameter is multiplied by exp(spread * normal deviate). Proposal.
groups.spread = 0.15

return groups
