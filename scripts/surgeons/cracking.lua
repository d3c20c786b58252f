-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon cracks a nucleus along a groove: both tips to its floor near one of its ends, apart, back
-- together, the same near the other end; then a look, and again where the halves still hang together. Words that plans
-- share. They see the picture only: no measure, no event, no score. [mm]

local sculpting = require "surgeons.sculpting"
local spatula = require "surgeons.spatula"
local vector = require "surgeons.vector"

local cracking = {}

local hover = spatula.clear_of_lens
local out_of_danger = 1.3     -- height over the lens to which the tips are lifted when something went wrong
local escape_speed = 14.0
local down_speed = 4.0        -- into the groove [mm/s]
local part_speed = 0.9        -- of each tip
local part_way = 1.5          -- of each tip
local beside = 0.30           -- of each tip from the middle of the groove before they part
local over_floor = 0.45       -- of the tips before they part
local deeper = 0.15           -- the tips the next time, after the nucleus was pushed
local seen_bridge = 0.35      -- size of a bridge that is worth going back for
local small_bridge = 0.9      -- the same, when many tries did not part it
local many_tries = 6
local look_s = 3.3
local back_radius = 6.0       -- of the back of the lens
local safe_distance = 0.4     -- of a tip from it
local iris_margin = 0.05      -- of the phaco tip's edge from the pupil's at which to stop
local tip_radius = 0.45

--- Shares of a groove's half length at which the tips go down, far from the surgeon and near; nearer still the shaft
--- would lie on the iris.
cracking.along_one_groove = { [1] = { 0.58, 0.7, 0.45 }, [-1] = { 0.48, 0.38, 0.55 } }

local function over(eye, place, by) return { place[1], place[2], spatula.height(eye, place) + by } end

-- The groove as it seems after looking for a moment: its middle, its direction (away from the surgeon), the direction
-- across it (to the right), half its length; nil when it cannot be made out.
local function look_at_groove(me, name)
    local from, to, count = { 0, 0, 0 }, { 0, 0, 0 }, 0
    for _ = 1, 5 do
        me.wait(0.1)
        local marks = me.see().landmarks
        local start, finish = marks[name .. "_start"], marks[name .. "_end"]
        if start and finish then
            local a, b = start.position, finish.position
            if a[2] > b[2] then a, b = b, a end
            from, to, count = vector.add(from, a), vector.add(to, b), count + 1
        end
    end
    if count == 0 then return nil end
    from, to = vector.scale(from, 1 / count), vector.scale(to, 1 / count)
    local way = vector.sub(to, from)
    local length = math.sqrt(way[1] * way[1] + way[2] * way[2])
    local along = { way[1] / length, way[2] / length, 0 }
    return { middle = vector.mix(from, to, 0.5), along = along, across = { along[2], -along[1], 0 },
        half_length = 0.5 * length }
end

-- A place in the groove: t along it from its middle, s across it, at a height.
local function place_in(groove, t, s, z)
    local place = vector.add(groove.middle, vector.add(vector.scale(groove.along, t), vector.scale(groove.across, s)))
    place[3] = z
    return place
end

-- Where the halves still hang together, if that is worth another try.
local function bridge_seen(seen, state, tries)
    local bridge = seen.landmarks[state.bridge]
    return bridge and bridge.size > (tries < many_tries and seen_bridge or small_bridge) and bridge or nil
end

-- Square of the distance from the middle of the pupil.
local function off_middle(eye, place)
    return (place[1] - eye.pupil[1]) ^ 2 + (place[2] - eye.pupil[2]) ^ 2
end

-- A tip seems to be close to where the posterior capsule must be.
local function too_deep(eye, tool)
    local back = eye.front[3] - sculpting.lens_thickness + off_middle(eye, tool.position) / (2 * back_radius)
    return tool.position[3] < back + safe_distance
end

-- What makes a surgeon stop.
local function alarm(eye)
    local pushed = sculpting.runs_away(eye)
    return function(seen)
        if seen.landmarks.capsule_hole then return "hole" end
        local phaco, other = seen.tools.phaco, seen.tools.spatula
        if too_deep(eye, phaco) or too_deep(eye, other) then return "deep" end
        local farthest = eye.pupil_radius - tip_radius - iris_margin
        if off_middle(eye, phaco.position) > farthest ^ 2 then return "iris" end
        return pushed(seen)
    end
end

-- Both tips at once to two places. Returns the reason why they stopped.
local function both(me, right, left, speed, watch, reached)
    local from_right, from_left = me.tip(), me.left.tip()
    me.begin(function(share) return vector.mix(from_right, right, share) end, speed)
    me.left.begin(function(share) return vector.mix(from_left, left, share) end, speed)
    return me.together(watch, reached)
end

local function lift(me, eye, by, speed)
    me.pedal(1)
    both(me, over(eye, me.tip(), by), over(eye, me.left.tip(), by), speed)
end

-- How high the floor of the groove under the phaco tip seems to be.
local function look_at_floor(me)
    local sum, count = 0, 0
    for _ = 1, 4 do
        me.wait(0.1)
        local mark = me.see().landmarks.surface_at_tip
        if mark then sum, count = sum + mark.position[3], count + 1 end
    end
    return count > 0 and sum / count or nil
end

-- Both tips down at t, apart, and back together. Returns what went wrong.
local function part_at(me, eye, groove, t, state)
    local function places(s, z) return place_in(groove, t, s, z), place_in(groove, t, -s, z) end
    local function go(s, z, speed, watch, reached)
        local right, left = places(s, z)
        return both(me, right, left, speed, watch, reached)
    end
    local top = spatula.height(eye, groove.middle) + hover
    go(beside, top, sculpting.free_speed)
    local floor = look_at_floor(me)
    if not floor then return nil end
    local watch = alarm(eye)
    local z = floor + over_floor - state.deeper
    local reason = go(beside, z, down_speed, watch)
        or go(beside + part_way, z, me.about(part_speed), watch, function(seen)
            return not bridge_seen(seen, state, 0)
        end)
    if reason == "reached" then reason = nil end
    if reason then
        lift(me, eye, out_of_danger, escape_speed)
        sculpting.let_come_back(me, eye)
        if reason == "pushing" then state.deeper = state.deeper + deeper end
        if reason == "deep" then state.deeper = state.deeper - deeper end
        return reason
    end
    me.wait(0.2)
    go(beside, z, down_speed)
    lift(me, eye, hover, sculpting.free_speed)
    return nil
end

-- Where to go down next: near the end of the groove on whose side the halves hang together; near the other end than
-- before when they hang together in the middle.
local function next_end(groove, bridge, last)
    if bridge then
        local t = vector.dot(vector.sub(bridge.position, groove.middle), groove.along)
        if math.abs(t) > 0.25 * groove.half_length then return t > 0 and 1 or -1 end
    end
    return -last
end

-- Tips over the lens, and a look at the whole groove. What is seen to hang together calls a surgeon back.
local function look(me, eye, state)
    lift(me, eye, hover, sculpting.free_speed)
    local function calls_back(seen) return bridge_seen(seen, state, state.tries) end
    return me.go(vector.add(me.tip(), { 0, 0, 0.1 }), 0.1 * 1.875 / look_s, calls_back) ~= nil
end

-- Near both ends of the groove, and on where it hangs together. True when there is nothing more to do here.
local function crack(me, eye, state)
    repeat
        local groove = look_at_groove(me, state.groove)
        if not groove or me.time_s() > state.until_s then return true end
        local side = state.tries == 1 and -state.last
            or next_end(groove, me.see().landmarks[state.bridge], state.last)
        local places = state.places[side]
        state.at[side] = state.at[side] % #places + 1
        local reason = part_at(me, eye, groove, side * places[state.at[side]] * groove.half_length, state)
        if reason == "hole" then return true end
        state.tries, state.last = state.tries + 1, side
    until state.tries > 1 and not bridge_seen(me.see(), state, state.tries)
    return false
end

--- Cracks along a groove, with both tips over the lens before and after. groove, bridge: names of their landmarks;
--- places: one of the above; until_s: when to give up.
function cracking.crack(me, eye, groove, bridge, places, until_s)
    local state = { groove = groove, bridge = bridge, places = places, until_s = until_s, deeper = 0, tries = 0,
        last = -1, at = { [-1] = 0, [1] = 0 } }
    repeat until crack(me, eye, state) or not look(me, eye, state)
end

return cracking
