-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for.

local rhexis_hand = require "rhexis_hand"

local full = { ["viscoelastic.fill"] = 1 }

-- A circle that the needle has cut round but for the last sixty degrees. aside: of its middle from the axis [mm].
local function nearly_round(radius, aside, speed)
    return { set = full, function(t)
        rhexis_hand.cut_circle(t, { radius = radius, aside = aside, from = 90, by = 300, speed = speed })
        rhexis_hand.lift_out(t)
    end }
end

local brittle = { ["viscoelastic.fill"] = 0.7, ["vitreous.pressure_mmhg"] = 20, ["capsule.toughness"] = 0.2 }

return starts {
    flap = { set = full, rhexis_hand.begin_flap },
    shallow = { set = { ["viscoelastic.fill"] = 0.3, ["vitreous.pressure_mmhg"] = 20,
        ["capsule.toughness"] = 0.6 }, rhexis_hand.begin_flap },
    brittle = { set = brittle, rhexis_hand.begin_flap },
    lost = { set = brittle, function(t)
        rhexis_hand.begin_flap(t)
        t.forceps:enter({ speed = 20 })
        rhexis_hand.lose_edge(t)
        rhexis_hand.open_jaws(t)
        t.forceps:withdraw({ speed = 20 })
    end },
    narrow = nearly_round(1.85, 0),
    rather_narrow = nearly_round(2.35, 0),
    wide = nearly_round(3.15, 0),
    rather_wide = nearly_round(2.9, 0),
    aside = nearly_round(2.6, 0.75),
    rather_aside = nearly_round(2.6, 0.4),
    round = { surgeon = "expert", seed = 101, when = "rhexis.closed" },
}
