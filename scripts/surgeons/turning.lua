-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon turns a nucleus with the spatula: its end goes into a groove, away from the middle, and pushes
-- the wall sideways along an arc, so that the lens turns and is not shifted. Words that plans share. They see the
-- picture only: no measure, no event, no score. [mm]

local sculpting = require "surgeons.sculpting"
local spatula = require "surgeons.spatula"
local vector = require "surgeons.vector"

local turning = {}

turning.across = 90           -- direction of a groove that lies across the line of sight [deg]
local near_enough = 4         -- of it that a surgeon is content with [deg]
local comes_back = 6          -- of a turn when the lens is let go: pushed that much further [deg]
local arm = 2.0               -- of the push about the middle of the lens
local engaged = 0.55          -- depth of the spatula's end in the groove
local deeper = 0.15           -- the same, more each time that the lens did not turn
local turn_speed = 2.5        -- of the spatula's end [mm/s]
local out_of_danger = 2.2     -- height over the lens to which a tip is lifted when something went wrong
local escape_speed = 14.0     -- of that lift [mm/s]
turning.spatula_radius = 0.35
turning.speed = turn_speed
turning.out_of_danger, turning.escape_speed = out_of_danger, escape_speed

--- The grooves that can be told apart in the picture, each with its direction: clockwise from away-from-the-surgeon
--- [deg], by the ends that began as its near and its far one.
function turning.grooves(seen)
    local list = {}
    for i = 1, 4 do
        local name = "groove_" .. i
        local from, to = seen.landmarks[name .. "_start"], seen.landmarks[name .. "_end"]
        if from and to then
            local way = vector.sub(to.position, from.position)
            list[#list + 1] = { direction = math.deg(math.atan(way[1], way[2])), half_width = from.size,
                length = vector.norm(way), floor = seen.landmarks[name .. "_floor"] }
        end
    end
    return list
end

--- Angle between a direction and the line of sight, whichever way it points [deg].
function turning.off_sight(direction) return math.abs((direction + 90) % 180 - 90) end

-- A place at a direction [deg, clockwise from away-from-the-surgeon] and depth in the lens, at the arm of the push.
local function at(eye, direction, depth)
    local angle = math.rad(direction)
    local place = { eye.pupil[1] + arm * math.sin(angle), eye.pupil[2] + arm * math.cos(angle), 0 }
    place[3] = spatula.height(eye, place) - depth
    return place
end

-- Its direction as it seems after looking for a moment [deg, 0 to 180 once it has been turned]; nil when it cannot be
-- made out.
local function look_at_groove(me, choose, turned)
    local sum, count = 0, 0
    for _ = 1, 4 do
        me.wait(0.15)
        local groove = choose(me.see())
        if groove then
            local direction = groove.direction
            if turned and direction < 0 then direction = direction + 180 end
            sum, count = sum + direction, count + 1
        end
    end
    return count > 0 and sum / count or nil
end

-- Pushes the groove's wall so that the lens turns from one direction to another [deg].
local function push_round(me, eye, choose, from, to, depth)
    local groove = choose(me.see())
    if not groove then return end
    local play = math.deg(math.asin(math.min(0.6, math.max(0, groove.half_width - turning.spatula_radius) / arm)))
    local ahead = to > from and play or -play
    to = to + (to > from and comes_back or -comes_back)
    me.left.go(at(eye, from, -spatula.clear_of_lens), sculpting.free_speed)
    me.left.go(at(eye, from, depth), sculpting.free_speed)
    local reason = me.left.follow(function(share) return at(eye, from + (to + ahead - from) * share, depth) end,
        me.about(turn_speed), sculpting.runs_away(eye), function(seen)
            local now = choose(seen)
            return now and (now.direction % 180 - to) * ahead > 0 and math.abs(now.direction % 180 - to) < 60
        end)
    if reason == "pushing" then
        spatula.lift(me, eye, out_of_danger, escape_speed)
        sculpting.let_come_back(me, eye)
    else
        spatula.lift(me, eye, spatula.clear_of_lens, sculpting.free_speed)
    end
end

--- Turns a groove across the line of sight. choose: function of what is seen that gives the groove; turned: it has been
--- turned already, and went astray.
function turning.rotate(me, eye, choose, turned)
    local depth, before = engaged, nil
    for _ = 1, turned and 2 or 10 do
        local direction = look_at_groove(me, choose, turned)
        if not direction then return end
        if math.abs(direction - turning.across) < near_enough then return end
        if before and math.abs(direction - before) < 5 then depth = depth + deeper end
        before = direction
        push_round(me, eye, choose, direction, turning.across, depth)
    end
end

return turning
