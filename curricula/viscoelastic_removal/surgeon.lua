-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does with viscoelastic: aspirates over the optic until none shows, then past its edge behind
-- it, and looks whether it still floats. It sees the picture only. [mm]

local aspirating = require "surgeons.aspirating"
local vector = require "surgeons.vector"

local speed, careful = 6.0, 3.0
local over = 1.4          -- height over the optic
local beside = 3.75       -- how far out the tip passes its edge
local under = 1.25        -- below it
local inside = 1.6        -- how far out it aspirates there
local longest = 25.0      -- [s]
local most_passes = 3

local function aspirate(me, done)
    me.pedal(2)
    aspirating.wait_until(me, done, longest)
end

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.optic end, 10)
    local optic = me.see().landmarks.optic.position
    local wound = aspirating.come_to_wound(me, speed)
    me.go(vector.add(optic, { 0, 0.5, over }), speed)
    aspirate(me, function(seen) return not seen.landmarks.viscoelastic end)
    for _ = 1, most_passes do
        me.pedal(1)
        me.go(vector.add(optic, { beside, 0.3, 0.2 }), speed)
        me.go(vector.add(optic, { beside - 0.2, 0.3, -0.5 }), careful)
        me.go(vector.add(optic, { inside, 0.3, -under }), careful)
        aspirate(me, function(seen) return not seen.landmarks.optic_floats end)
        me.wait(me.about(3))
        me.pedal(1)
        me.go(vector.add(optic, { beside - 0.2, 0.3, -0.5 }), careful)
        me.go(vector.add(optic, { beside, 0.3, 0.2 }), careful)
        if not me.see().landmarks.optic_floats then break end
    end
    me.go(vector.add(optic, { 0, -1, over }), speed)
    aspirating.come_out(me, wound, speed)
end
