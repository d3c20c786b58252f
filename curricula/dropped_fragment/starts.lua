-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for.

-- The far left quarter on the tip, and pushed through the hole while nothing keeps the chamber up.
local function drop(t)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 8 })
    t:wait(1)
    t.phaco:move_to({ -0.85, 0.85, 0.2 }, { speed = 3 })
    t.phaco:pedal(3)
    t.phaco:move_to({ -1.4, 1.4, -0.1 }, { speed = 1.5, motion = "even" })
    t.phaco:pedal(1.75)
    t.phaco:move_to({ -1.9, 1.9, -0.4 }, { speed = 1, motion = "even" })
    t:wait(0.8)
    t:set { ["machine.bottle_cm"] = 0 }
    t.phaco:move_to({ 0, 0, 0 }, { speed = 2 })
    t.phaco:move_to({ 0, 0, -5.5 }, { speed = 1, motion = "even", stop = "fragments.sunk_mm > 2.3" })
    t.phaco:pedal(0)
    t:wait(0.3)
    t:set { ["machine.bottle_cm"] = 50 }
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 3 })
    t:wait(1)
    t.phaco:withdraw()
end

return starts {
    untouched = { function(t) t:wait(0.1) end },
    begin = { drop },
    -- The same, and a fifth of the chamber filled with viscoelastic high over the hole: nothing covers that.
    some_viscoelastic = { function(t)
        drop(t)
        t.cannula:enter { through = "side_port", speed = 30 }
        t.cannula:move_to({ 0, 0, 2 }, { speed = 15 })
        t.cannula:jaw(0.4)
        t:wait_until("tamponade.fill > 0.19", 20)
        t.cannula:jaw(0)
        t.cannula:withdraw { speed = 30 }
        t:wait(1)
    end },
}
