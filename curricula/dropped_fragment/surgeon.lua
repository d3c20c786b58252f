-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does who has seen a piece go: tip in with irrigation, high; viscoelastic over the hole with
-- the other hand; out, and the patient is referred. It sees the picture only: no measure, no event, no score. [mm]

local instruments = require "surgeons.instruments"
local vector = require "surgeons.vector"

local speed = 6.0
local tip_z = 2.0        -- plane of the iris
local over_hole = 1.4    -- height of the cannula's end over it
local enough = 0.65      -- of the chamber, viscoelastic before the tip leaves
local press = 0.9
local longest = 15       -- [s]

local function bring(me, hand, name, wound, place)
    local mark = me.see().landmarks[wound].position
    hand.take_up(instruments.outside(mark), name, wound)
    me.wait(0.5)
    hand.go(mark, speed)
    hand.go(place, speed)
end

local function take_out(me, hand, wound)
    local mark = me.see().landmarks[wound].position
    hand.go(mark, speed)
    hand.go(instruments.outside(mark), speed)
    hand.put_down()
end

local function cover(me)
    local hole = me.see().landmarks.capsule_hole
    if not hole then return end
    bring(me, me.left, "cannula", "side_port", vector.add(hole.position, { -0.3, 0, over_hole }))
    me.left.jaw(press)
    local wanted = math.min(0.9, math.max(0.55, me.about(enough)))
    me.wait_until(function(seen)
        local filled = seen.landmarks.viscoelastic
        return filled and filled.size >= wanted
    end, longest)
    me.left.jaw(0)
    me.wait(0.5)
    take_out(me, me.left, "side_port")
end

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.incision and seen.landmarks.pupil end, 10)
    local pupil = me.see().landmarks.pupil.position
    me.pedal(1)
    bring(me, me, "phaco", "incision", { pupil[1], pupil[2], tip_z })
    me.wait(1)
    local knows = me.notices(function(seen) return seen.landmarks.capsule_hole end)
    if knows then cover(me) end
    take_out(me, me, "incision")
    me.pedal(0)
    if knows then me.request("Retina surgeon called") end
end
