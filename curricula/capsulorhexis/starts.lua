-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for.

local rhexis_hand = require "rhexis_hand"

return starts {
    flap = { set = { ["viscoelastic.fill"] = 1 }, rhexis_hand.begin_flap },
    shallow = { set = { ["viscoelastic.fill"] = 0.3, ["vitreous.pressure_mmhg"] = 20,
        ["capsule.toughness"] = 0.6 }, rhexis_hand.begin_flap },
    brittle = { set = { ["viscoelastic.fill"] = 0.7, ["vitreous.pressure_mmhg"] = 20,
        ["capsule.toughness"] = 0.2 }, rhexis_hand.begin_flap },
    round = { surgeon = "expert", seed = 101, when = "rhexis.closed" },
}
