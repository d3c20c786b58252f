-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon puts an implant into the bag: so far a placeholder that injects it and goes. The plan sees the
-- picture only: no measure, no event, no score. [mm]

local instruments = require "surgeons.instruments"

local free_speed = 12     -- where nothing is near [mm/s]
local before_rim = 2.0    -- the tip stops so far on this side of the middle of the pupil
local over_rim = 0.3      -- and so far over the pupil's plane
local push_s = 5          -- that the plunger takes
local push_steps = 50
local unfolds_s = 6       -- that one waits for the implant

local function mark(me, name)
    me.wait_until(function(seen) return seen and seen.landmarks[name] end, 5)
    return me.see().landmarks[name].position
end

return function(me)
    local wound, pupil = mark(me, "incision"), mark(me, "pupil")
    me.take_up(instruments.outside(wound), "injector")
    me.wait(0.5)
    me.go(wound, free_speed)
    me.go({ pupil[1], pupil[2] - before_rim, pupil[3] + over_rim }, free_speed)
    for i = 1, push_steps do
        me.jaw(i / push_steps)
        me.wait(push_s / push_steps)
    end
    me.wait(unfolds_s)
    me.go(wound, free_speed)
    me.go(instruments.outside(wound), free_speed)
    me.put_down()
end
