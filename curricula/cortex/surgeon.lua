-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does with cortex: holds each tag in the fornix with the mouth up, draws it to the middle, and
-- aspirates it there. Folds that run to the tip are let go. It sees the picture only. [mm]

local aspirating = require "surgeons.aspirating"

local speed, careful, strips = 7.0, 4.0, 4.0
local sectors = 16
local fornix = 3.85         -- how far out the tip goes
local below = 0.55          -- under the tag, so that the mouth, which looks up, meets it
local farther, lower = 0.4, 0.35
local middle = 1.3          -- how far out a tag is aspirated
local middle_z = -0.6
local holds_longest = 1.5   -- [s]
local takes_longest = 2.0
local most_passes = 3

local function at(place, out, z)
    local across = math.max(0.1, math.sqrt(place[1] ^ 2 + place[2] ^ 2))
    return { place[1] / across * out, place[2] / across * out, z }
end

-- Under the incision the tip stands steeply: it goes farther out, and lower.
local function beside(place)
    local near = math.max(0, math.min(1, -place[2] / 3))
    local out = math.min(fornix + near * farther, math.max(1.0, math.sqrt(place[1] ^ 2 + place[2] ^ 2)))
    return at(place, out, math.max(-1.2, place[3] - below - near * lower))
end

local function take(me, name)
    local mark = me.see().landmarks[name]
    if not mark then return end
    local place = mark.position
    me.go(at(place, middle, middle_z), speed)
    me.go(beside(place), careful)
    me.pedal(2)
    if not aspirating.wait_until(me, function(seen) return seen.landmarks.cortex_at_tip end, holds_longest) then
        return
    end
    if me.go(at(place, middle, middle_z), strips, aspirating.folds) then return aspirating.let_go(me) end
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
