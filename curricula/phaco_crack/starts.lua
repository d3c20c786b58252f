-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for.

-- One straight groove away from the surgeon, by an exact hand: layers of two strokes side by side, whose floor rises
-- towards both ends as the posterior capsule does. Irrigation has pushed the lens back by 0.66. [mm]
local half_length = 2.0     -- of the way of the tip
local half_width = 0.3      -- of it; the tip adds its radius of 0.45 on each side
local floor = -1.85          -- height of the tip's way at its deepest
local rise = 0.6            -- of its ends over that
local first = 1.45          -- height of the first layer
local layer = 0.45
local over = 2.6            -- height in front of the lens

-- Away from the surgeon with ultrasound, back in front of the lens.
local function stroke(t, beside, height)
    local way = {}
    for i = -5, 5 do
        local y = half_length * i / 5
        way[#way + 1] = { beside, y, math.max(height, floor + rise * (i / 5) ^ 2) }
    end
    t.phaco:move_to({ beside, -half_length, over }, { speed = 15 })
    t.phaco:pedal(3)
    t.phaco:move_to(way[1], { speed = 4 })
    t.phaco:path(way, { speed = 1.8, motion = "even" })
    t.phaco:pedal(1)
    t.phaco:move_to({ beside, half_length, over }, { speed = 15 })
end

return starts {
    begin = { function(t)
        t.phaco:enter()
        t.phaco:pedal(1)
        t.phaco:move_to({ 0, -half_length, over })
        t:wait(1)  -- the chamber deepens
        for height = first, floor - layer, -layer do
            stroke(t, -half_width, height)
            stroke(t, half_width, height)
        end
        t.phaco:withdraw()
    end },
}
