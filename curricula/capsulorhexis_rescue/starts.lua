-- SPDX-License-Identifier: GPL-3.0-or-later
-- The state in which this exercise begins, and one in which the edge is lost, the flap let go and the chamber filled.
-- They are made when they are asked for.

local rhexis_hand = require "rhexis_hand"

-- Led as in a deep chamber, in a shallow one: the capsule takes the tear outwards.
local function run_out(t)
    rhexis_hand.begin_flap(t)
    t.forceps:enter({ speed = 20 })
    for _ = 1, 8 do
        local stopped = rhexis_hand.pull(t, 2, 1, "rhexis.tip_radius_mm > goal.radius_mm + 0.4")
        rhexis_hand.open_jaws(t)
        if stopped then break end
    end
    t.forceps:withdraw({ speed = 20 })
end

return starts {
    begin = { run_out },
    edge_lost = { function(t)
        run_out(t)
        t.forceps:enter({ speed = 20 })
        rhexis_hand.pull_on(t)
        rhexis_hand.open_jaws(t)
        t.forceps:withdraw({ speed = 20 })
        rhexis_hand.fill(t, { to = 0.92, press = 1 })
    end },
}
