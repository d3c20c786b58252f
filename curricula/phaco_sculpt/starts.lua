-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for. hole: straight down the middle, almost
-- to the posterior capsule. The others have grooves: a thin one away from the surgeon; a deeper one; and a thin second
-- one, 45 degrees to that.

local sculpt_hand = require "sculpt_hand"

-- Several, each a direction and a height.
local function grooves(...)
    local strokes = { ... }
    return { function(t)
        t.phaco:enter()
        t.phaco:pedal(1)
        t.phaco:move_to({ 0, -sculpt_hand.half_length, sculpt_hand.over }, { speed = 8 })
        for _, s in ipairs(strokes) do sculpt_hand.stroke(t, s[1], s[2], 15) end
        t.phaco:move_to({ 0, 0, 3.8 }, { speed = 8 })
        t.phaco:withdraw()
    end }
end

return starts {
    hole = { function(t)
        t.phaco:enter()
        t.phaco:pedal(1)
        t.phaco:move_to({ 0, 0, 3.8 }, { speed = 8 })
        t.phaco:pedal(3)
        t.phaco:move_to({ 0, 0, 1.4 }, { speed = 8 })
        t.phaco:move_to({ 0, 0, -5 }, { speed = 1.2, motion = "even", stop = "phaco.tip_posterior_mm < 0.3" })
        t.phaco:pedal(1)
        t.phaco:move_to({ 0, 0, 3.8 }, { speed = 4 })
        t.phaco:withdraw()
    end },
    thin_groove = grooves({ 0, 0.9 }),
    groove = grooves({ 0, 0.9 }, { 0, 0.4 }),
    askew = grooves({ 0, 0.9 }, { 0, 0.4 }, { 45, 0.9 }),
}
