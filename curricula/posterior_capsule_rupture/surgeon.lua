-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does who sees the edge of a hole: holds the chamber up with the tip, lays viscoelastic over
-- the hole with the other hand, has the bottle lowered, comes out, and looks for vitreous. Where there is some, it is
-- cut away.
-- It sees the picture only: no measure, no event, no score. [mm]

local instruments = require "surgeons.instruments"
local vector = require "surgeons.vector"

local speed, careful = 6.0, 2.5
local over_hole = 1.2       -- height of the cannula's end over it
local tip_over = 3.2        -- of the phaco tip
local enough = 0.5          -- of the chamber, viscoelastic before the tip leaves
local press = 0.9
local dose_s = 0.6          -- of triamcinolone
local most_passes = 3
local cut_longest = 12.0    -- [s]

local function bring(me, hand, name, wound, place)
    local mark = me.see().landmarks[wound].position
    hand.take_up(instruments.outside(mark), name, wound)
    me.wait(0.5)
    hand.go(mark, speed)
    hand.go(place, speed)
end

local function take_out(me, hand, wound)
    hand.jaw(0)
    local mark = me.see().landmarks[wound].position
    hand.go(mark, speed)
    hand.go(instruments.outside(mark), speed)
    hand.put_down()
end

local function filled(seen)
    local mark = seen.landmarks.viscoelastic
    return mark and mark.size or 0
end

local function hole_of(me) return me.see().landmarks.capsule_hole end

-- With the other hand, while what is in the leading one stays as it is.
local function cover(me, hole, full)
    bring(me, me.left, "cannula", "side_port", vector.add(hole, { -0.3, 0, over_hole }))
    me.left.jaw(press)
    local from = filled(me.see())
    local wanted = math.max(me.about(full), from + 0.2)
    me.wait_until(function(seen) return filled(seen) >= math.min(0.9, wanted) end, 12)
    take_out(me, me.left, "side_port")
end

local function make_white(me, hole)
    bring(me, me.left, "triamcinolone", "side_port", vector.add(hole, { 0, 0, 3 }))
    me.left.jaw(press)
    me.wait(dose_s)
    take_out(me, me.left, "side_port")
    me.wait(0.5)
end

local function some_left(seen) return seen.landmarks.vitreous or seen.landmarks.vitreous_strand end

-- Cuts before the hole, then what runs to the wound, and comes out of a chamber that is covered again.
local function cut(me, hole)
    bring(me, me, "cutter", "incision", vector.add(hole, { 0, 0, 2.5 }))
    me.pedal(1)
    me.wait(0.5)
    me.go(vector.add(hole, { 0, 0, 0.9 }), careful)
    me.pedal(3)
    me.wait_until(function(seen) return not seen.landmarks.vitreous end, cut_longest)
    local wound = me.see().landmarks.incision.position
    me.go(vector.add(hole, { 0, 0, 2.0 }), careful)
    me.go({ 0.95 * wound[1], 0.95 * wound[2], wound[3] - 0.2 }, careful)
    me.wait_until(function(seen) return not seen.landmarks.vitreous_strand end, 4)
    me.pedal(1)
    me.go(vector.add(hole, { 0, 0, 3 }), speed)
    cover(me, hole, enough)
    me.pedal(0)
    take_out(me, me, "incision")
end

return function(me)
    me.wait_until(function(seen) return seen and hole_of(me) ~= nil end, 10)
    local hole = hole_of(me).position
    bring(me, me, "phaco", "incision", vector.add(hole, { 0, 0, tip_over }))
    me.pedal(1)
    me.wait(1)
    if me.notices(function(seen) return seen.landmarks.capsule_hole end) then
        cover(me, hole, enough)
        me.request("Bottle down")
        me.wait(1)
    end
    take_out(me, me, "incision")
    me.pedal(0)
    for _ = 1, most_passes do
        make_white(me, hole)
        if not some_left(me.see()) then return end
        cover(me, hole, enough)
        cut(me, hole)
    end
end
