-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon brings the second instrument, the spatula in the other hand: words that plans share. [mm]

local instruments = require "surgeons.instruments"
local sculpting = require "surgeons.sculpting"

local spatula = {}

spatula.clear_of_lens = 0.7   -- height over the lens at which nothing touches it

--- Front of the lens at a place, as it was before sculpting.
function spatula.height(eye, place)
    return sculpting.surface(eye, math.sqrt((place[1] - eye.pupil[1]) ^ 2 + (place[2] - eye.pupil[2]) ^ 2))
end

--- Its end straight up or down, to a height over the lens.
function spatula.lift(me, eye, by, speed)
    local tip = me.left.tip()
    me.left.go({ tip[1], tip[2], spatula.height(eye, tip) + by }, speed)
end

--- Through the side port, over the lens.
function spatula.bring(me, eye)
    me.left.take_up(instruments.outside(eye.port))
    me.wait(0.5)
    me.left.go(eye.port, sculpting.free_speed)
    local place = { eye.pupil[1] - 1.5, eye.pupil[2], 0 }
    place[3] = spatula.height(eye, place) + spatula.clear_of_lens
    me.left.go(place, sculpting.free_speed)
end

function spatula.take_away(me, eye)
    spatula.lift(me, eye, spatula.clear_of_lens, sculpting.free_speed)
    me.left.go(eye.port, sculpting.free_speed)
    me.left.go(instruments.outside(eye.port), sculpting.free_speed)
    me.left.put_down()
end

return spatula
