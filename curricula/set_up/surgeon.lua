-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does: the drape along both margins, the speculum between the lids, the microscope, the pedal,
-- what is said aloud. It sees the picture and the panel only. [mm]

local centring = require "surgeons.centring"
local vector = require "surgeons.vector"

local speed, away = 9.0, 20.0
local table_side = { 0, -14, 11 }
local most_rounds = 3

-- Lashes that are seen to stick out, in their order along the lids.
local function lashes(me)
    local list = {}
    for i = 1, 40 do
        local mark = me.see().landmarks["lash_" .. i]
        if mark then list[#list + 1] = mark.position end
    end
    return list
end

-- Along a line of places, pressed down.
local function lead(me, places)
    me.go(vector.add(places[1], { 0, 0, 3 }), away)
    me.go(places[1], speed)
    me.jaw(1)
    me.wait(0.4)
    for i = 2, #places do
        if vector.distance(places[i], places[i - 1]) > 6 then
            me.jaw(0)
            me.wait(0.3)
            me.go(vector.add(places[i], { 0, 0, 3 }), away)
            me.go(places[i], speed)
            me.jaw(1)
            me.wait(0.4)
        else
            me.go(places[i], speed)
        end
    end
    me.jaw(0)
    me.wait(0.4)
    me.go(vector.add(places[#places], { 0, 0, 4 }), away)
end

local function drape(me)
    me.take_up(table_side, "drape", "hand_rest")
    me.wait(0.4)
    lead(me, lashes(me))
    for _ = 2, most_rounds do
        local left = me.notices(function() return lashes(me) end)
        if not left or #left == 0 then break end
        lead(me, left)
    end
    me.go(table_side, away)
    me.put_down()
end

local function open_lids(me)
    me.take_up(table_side, "speculum", "hand_rest")
    me.wait(0.4)
    local pupil = me.see().landmarks.pupil.position
    me.go({ pupil[1], pupil[2], pupil[3] + 5 }, away)
    me.go({ pupil[1], pupil[2], pupil[3] + 3.6 }, speed)
    me.jaw(1)
    me.wait(0.8)
    me.go({ pupil[1], pupil[2], pupil[3] + 8 }, speed)
    me.go(table_side, away)
    me.put_down()
end

-- Each position until the panel, and the drops at the tip, show that it does what it is to do.
local function test_pedal(me)
    me.take_up(table_side, "phaco", "hand_rest")
    me.wait(0.4)
    for position = 1, 3 do
        me.pedal(position)
        me.wait_until(function(seen) return seen.landmarks.drip ~= nil end, 3)
        me.wait(me.about(0.6))
    end
    me.pedal(0)
    me.wait(0.5)
    me.put_down()
end

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.pupil and seen.landmarks.hand_rest end, 5)
    centring.centre(me)
    drape(me)
    open_lids(me)
    test_pedal(me)
    me.request("Settings confirmed")
    me.wait(1)
    me.request("Side confirmed")
    me.wait(1)
    me.request("Ready to begin")
end
