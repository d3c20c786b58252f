-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for.

local rhexis_hand = require "rhexis_hand"

local full = { ["viscoelastic.fill"] = 1 }

local brittle = { ["viscoelastic.fill"] = 0.7, ["vitreous.pressure_mmhg"] = 20, ["capsule.toughness"] = 0.2 }

local shallow = { ["viscoelastic.fill"] = 0.3, ["vitreous.pressure_mmhg"] = 20, ["capsule.toughness"] = 0.6 }

-- A flap that was pulled at, and let go.
local function after(set, pull)
    return { set = set, function(t)
        rhexis_hand.begin_flap(t)
        t.forceps:enter({ speed = 20 })
        pull(t)
        rhexis_hand.open_jaws(t)
        t.forceps:withdraw({ speed = 20 })
    end }
end

-- Outwards in a shallow chamber until a condition holds.
local function pulled_until(stop)
    return after(shallow, function(t)
        for _ = 1, 6 do
            if rhexis_hand.pull(t, 2, 1, stop) then break end
            rhexis_hand.open_jaws(t)
        end
    end)
end

return starts {
    flap = { set = full, rhexis_hand.begin_flap },
    pulled = pulled_until("rhexis.tip_radius_mm > 2.4"),
    run_out = pulled_until("rhexis.tip_radius_mm > 3.07 and rhexis.tip_heading_deg > 30 "
        .. "or rhexis.tip_radius_mm > 3.37"),
    brittle = { set = brittle, rhexis_hand.begin_flap },
    nearly_lost = after(brittle, function(t) rhexis_hand.lose_edge(t, "rhexis.tip_radius_mm > 2.9") end),
    lost = after(brittle, rhexis_hand.lose_edge),
    round = { surgeon = "expert", seed = 101, when = "rhexis.closed" },
}
