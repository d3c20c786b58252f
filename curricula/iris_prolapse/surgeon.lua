-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does who sees iris in the wound: presses the lip of the side port aside with a spatula until
-- the eye must be soft, then strokes over the outer lip of the main wound until the iris is gone. It sees the picture
-- only: no measure, no event, no score. [mm]

local instruments = require "surgeons.instruments"
local vector = require "surgeons.vector"

local speed, careful = 6.0, 2.5
local through, down = 0.2, 0.4   -- of the side port's lip: how far in, and how deep
local aside = 1.0                -- pressed, along the limbus
local press_s = 2.5
local over = 0.12                 -- height over the outer lip
local half = 1.2                  -- of a stroke
local strokes, rounds = 8, 3

local function out_of_wound(seen) return seen.landmarks.iris_prolapse end

local function let_down(me)
    local port = me.see().landmarks.side_port.position
    local inward = vector.scale(instruments.way_out(port), -through)
    local place = vector.add(port, inward)
    me.left.take_up(instruments.outside(port), "spatula", "side_port")
    me.wait(0.5)
    me.left.go(place, speed)
    me.left.go(vector.add(place, { 0, 0, -down }), careful)
    me.left.go(vector.add(place, { 0, aside, -down }), careful)
    me.wait(me.about(press_s))
    me.left.go(place, careful)
    me.left.go(instruments.outside(port), speed)
    me.left.put_down()
end

local function stroke(me)
    local mark = out_of_wound(me.see())
    if not mark then return end
    local lip = vector.add(mark.position, { 0, -0.1, over })
    local left, right = vector.add(lip, { -half, 0, 0 }), vector.add(lip, { half, 0, 0 })
    me.left.take_up(vector.add(left, { 0, -2, 1 }), "spatula", "incision")
    me.wait(0.4)
    me.left.go(left, speed)
    for number = 1, strokes do
        me.left.go(number % 2 == 1 and right or left, careful)
        if not out_of_wound(me.see()) then break end
    end
    me.left.go(vector.add(me.left.tip(), { 0, -2, 1 }), speed)
    me.left.put_down()
end

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.side_port ~= nil end, 5)
    me.wait(1)
    for _ = 1, rounds do
        if not me.notices(out_of_wound) then break end
        let_down(me)
        stroke(me)
        me.wait(1)
    end
    me.wait(1)
end
