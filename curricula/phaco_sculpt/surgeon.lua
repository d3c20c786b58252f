-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon sculpts a cross: a groove, a quarter turn of the nucleus, a second groove, a look at the depth.
-- All groups follow this plan; what they make of it depends on their hands, eyes and attention
-- (scripts/surgeons/groups.lua). The plan sees the picture only: no measure, no event, no score. [mm]
--
-- The nucleus is turned with the spatula: its end goes into the groove, away from the middle, and pushes the wall
-- sideways along an arc, so that the lens turns and is not shifted.

local sculpting = require "surgeons.sculpting"
local vector = require "surgeons.vector"

local goal_turn = 90          -- between the grooves [deg]
local near_enough = 4         -- of it that a surgeon is content with [deg]
local comes_back = 6          -- of a turn when the lens is let go: pushed that much further [deg]
local arm = 2.0               -- of the push about the middle of the lens
local hold_arm = 1.5          -- of the spatula that keeps the lens from turning back
local far_off = 7             -- of the first groove from lying across, at which it is turned back there [deg]
local led = 0.5               -- share of the thickness from which on the second groove leads the tip
local most_corrections = 6
local most_lean = 15          -- of a groove from the line of sight [deg]
local put_right = 0.7         -- share of what it is askew by that the next stroke leans against
local held = 0.48              -- depth of its end then
local engaged = 0.55          -- depth of the spatula's end in the groove
local deeper = 0.15           -- the same, more each time that the lens did not turn
local spatula_radius = 0.35
local turn_speed = 2.5        -- of the spatula's end [mm/s]
local shaft_radius = 0.25     -- of the spatula
local surely_below = 0.45     -- the edge of the capsule: less may be a misjudgement
local bend = 2.0               -- by which its shaft lies higher than its end, falling off to the wound 8 mm away
local clear_of_lens = 0.7     -- height over the lens at which nothing touches it
local out_of_danger = 2.2     -- height over the lens to which a tip is lifted when something went wrong
local escape_speed = 14.0     -- of that lift [mm/s]
local look_s = 0.8            -- before going on after that
local sound_share = 0.68      -- of the thickness that the groove must seem to have when looked at in the end
local iris_margin = 0.15      -- of the tip's edge from the pupil's at which to stop
local tip_radius = 0.45
local least_flow = 5.0        -- on the panel [ml/min]
local blocked_s = 0.3         -- so long it may stand still

-- The grooves that can be told apart in the picture, each with its direction: clockwise from away-from-the-surgeon
-- [deg], by the ends that began as its near and its far one.
local function grooves_seen(seen)
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

-- Angle between a direction and the line of sight, whichever way it points [deg].
local function off_sight(direction) return math.abs((direction + 90) % 180 - 90) end

-- Floor of the groove that is being sculpted: the one along the line of sight.
local function floor_ahead(seen)
    for _, groove in ipairs(grooves_seen(seen)) do
        if off_sight(groove.direction) < 40 then return groove.floor end
    end
    return nil
end

local function height(eye, place)
    return sculpting.surface(eye, math.sqrt((place[1] - eye.pupil[1]) ^ 2 + (place[2] - eye.pupil[2]) ^ 2))
end

-- Something went wrong: pedal up, and the tip straight out of the lens.
local function get_clear(me, eye)
    me.pedal(1)
    local tip = me.tip()
    me.go({ tip[1], tip[2], height(eye, tip) + out_of_danger }, escape_speed)
    sculpting.let_come_back(me, eye)
    me.wait(look_s)
end

-- The spatula's shaft comes down on the edge of the opened capsule.
local function near_rim(eye)
    return function(seen)
        local tool, rim = seen.tools.spatula, seen.landmarks.capsulorhexis
        if not tool or not tool.present or not rim then return nil end
        local tip = tool.position
        local off = math.sqrt((tip[1] - eye.pupil[1]) ^ 2 + (tip[2] - eye.pupil[2]) ^ 2)
        if off > rim.size then return nil end
        local far = vector.norm(vector.sub(eye.port, tip))
        local passes = tip[3] + bend + (eye.port[3] - tip[3]) * (rim.size - off) / far
        return passes - shaft_radius < rim.position[3] - surely_below and "rim" or nil
    end
end

-- Ultrasound goes on while the panel shows vacuum and no flow: the mouth is shut, or nothing comes in.
local function blocked()
    local since
    return function(seen)
        local stuck = seen.power > 0.1 and seen.flow_ml_min < least_flow
        since = stuck and (since or seen.time_s) or nil
        return since and seen.time_s - since > blocked_s and "blocked" or nil
    end
end

-- The tip comes too near to the edge of the pupil.
local function near_iris(eye)
    return function(seen)
        local tool = seen.tools.phaco
        if not tool or not tool.present then return nil end
        local off = math.sqrt((tool.position[1] - eye.pupil[1]) ^ 2 + (tool.position[2] - eye.pupil[2]) ^ 2)
        return off > eye.pupil_radius - tip_radius - iris_margin and "iris" or nil
    end
end

local function lift_spatula(me, eye, by, speed)
    local tip = me.left.tip()
    me.left.go({ tip[1], tip[2], height(eye, tip) + by }, speed)
end

-- Over the lens, out of the way of the spatula.
local function rest_phaco(me, eye, groove)
    me.pedal(1)
    local tip = me.tip()
    me.go({ tip[1], tip[2], height(eye, tip) + clear_of_lens }, sculpting.free_speed)
    local place = { groove.x + 0.5, eye.pupil[2] - 0.55 * eye.pupil_radius, 0 }
    place[3] = height(eye, place) + clear_of_lens
    me.go(place, sculpting.free_speed)
end

local function outside_port(eye)
    local across = math.sqrt(eye.port[1] ^ 2 + eye.port[2] ^ 2)
    return { eye.port[1] * (1 + 2 / across), eye.port[2] * (1 + 2 / across), eye.port[3] + 1.0 }
end

local function bring_spatula(me, eye)
    me.left.take_up(outside_port(eye))
    me.wait(0.5)
    me.left.go(eye.port, sculpting.free_speed)
    local place = { eye.pupil[1] - 1.5, eye.pupil[2], 0 }
    place[3] = height(eye, place) + clear_of_lens
    me.left.go(place, sculpting.free_speed)
end

local function take_spatula_away(me, eye)
    lift_spatula(me, eye, clear_of_lens, sculpting.free_speed)
    me.left.go(eye.port, sculpting.free_speed)
    me.left.go(outside_port(eye), sculpting.free_speed)
    me.left.put_down()
end

-- A place at a direction [deg, clockwise from away-from-the-surgeon] and depth in the lens, at the arm of the push.
local function at(eye, direction, depth)
    local angle = math.rad(direction)
    local place = { eye.pupil[1] + arm * math.sin(angle), eye.pupil[2] + arm * math.cos(angle), 0 }
    place[3] = height(eye, place) - depth
    return place
end

-- The first groove: the best one, or, once the lens has been turned and the second was begun, the one that lies across.
local function first_groove(seen, turned)
    if not turned then return grooves_seen(seen)[1] end
    local best
    for _, groove in ipairs(grooves_seen(seen)) do
        if not best or off_sight(groove.direction) > off_sight(best.direction) then best = groove end
    end
    return best
end

-- Its direction as it seems after looking for a moment [deg, 0 to 180 once it has been turned]; nil when it cannot be
-- made out.
local function look_at_groove(me, turned)
    local sum, count = 0, 0
    for _ = 1, 4 do
        me.wait(0.15)
        local groove = first_groove(me.see(), turned)
        if groove then
            local direction = groove.direction
            if turned and direction < 0 then direction = direction + 180 end
            sum, count = sum + direction, count + 1
        end
    end
    return count > 0 and sum / count or nil
end

-- Pushes the groove's wall so that the lens turns from one direction to another [deg].
local function push_round(me, eye, from, to, depth, turned)
    local groove = first_groove(me.see(), turned)
    if not groove then return end
    local play = math.deg(math.asin(math.min(0.6, math.max(0, groove.half_width - spatula_radius) / arm)))
    local ahead = to > from and play or -play
    to = to + (to > from and comes_back or -comes_back)
    me.left.go(at(eye, from, -clear_of_lens), sculpting.free_speed)
    me.left.go(at(eye, from, depth), sculpting.free_speed)
    local reason = me.left.follow(function(share) return at(eye, from + (to + ahead - from) * share, depth) end,
        me.about(turn_speed), sculpting.runs_away(eye), function(seen)
            local now = first_groove(seen, turned)
            return now and (now.direction % 180 - to) * ahead > 0 and math.abs(now.direction % 180 - to) < 60
        end)
    if reason == "pushing" then
        lift_spatula(me, eye, out_of_danger, escape_speed)
        sculpting.let_come_back(me, eye)
    else
        lift_spatula(me, eye, clear_of_lens, sculpting.free_speed)
    end
end

-- Turns the first groove across the line of sight. `turned`: it has been turned already, and went astray.
local function rotate(me, eye, turned)
    local depth, before = engaged, nil
    for _ = 1, turned and 2 or 10 do
        local direction = look_at_groove(me, turned)
        if not direction then return end
        if math.abs(direction - goal_turn) < near_enough then return end
        if before and math.abs(direction - before) < 5 then depth = depth + deeper end
        before = direction
        push_round(me, eye, direction, goal_turn, depth, turned)
    end
end

-- Keeps the lens from turning back while the second groove is sculpted: the spatula's end lies in the near arm of the
-- first groove, which now points to the left, against the wall that would come.
local function hold(me, eye)
    local groove = first_groove(me.see(), true)
    if not groove then return end
    local beside = math.max(0, groove.half_width - spatula_radius - 0.1)
    local function place(depth)
        local x = eye.pupil[1] - hold_arm
        return { x, eye.pupil[2] + beside, sculpting.surface(eye, hold_arm) - depth }
    end
    me.left.go(place(-clear_of_lens), sculpting.free_speed)
    me.left.go(place(held), turn_speed)
end

-- The next stroke of the first groove follows it as it lies now: the lens turns a little under each.
local function follow(groove)
    return function(me)
        for _, seen in ipairs(grooves_seen(me.see())) do
            if off_sight(seen.direction) < 40 and seen.length > 2 then
                local off = me.towards((seen.direction + 90) % 180 - 90)
                groove.lean = math.tan(math.rad(math.max(-most_lean, math.min(most_lean, off))))
                return
            end
        end
    end
end

-- The next stroke goes across the first groove as that lies now, and beyond by what the second one is off that.
local function lean_across(me, groove, seen, first)
    local off = first.direction % 180 - goal_turn
    for _, second in ipairs(grooves_seen(seen)) do
        if off_sight(second.direction) < 40 then
            local askew = off - ((second.direction + 90) % 180 - 90)
            off = off + put_right * (me.notices(function() return askew end) or 0)
            break
        end
    end
    off = me.towards(off)
    groove.lean = math.tan(math.rad(math.max(-most_lean, math.min(most_lean, off))))
end

-- What a surgeon does before each stroke of the second groove: while it is shallow, the first is kept across; a spatula
-- that was lifted is put back, unless it lay on the capsule too often.
local function keep_across(groove)
    local state = { lifted = false, times = 0 }
    local function before(me, eye)
        local seen = me.see()
        local first = first_groove(seen, true)
        if first then lean_across(me, groove, seen, first) end
        local shallow = sculpting.seen_share(eye, floor_ahead(seen)) < led
        local astray = first and shallow and me.notices(function()
            return math.abs(first.direction % 180 - goal_turn) > far_off
        end)
        if state.times >= most_corrections or not (astray or (state.lifted and shallow)) then return end
        state.lifted, state.times = false, state.times + 1
        if astray then
            get_clear(me, eye)
            rest_phaco(me, eye, groove)
            lift_spatula(me, eye, clear_of_lens, sculpting.free_speed)
            rotate(me, eye, true)
        end
        hold(me, eye)
    end
    local function recover(me, eye)
        if near_rim(eye)(me.see()) then
            lift_spatula(me, eye, out_of_danger, escape_speed)
            state.lifted = true
        end
        get_clear(me, eye)
    end
    return before, recover
end

local function sculpt(me, eye, groove, until_s, before, recover, depth)
    local iris, rim, stuck = near_iris(eye), near_rim(eye), blocked()
    sculpting.sculpt(me, eye, groove, { depth = depth, until_s = until_s, deep_enough = 0.80, surely_deep = 0.69,
        thin = 0.08, floor = floor_ahead, recover = recover or get_clear, pushed = 0.3, before = before,
        also = function(seen) return iris(seen) or rim(seen) or stuck(seen) end, return_height = 0.35,
        entry_speed = 4.0, half_width = 0.3 })
end

local function shallow(eye)
    return function(seen) return sculpting.seen_share(eye, floor_ahead(seen)) < sound_share end
end

-- Tip over the lens, pedal at irrigation: is the groove deep enough? If it does not seem so, it is deepened.
local function check_depth(me, eye, groove, before, recover)
    for _ = 1, 3 do
        me.pedal(1)
        local tip = me.tip()
        me.go({ tip[1], tip[2], height(eye, tip) + clear_of_lens }, sculpting.free_speed)
        me.wait(2.2)
        if not me.notices(shallow(eye)) then return end
        local floor = floor_ahead(me.see())
        local depth = floor and sculpting.surface(eye, floor.position[2]) - floor.position[3] or 0
        sculpt(me, eye, groove, me.time_s() + 30, before, recover, math.max(0, depth - 0.3))
    end
end

return function(me)
    local eye = sculpting.look_around(me)
    local groove = sculpting.plan_groove(eye)
    sculpting.enter(me, eye, groove)
    sculpt(me, eye, groove, 90, follow(groove))
    rest_phaco(me, eye, groove)
    bring_spatula(me, eye)
    rotate(me, eye)
    hold(me, eye)
    local before, recover = keep_across(groove)
    sculpt(me, eye, groove, 205, before, recover)
    check_depth(me, eye, groove, before, recover)
    take_spatula_away(me, eye)
    sculpting.leave(me, eye)
end
