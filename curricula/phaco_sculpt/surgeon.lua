-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon sculpts a cross: a groove, a quarter turn of the nucleus, a second groove, a look at the depth.
-- All groups follow this plan; what they make of it depends on their hands, eyes and attention
-- (scripts/surgeons/groups.lua). The plan sees the picture only: no measure, no event, no score. [mm]

local sculpting = require "surgeons.sculpting"
local spatula = require "surgeons.spatula"
local turning = require "surgeons.turning"
local vector = require "surgeons.vector"

local grooves_seen, off_sight, height = turning.grooves, turning.off_sight, spatula.height
local clear_of_lens, out_of_danger, escape_speed = spatula.clear_of_lens, turning.out_of_danger, turning.escape_speed

local hold_arm = 1.5          -- of the spatula that keeps the lens from turning back
local far_off = 7             -- of the first groove from lying across, at which it is turned back there [deg]
local led = 0.5               -- share of the thickness from which on the second groove leads the tip
local most_corrections = 6
local most_lean = 15          -- of a groove from the line of sight [deg]
local put_right = 0.7         -- share of what it is askew by that the next stroke leans against
local held = 0.48              -- depth of its end then
local shaft_radius = 0.25     -- of the spatula
local surely_below = 0.45     -- the edge of the capsule: less may be a misjudgement
local bend = 2.0               -- by which its shaft lies higher than its end, falling off to the wound 8 mm away
local look_s = 0.8            -- before going on after that
local sound_share = 0.68      -- of the thickness that the groove must seem to have when looked at in the end
local iris_margin = 0.15      -- of the tip's edge from the pupil's at which to stop
local tip_radius = 0.45
local least_flow = 5.0        -- on the panel [ml/min]
local blocked_s = 0.3         -- so long it may stand still

-- Floor of the groove that is being sculpted: the one along the line of sight.
local function floor_ahead(seen)
    for _, groove in ipairs(grooves_seen(seen)) do
        if off_sight(groove.direction) < 40 then return groove.floor end
    end
    return nil
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

-- Over the lens, out of the way of the spatula.
local function rest_phaco(me, eye, groove)
    me.pedal(1)
    local tip = me.tip()
    me.go({ tip[1], tip[2], height(eye, tip) + clear_of_lens }, sculpting.free_speed)
    local place = { groove.x + 0.5, eye.pupil[2] - 0.55 * eye.pupil_radius, 0 }
    place[3] = height(eye, place) + clear_of_lens
    me.go(place, sculpting.free_speed)
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

-- Turns the first groove across the line of sight. `turned`: it has been turned already, and went astray.
local function turn(me, eye, turned)
    turning.rotate(me, eye, function(seen) return first_groove(seen, turned) end, turned)
end

-- Keeps the lens from turning back while the second groove is sculpted: the spatula's end lies in the near arm of the
-- first groove, which now points to the left, against the wall that would come.
local function hold(me, eye)
    local groove = first_groove(me.see(), true)
    if not groove then return end
    local beside = math.max(0, groove.half_width - turning.spatula_radius - 0.1)
    local function place(depth)
        local x = eye.pupil[1] - hold_arm
        return { x, eye.pupil[2] + beside, sculpting.surface(eye, hold_arm) - depth }
    end
    me.left.go(place(-clear_of_lens), sculpting.free_speed)
    me.left.go(place(held), turning.speed)
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
    local off = first.direction % 180 - turning.across
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
            return math.abs(first.direction % 180 - turning.across) > far_off
        end)
        if state.times >= most_corrections or not (astray or (state.lifted and shallow)) then return end
        state.lifted, state.times = false, state.times + 1
        if astray then
            get_clear(me, eye)
            rest_phaco(me, eye, groove)
            spatula.lift(me, eye, clear_of_lens, sculpting.free_speed)
            turn(me, eye, true)
        end
        hold(me, eye)
    end
    local function recover(me, eye)
        if near_rim(eye)(me.see()) then
            spatula.lift(me, eye, out_of_danger, escape_speed)
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
        entry_speed = 6.0, half_width = 0.3 })
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
    spatula.bring(me, eye)
    turn(me, eye)
    hold(me, eye)
    local before, recover = keep_across(groove)
    sculpt(me, eye, groove, 205, before, recover)
    check_depth(me, eye, groove, before, recover)
    spatula.take_away(me, eye)
    sculpting.leave(me, eye)
end
