-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from, each made by an exact hand with the instruments. They are made when they are
-- asked for.

local quick = 60  -- where nothing depends on it [mm/s]

-- Viscoelastic through the side port at a height, until the chamber holds a share of it.
local function lay(t, height, share)
    t.cannula:enter { through = "side_port", speed = quick }
    t.cannula:move_to({ 0.4, 0.8, height }, { speed = 15 })
    t.cannula:jaw(0.4)
    t:wait_until("tamponade.fill > " .. share, 20)
    t.cannula:jaw(0)
    t.cannula:withdraw { speed = quick }
end

return starts {
    -- A quarter of the chamber is filled, high over the hole: nothing covers that.
    some_viscoelastic = { function(t)
        lay(t, 2, 0.27)
        t:wait(1)
    end },

    -- The tip sucks at the hyaloid until it breaks, and goes on: vitreous comes. Too late covered, the tip
    -- leaves, and a strand runs after it into the wound.
    vitreous = { function(t)
        t.phaco:enter { speed = quick }
        t.phaco:pedal(1)
        t.phaco:move_to({ 0.6, 0.8, -2 }, { speed = 8 })
        t:wait(0.5)
        t:set { ["machine.flow_ml_min"] = 50, ["machine.vacuum_mmhg"] = 500 }
        t.phaco:pedal(2)
        t:wait_until("vitreous.front_mm3 > 3", 5)
        t.phaco:pedal(1)
        t:wait(0.5)
        t.phaco:move_to({ 0.6, 0.8, 0.5 }, { speed = 8 })
        lay(t, -1, 0.3)
        t.phaco:withdraw { speed = quick }
        t:wait(1)
    end },
}
