-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does with cortex: holds each tag in the fornix with the mouth up, draws it to the middle, and
-- aspirates it there. Folds that run to the tip are let go. It sees the picture only. [mm]

local aspirating = require "surgeons.aspirating"

local speed, careful, strips = 7.0, 4.0, 4.0
local sectors = 16
local fornix = 3.85         -- how far out the tip goes
local below = 0.55          -- under the tag, so that the mouth, which looks up, meets it
local near_side = -2.0      -- from here on tags lie near the incision
local near_fornix, aside, near_below = 3.75, 0.65, 0.2
local rolled = 80           -- how far the tip is rolled there [degrees]
local middle = 1.3          -- how far out a tag is aspirated
local middle_z = -0.6
local holds_longest = 1.5   -- [s]
local takes_longest = 2.0
local most_passes = 3

local function at(place, out, z)
    local across = math.max(0.1, math.sqrt(place[1] ^ 2 + place[2] ^ 2))
    return { place[1] / across * out, place[2] / across * out, z }
end

-- Under a tag, so that the mouth meets it.
local function under(place)
    return at(place, math.min(fornix, math.max(1.0, math.sqrt(place[1] ^ 2 + place[2] ^ 2))), place[3] - below), 0
end

-- Near the incision the tip stands steeply, and its mouth looks away from the tag that lies behind it: it goes beside
-- the tag, towards the middle of the near side, and is rolled until the mouth looks across at it.
local function beside(place)
    local side = place[1] < 0 and 1 or -1
    local tip = at({ place[1] + side * aside, place[2] }, near_fornix, place[3] - near_below)
    return tip, side * rolled
end

local function reach(place)
    if place[2] < near_side then return beside(place) end
    return under(place)
end

local function take(me, name)
    local mark = me.see().landmarks[name]
    if not mark then return end
    local place = mark.position
    me.go(at(place, middle, middle_z), speed)
    local tip, roll = reach(place)
    me.turn(roll)
    me.go(tip, careful)
    me.pedal(2)
    if not aspirating.wait_until(me, function(seen) return seen.landmarks.cortex_at_tip end, holds_longest) then
        return
    end
    if me.go(at(place, middle, middle_z), strips, aspirating.folds) then return aspirating.let_go(me) end
    me.turn(0)
    if not aspirating.wait_until(me, function(seen) return not seen.landmarks.cortex_at_tip end, takes_longest) then
        return
    end
    me.pedal(1)
end

local function some_left(seen)
    for i = 1, sectors do
        if seen.landmarks["cortex_" .. i] then return true end
    end
    return false
end

return function(me)
    me.wait_until(function(seen) return seen ~= nil end, 10)
    local wound = aspirating.come_to_wound(me, speed)
    me.go({ 0, -middle, middle_z }, speed)
    for _ = 1, most_passes do
        for i = 1, sectors do take(me, "cortex_" .. i) end
        if not some_left(me.see()) then break end
    end
    me.pedal(1)
    me.go({ 0, -1, 0.5 }, speed)
    aspirating.come_out(me, wound, speed)
end
