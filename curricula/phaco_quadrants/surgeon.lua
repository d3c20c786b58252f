-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon takes out the quarters of a nucleus: ultrasound buries the tip in a quarter, the pedal goes back
-- to 2 while the tip presses on until vacuum holds, what is held is drawn to the middle of the pupil and emulsified
-- there. What is too small to be held is followed and eaten where it lies.
-- All groups follow this plan; what they make of it depends on their hands, eyes and attention
-- (scripts/surgeons/groups.lua). It sees the picture and the machine's panel only: no measure, no event, no score. [mm]

local sculpting = require "surgeons.sculpting"
local vector = require "surgeons.vector"

local approach_speed = 6.0
local sweep_speed = 4.0
local press_speed = 1.0         -- with vacuum, until it holds
local draw_speed = 2.0          -- with a piece on the tip
local radii = { 1.2, 2.0, 2.8 }
local depths = { 0.6, 1.1, 1.6, 2.1, 2.6, 3.1 }
local held_vacuum = 200         -- on the panel [mmHg]
local small = 0.3               -- radius of a piece that is left
local edge = 3.9                -- of where the tip may go, from the middle of the pupil
local plate = 1.0               -- that the tip keeps from where the posterior capsule must be
local back_radius = 6.0         -- of the posterior capsule
local sleeve_room = 0.75        -- that the middle of the shaft keeps from the edge of the pupil
local until_s = 430

local function across(eye, place)
    return math.sqrt((place[1] - eye.pupil[1]) ^ 2 + (place[2] - eye.pupil[2]) ^ 2)
end

-- Where the tip may work: clear of capsule and cornea, with the shaft clear of the iris.
local function allowed(eye, place)
    local off = across(eye, place)
    local floor = eye.front[3] - sculpting.lens_thickness + off * off / (2 * back_radius) + plate
    if off > edge or place[3] < floor or place[3] > eye.front[3] + 0.3 then return false end
    local pupil_z = eye.front[3] - 0.4
    if place[3] > pupil_z then return off < eye.pupil_radius - sleeve_room end
    local share = (pupil_z - place[3]) / (eye.wound[3] - place[3])
    return across(eye, vector.mix(place, eye.wound, share)) < eye.pupil_radius - sleeve_room
end

-- The same place, or the first one on the way from it to the middle of the lens where the tip may work.
local function within(eye, place)
    local middle = { eye.pupil[1], eye.pupil[2] + 0.5, eye.front[3] - 1.8 }
    for i = 0, 19 do
        local nearer = vector.mix(place, middle, i / 20)
        if allowed(eye, nearer) then return nearer end
    end
    return middle
end

local function pieces(seen)
    local list = {}
    for i = 1, 8 do
        local name = "fragment_" .. i
        local mark, near = seen.landmarks[name], seen.landmarks[name .. "_near"]
        if near and not (mark and mark.size < small) then
            list[#list + 1] = { position = (mark or near).position, near = near.position, size = mark and mark.size }
        end
    end
    return list
end

local function best(list, cost)
    local found, least
    for _, piece in ipairs(list) do
        local value = cost(piece)
        if value and (not least or value < least) then found, least = piece, value end
    end
    return found, least
end

-- Where a piece is emulsified best: in the middle, in the plane of the iris.
local function safe_place(eye) return { eye.pupil[1], eye.pupil[2], eye.front[3] - 1.5 } end

-- The piece that was worked at last, else the nearest to the middle, rather the far ones: the mouth looks away from the
-- wound.
local function choose(eye, seen, last)
    local list = pieces(seen)
    local same, shift = best(list, function(piece) return last and vector.distance(piece.position, last) end)
    if same and shift < 1.5 then return same end
    local safe = safe_place(eye)
    return best(list, function(piece) return vector.distance(piece.near, safe) - 0.2 * piece.position[2] end)
end

-- What makes a surgeon let go: the capsule or the iris in the tip, or a hole.
local function alarm(seen)
    local marks = seen.landmarks
    if marks.capsule_folds then return "capsule" end
    if marks.capsule_hole then return "hole" end
    return marks.iris_caught and "iris" or nil
end

local function held(seen) return seen.vacuum_mmhg > held_vacuum end
local function lost(seen) return not held(seen) end
local function into(eye, place) return vector.unit(vector.sub(place, eye.wound)) end

-- A movement that danger ends; what it was meant to end with is no danger.
local function go(me, place, speed, reached)
    local reason = me.go(place, speed, alarm, reached)
    return reason ~= "reached" and reason or nil
end

-- Pedal up, stay until it is free, then out of the way.
local function let_go(me, eye)
    me.pedal(1)
    me.wait_until(function(seen) return not seen.landmarks.capsule_folds and not seen.landmarks.iris_caught end, 2)
    local tip = me.tip()
    me.go({ tip[1], tip[2], sculpting.surface(eye, across(eye, tip)) + 0.5 }, approach_speed)
    me.wait(0.5)
end

-- What is on the tip comes to the middle, and is emulsified there as long as it is held.
local function draw(me, eye)
    me.pedal(2)
    local reason = go(me, safe_place(eye), draw_speed, lost)
    if reason then return reason end
    me.pedal(3)
    me.wait_until(function(seen) return alarm(seen) or lost(seen) end, 4)
    return alarm(me.see())
end

-- Once round at a height, with ultrasound: what the tip meets is emulsified, and pieces turn past it.
local function circle(me, eye, radius, z)
    local function path(share)
        local angle = 2 * math.pi * (share + 0.25)
        return within(eye, { eye.pupil[1] + radius * math.cos(angle), eye.pupil[2] + radius * math.sin(angle), z })
    end
    me.pedal(2)
    local reason = go(me, path(0), approach_speed)
    if reason then return reason end
    me.pedal(3)
    return me.follow(path, me.about(sweep_speed), alarm)
end

local function nearest_of(seen, position)
    return best(pieces(seen), function(piece) return vector.distance(piece.position, position) end)
end

-- From the middle to a piece with vacuum, pressed on until it is held, and back to the middle with it. A touch of
-- ultrasound where vacuum alone finds no hold.
local function fetch(me, eye, position)
    me.pedal(2)
    local reason = go(me, safe_place(eye), approach_speed)
    if reason then return reason end
    me.wait(0.3)
    local piece = nearest_of(me.see(), position)
    if not piece then return nil end
    for _, extra in ipairs { 0.4, 1.0 } do
        local way = vector.unit(vector.sub(piece.near, me.tip()))
        local function at(distance) return within(eye, vector.add(piece.near, vector.scale(way, distance))) end
        reason = go(me, at(-0.3), approach_speed) or go(me, at(extra), press_speed, held)
        if reason then return reason end
        if me.wait_until(held, 0.4) then return draw(me, eye) end
        me.pedal(3)
        me.wait(0.15)
        me.pedal(2)
    end
    return nil
end

return function(me)
    local eye = sculpting.look_around(me)
    sculpting.enter(me, eye, sculpting.plan_groove(eye))
    me.wait(1.5)  -- the chamber deepens
    local turn = 0
    while me.time_s() < until_s and #pieces(me.see()) > 0 do
        local reason
        if turn < #radii * #depths then
            local radius = radii[turn % #radii + 1]
            local depth = depths[turn // #radii % #depths + 1]
            reason = circle(me, eye, radius, eye.front[3] - depth)
        else
            local list = pieces(me.see())
            reason = fetch(me, eye, list[turn % #list + 1].position)
        end
        turn = turn + 1
        if reason then
            let_go(me, eye)
            if reason == "hole" then break end
        end
    end
    sculpting.leave(me, eye)
end
