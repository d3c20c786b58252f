-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon takes out the quarters of a nucleus: bury the tip in a piece, let the vacuum hold it, draw it
-- to the middle of the pupil, emulsify it there, and let the pedal up before the capsule follows. All groups follow
-- this plan; what they make of it depends on their hands, eyes and attention (scripts/surgeons/groups.lua). It sees the
-- picture and the machine's panel only: no measure, no event, no score. [mm]

local sculpting = require "surgeons.sculpting"
local vector = require "surgeons.vector"

local free_speed = 6.0
local bury_speed = 1.6          -- into a piece, with a touch of ultrasound
local bury_depth = 1.2          -- of the tip in a piece
local bury_power = 2.5          -- pedal
local eat_power = 3.0
local draw_speed = 1.5          -- with a piece on the tip
local held_vacuum = 0.6         -- share of the highest vacuum seen so far at which a piece is held
local wait_for_hold = 2.5       -- seconds of patience
local over_lens = 1.0
local safe_height = 0.4         -- of the tip over the lens equator while emulsifying
local small = 0.55              -- radius of a piece that is left for the last

local function height(eye, place)
    return sculpting.surface(eye, math.sqrt((place[1] - eye.pupil[1]) ^ 2 + (place[2] - eye.pupil[2]) ^ 2))
end

-- The largest piece that can be seen.
local function next_piece(seen)
    return seen.landmarks.fragment_1
end

-- What makes a surgeon let go: the capsule or the iris in the tip, or a hole.
local function alarm(seen)
    local marks = seen.landmarks
    if marks.capsule_folds then return "capsule" end
    if marks.capsule_hole then return "hole" end
    if marks.iris_caught then return "iris" end
    return nil
end

-- Pedal up, stay until it is free, then out of the way.
local function let_go(me, eye)
    me.pedal(1)
    me.wait_until(function(seen) return not seen.landmarks.capsule_folds and not seen.landmarks.iris_caught end, 2)
    local tip = me.tip()
    me.go({ tip[1], tip[2], height(eye, tip) + over_lens }, free_speed)
end

local function over(eye, place) return { place[1], place[2], height(eye, place) + over_lens } end

-- The tip into the piece from the near side, along its shaft. True when the panel says that it is held.
local function bury(me, eye, piece, state)
    local place = piece.position
    local way = vector.unit(vector.sub(eye.wound, place))
    local start = vector.add(place, vector.scale(way, 1.4 + piece.size))
    start[3] = math.max(start[3], height(eye, start) + 0.4)
    me.pedal(1)
    me.go(start, free_speed)
    me.pedal(bury_power)
    local goal = vector.add(place, vector.scale(way, -math.min(bury_depth, piece.size) * 0.2))
    goal[3] = math.max(goal[3], eye.front[3] - 2.9)
    local reason = me.go(goal, me.about(bury_speed), alarm)
    if reason then return nil, reason end
    me.pedal(2)
    local held = me.wait_until(function(seen)
        state.most = math.max(state.most, seen.vacuum_mmhg)
        return alarm(seen) or seen.vacuum_mmhg > held_vacuum * state.vacuum
    end, wait_for_hold)
    return held, alarm(me.see())
end

-- Draws what is on the tip to the middle of the pupil and emulsifies it there until nothing is on the tip any more.
local function eat(me, eye, state)
    local safe = { eye.pupil[1], eye.pupil[2] - 0.3, eye.front[3] - 1.9 + safe_height }
    local reason = me.go(safe, me.about(draw_speed), alarm)
    if reason then return reason end
    me.pedal(eat_power)
    local started = me.time_s()
    local free_since
    me.wait_until(function(seen)
        reason = alarm(seen)
        if reason then return true end
        local held = seen.vacuum_mmhg > 0.35 * state.vacuum
        if held then free_since = nil else free_since = free_since or me.time_s() end
        return me.time_s() - started > 25 or (free_since and me.time_s() - free_since > 0.8)
    end, 30)
    me.pedal(1)
    return reason
end

return function(me)
    local eye = sculpting.look_around(me)
    local groove = sculpting.plan_groove(eye)
    local state = { vacuum = 350, most = 0 }
    sculpting.enter(me, eye, groove)
    me.wait(1.5)  -- the chamber deepens
    for _ = 1, 60 do
        local seen = me.see()
        if seen.landmarks.capsule_hole or me.time_s() > 480 then break end
        local piece = next_piece(seen)
        if not piece or piece.size < small then break end
        local held, reason = bury(me, eye, piece, state)
        if held and not reason then reason = eat(me, eye, state) end
        if reason then
            let_go(me, eye)
            if reason == "hole" then break end
        else
            me.pedal(1)
            local tip = me.tip()
            me.go(over(eye, tip), free_speed)
        end
        me.wait(0.5)
    end
    sculpting.leave(me, eye)
end
