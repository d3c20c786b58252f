-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does with an eye that is too hard: presses the lip of the side port aside with a spatula
-- for as long as viscoelastic is known to come, and once more. It sees the picture, no measure, event or score. [mm]

local instruments = require "surgeons.instruments"
local vector = require "surgeons.vector"

local speed, careful = 6.0, 2.5
local through, down = 0.2, 0.3   -- of the side port's lip: how far in, and how deep
local aside = 0.9                -- pressed, along the limbus
local press_s = 3.5
local times = 2

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.side_port ~= nil end, 5)
    me.wait(1)
    local port = me.see().landmarks.side_port.position
    local place = vector.add(port, vector.scale(instruments.way_out(port), -through))
    me.left.take_up(instruments.outside(port), "spatula", "side_port")
    me.wait(0.5)
    me.left.go(place, speed)
    me.left.go(vector.add(place, { 0, 0, -down }), careful)
    for _ = 1, times do
        me.left.go(vector.add(place, { 0, aside, -down }), careful)
        me.wait(me.about(press_s))
        me.left.go(vector.add(place, { 0, 0, -down }), careful)
        me.wait(0.3)
    end
    me.left.go(place, careful)
    me.left.go(instruments.outside(port), speed)
    me.left.put_down()
    me.wait(2)
end
