-- SPDX-License-Identifier: GPL-3.0-or-later
-- One who knows nothing of surgery: both hands go anywhere in the eye, at any speed, with any pedal. What an exercise,
-- its scripts and the mechanics must survive.

local chance = require "surgeons.chance"
local instruments = require "surgeons.instruments"
local vector = require "surgeons.vector"

local reach = 4.5  -- of the places from the eye's axis [mm]
local lowest, highest = -4.0, 4.0
local fastest = 20.0

--- The plan of one such person.
return function(seed)
    local stream = chance.stream(seed, "random operator")
    local function between(low, high) return stream:between(low, high) end

    local function wander(hand)
        local from = hand.tip()
        local to = { between(-reach, reach), between(-reach, reach), between(lowest, highest) }
        hand.begin(function(share) return vector.mix(from, to, share) end, between(1, fastest))
    end

    -- The leading hand now and then takes another instrument, and moves its fingers.
    local function change(me)
        local names = {}
        for _, name in ipairs(me.instruments()) do
            if instruments.held(name).wound == "incision" then names[#names + 1] = name end
        end
        if #names < 2 then return end
        if stream:uniform() < 0.1 then
            me.put_down()
            me.wait(0.05)
            me.take_up({ 0, -6, 4 }, names[1 + math.floor(stream:uniform() * #names)])
        end
        me.jaw(stream:uniform() < 0.5 and 0 or stream:uniform())
    end

    return function(me)
        me.take_up { 0, -6, 4 }
        me.left.take_up { -6, 0, 4 }
        while true do
            change(me)
            if stream:uniform() < 0.8 then wander(me) end
            if stream:uniform() < 0.5 then wander(me.left) end
            if stream:uniform() < 0.6 then me.pedal(between(0, 3)) end
            if me.microscope then me.microscope.begin({ between(-4, 4), between(-4, 4), between(-4, 4) }) end
            me.wait(between(0.1, 1.5))
        end
    end
end
