-- SPDX-License-Identifier: GPL-3.0-or-later
-- One who knows nothing of surgery: both hands go anywhere in the eye, at any speed, with any pedal. What an exercise,
-- its scripts and the mechanics must survive.

local chance = require "surgeons.chance"
local vector = require "surgeons.vector"

local reach = 4.5  -- of the places from the eye's axis [mm]
local lowest, highest = -4.0, 4.0
local fastest = 20.0

--- The plan of one such person.
return function(seed)
    local stream = chance.stream(seed, "random operator")
    local function between(low, high) return low + (high - low) * stream:uniform() end

    local function wander(hand)
        local from = hand.tip()
        local to = { between(-reach, reach), between(-reach, reach), between(lowest, highest) }
        hand.begin(function(share) return vector.mix(from, to, share) end, between(1, fastest))
    end

    return function(me)
        me.take_up { 0, -6, 4 }
        me.left.take_up { -6, 0, 4 }
        while true do
            if stream:uniform() < 0.8 then wander(me) end
            if stream:uniform() < 0.5 then wander(me.left) end
            if stream:uniform() < 0.6 then me.pedal(between(0, 3)) end
            me.wait(between(0.1, 1.5))
        end
    end
end
