-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon takes a quarter onto the tip and lets go of it: into the far right quarter with a touch of
-- ultrasound, pedal to 2 until the panel shows that the tip is shut, then pedal to 1, and away only when the vacuum is
-- gone. It sees the picture and the machine's panel only: no measure, no event, no score. [mm]

local sculpting = require "surgeons.sculpting"
local vector = require "surgeons.vector"

local speed = 4.0
local bury_speed, press_speed = 1.5, 1.0
local built_up = 220   -- on the panel [mmHg]
local gone = 15
local tries = 4
local trench = 0.55    -- where to begin, of the way from the middle to the piece
local plate = 1.6      -- height over the posterior capsule that the tip keeps

local function far_right(seen)
    local found, most
    for i = 1, 4 do
        local mark = seen.landmarks["fragment_" .. i]
        local side = mark and mark.position[1] + mark.position[2]
        if mark and (not most or side > most) then found, most = mark, side end
    end
    return found
end

-- The capsule or the iris in the tip, or a chamber that bounces: pedal up.
local function alarm(seen) return seen.landmarks.capsule_folds or seen.landmarks.iris_caught or nil end

local function shut(seen) return seen.vacuum_mmhg > built_up end

local function let_go(me)
    me.pedal(1)
    me.wait_until(function(seen) return seen.vacuum_mmhg < gone end, 4)
    me.wait(0.5)
end

local function grasp(me, eye)
    local piece = far_right(me.see())
    if not piece then return false end
    local floor = eye.front[3] - sculpting.lens_thickness + plate
    local place = { piece.position[1], piece.position[2], math.max(piece.position[3], floor) }
    local middle = { eye.pupil[1], eye.pupil[2], place[3] + 0.3 }
    me.pedal(1)
    me.go({ middle[1], middle[2], eye.front[3] + 0.5 }, speed)
    me.go(vector.mix(middle, place, trench), speed)
    me.pedal(3)
    if me.go(vector.mix(middle, place, 0.9), bury_speed, alarm) then return false end
    me.pedal(2)
    if me.go(vector.mix(middle, place, 1.2), press_speed, alarm, shut) == "reached" then return true end
    return me.wait_until(shut, 2)
end

return function(me)
    local eye = sculpting.look_around(me)
    sculpting.enter(me, eye, sculpting.plan_groove(eye))
    me.wait(1.5)  -- the chamber deepens
    for _ = 1, tries do
        local held = grasp(me, eye)
        if held then me.wait(0.5) end
        let_go(me)
        if held then break end
    end
    sculpting.leave(me, eye)
end
