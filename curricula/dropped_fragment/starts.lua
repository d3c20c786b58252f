-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for.

-- The far left quarter on the tip, and pushed through the hole while nothing keeps the chamber up.
return starts {
    untouched = { function(t) t:wait(0.1) end },
    begin = { function(t)
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
    end },
}
