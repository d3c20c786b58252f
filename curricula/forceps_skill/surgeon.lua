-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does: in with closed jaws, bead after bead to the tray, out with closed jaws. It sees the
-- picture only. [mm]

local instruments = require "surgeons.instruments"
local vector = require "surgeons.vector"

local speed, careful = 6.0, 2.5
local lift, over = 0.9, 0.15
local most_tries = 12
local in_tray = 0.85   -- share of its radius

local function aside(place, tray)
    return math.sqrt((place[1] - tray.position[1]) ^ 2 + (place[2] - tray.position[2]) ^ 2)
end

-- The bead farthest from the tray that does not lie in it, and its name.
local function next_bead(me)
    local seen = me.see()
    local tray, best, name = seen.landmarks.tray, nil, nil
    for i = 1, 6 do
        local bead = seen.landmarks["bead_" .. i]
        local away = bead and aside(bead.position, tray)
        if bead and away > in_tray * tray.size and (not best or away > aside(best, tray)) then
            best, name = bead.position, "bead_" .. i
        end
    end
    return best, name
end

-- Where the hand has to go for the tip to be seen at a place.
local function corrected(me, place)
    local seen = me.see().tools.forceps
    if not (seen and seen.present) then return place end
    return vector.add(me.tip(), vector.sub(place, seen.position))
end

local function take(me, place)
    me.go(vector.add(place, { 0, 0, lift }), speed)
    me.jaw(0.6)
    me.wait(0.4)
    me.go(corrected(me, vector.add(place, { 0, 0, over })), careful)
    me.go(corrected(me, vector.add(place, { 0, 0, over })), careful)
    me.jaw(0)
    me.wait(0.5)
end

local function lay_down(me)
    local tray = me.see().landmarks.tray.position
    me.go(vector.add(me.tip(), { 0, 0, lift }), careful)
    me.go(corrected(me, vector.add(tray, { 0, 0, 0.5 })), careful)
    me.jaw(0.6)
    me.wait(0.4)
    me.go(vector.add(me.tip(), { 0, 0, lift }), careful)
    me.jaw(0)
    me.wait(0.4)
end

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.incision and seen.landmarks.tray end, 5)
    local wound = me.see().landmarks.incision.position
    local inside = { 0.6 * wound[1], 0.6 * wound[2], wound[3] }
    me.take_up(instruments.outside(wound), "forceps")
    me.wait(0.4)
    me.go(wound, speed)
    me.go(inside, speed)
    for _ = 1, most_tries do
        local bead, name = next_bead(me)
        if not bead then break end
        take(me, bead)
        me.go(vector.add(me.tip(), { 0, 0, 0.6 }), careful)
        me.wait(0.3)
        local now = me.see().landmarks[name]
        if now and now.position[3] - bead[3] > 0.2 then lay_down(me) end
        me.wait(0.5)
    end
    me.jaw(0)
    me.wait(0.4)
    me.go(inside, speed)
    me.go(wound, speed)
    me.go(instruments.outside(wound), speed)
    me.put_down()
    me.wait(0.5)
end
