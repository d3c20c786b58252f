-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for. hole: straight down the middle, between
-- the quarters, almost to the posterior capsule; torn: and on through it.

-- With ultrasound until a condition holds, and out with irrigation.
local function drilled(stop)
    return { function(t)
        t.phaco:enter()
        t.phaco:pedal(1)
        t.phaco:move_to({ 0, 0, 3 }, { speed = 8 })
        t.phaco:pedal(3)
        t.phaco:move_to({ 0, 0, -6 }, { speed = 1.2, motion = "even", stop = stop })
        t.phaco:pedal(1)
        t:wait(1)
        t.phaco:move_to({ 0, 0, 3 }, { speed = 4 })
        t.phaco:withdraw()
    end }
end

return starts {
    hole = drilled("phaco.tip_posterior_mm < 0.3"),
    torn = drilled("capsule.open"),
}
