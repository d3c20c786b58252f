-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon takes out the quarters of a nucleus: the tip goes into the tissue that is nearest, vacuum holds
-- it, and what is held and at the edge of where one may work is drawn to the middle of the pupil and emulsified there.
-- All groups follow this plan; what they make of it depends on their hands, eyes and attention
-- (scripts/surgeons/groups.lua). It sees the picture and the machine's panel only: no measure, no event, no score. [mm]

local sculpting = require "surgeons.sculpting"
local vector = require "surgeons.vector"

local approach_speed = 6.0
local eat_speed = 3.2           -- with ultrasound, through tissue [mm/s]
local draw_speed = 2.5          -- with a piece on the tip
local through = 1.6             -- how far a lane goes on behind the tissue that it begins at
local further = 1.2             -- the same along the shaft while vacuum says that a piece is held
local held_vacuum = 150         -- on the panel [mmHg]
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
            list[#list + 1] = { position = (mark or near).position, near = near.position }
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

local function can_reach(eye, piece) return vector.distance(within(eye, piece.near), piece.near) < 0.3 end

-- Where a piece is emulsified best: in the middle, in the plane of the iris.
local function safe_place(eye) return { eye.pupil[1], eye.pupil[2], eye.front[3] - 1.5 } end

-- The piece that was worked at last, while it can be reached; else the nearest to the middle, rather the far ones.
local function choose(eye, seen, last)
    local list = pieces(seen)
    local same, shift = best(list, function(piece) return last and vector.distance(piece.position, last) end)
    if same and shift < 1.5 and can_reach(eye, same) then return same end
    local safe = safe_place(eye)
    return best(list, function(piece)
        return can_reach(eye, piece) and vector.distance(piece.near, safe) - 0.2 * piece.position[2] or nil
    end)
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
    me.wait_until(function(seen) return alarm(seen) or lost(seen) end, 3)
    return nil
end

-- Into the nearest tissue of a piece and on through it, with ultrasound; on along the shaft while vacuum holds it.
local function lane(me, eye, piece)
    local off = vector.sub(piece.near, me.tip())
    local way = vector.unit(off)
    local reason
    if vector.norm(off) > 1.0 then
        me.pedal(2)
        reason = go(me, within(eye, vector.add(piece.near, vector.scale(way, -0.6))), approach_speed)
        if reason then return reason end
    end
    me.pedal(3)
    reason = go(me, within(eye, vector.add(piece.near, vector.scale(way, through))), me.about(eat_speed))
    if reason or lost(me.see()) then return reason end
    local tip = me.tip()
    local on = within(eye, vector.add(tip, vector.scale(into(eye, tip), further)))
    if vector.distance(on, tip) < 0.4 then return draw(me, eye) end
    return go(me, on, me.about(draw_speed), lost)
end

-- Nothing can be worked at where it lies: goes to one piece after the other with vacuum only, and draws what it holds.
local function fetch(me, eye, number)
    me.pedal(2)
    local list = pieces(me.see())
    local piece = list[(number - 1) % math.max(1, #list) + 1]
    if not piece then return nil end
    local way = into(eye, piece.near)
    local place = within(eye, vector.add(piece.near, vector.scale(way, 0.2)))
    local reason = go(me, within(eye, vector.add(place, vector.scale(way, -0.8))), approach_speed)
        or go(me, place, draw_speed)
    if reason then return reason end
    return me.wait_until(held, 0.8) and draw(me, eye) or nil
end

return function(me)
    local eye = sculpting.look_around(me)
    sculpting.enter(me, eye, sculpting.plan_groove(eye))
    me.wait(1.5)  -- the chamber deepens
    local last
    local vain = 0
    while me.time_s() < until_s and vain < 12 do
        local piece = choose(eye, me.see(), last)
        local reason
        if piece then
            vain, last = 0, piece.position
            reason = lane(me, eye, piece)
        else
            vain, last = vain + 1, nil
            reason = fetch(me, eye, vain)
        end
        if reason then
            last = nil
            let_go(me, eye)
            if reason == "hole" then break end
        end
    end
    sculpting.leave(me, eye)
end
